#pragma once

#include "ui/bridge/snapshot.h"
#include "ui/models/bar_text.h"
#include "ui/models/figures.h"
#include "ui/models/table_rows.h"
#include "ui/models/tile_text.h"

namespace leadline::ui {

// A snapshot in words. A figure that the engine makes of a feed is as old as the older of the two, and takes
// the worse state; a figure without feed is absent.

/// The VEHICLE panel. Speed in m/s.
[[nodiscard]] OwnDataText vehicle_text(const Snapshot& snapshot, PositionFormat format = PositionFormat::dm);
/// The SHIP panel. Speed in kn; no depth unless a sensor of hers gives one.
[[nodiscard]] OwnDataText ship_text(const Snapshot& snapshot, PositionFormat format = PositionFormat::dm);
[[nodiscard]] SourcesText sources_text(const Snapshot& snapshot);
/// Ship to vehicle, vehicle to each target, ship to each target: the geodesic, its true bearing, and with the
/// difference of depths (the ship's is 0) the slant range.
[[nodiscard]] RangesText ranges_text(const Snapshot& snapshot);

/// Of a live recording the caller fills `outputs`; in replay they are off.
[[nodiscard]] TopBarText top_bar_text(const Snapshot& snapshot);
/// live: unacknowledged all of them; who acknowledges keeps that.
[[nodiscard]] AlertBarText alert_bar_text(const Snapshot& snapshot);
/// "USBL and DVL", "DVL only, σ grows".
[[nodiscard]] const char* words_of(Mode mode);

}  // namespace leadline::ui
