#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/flow/decoder.h"
#include "core/types/option_key.h"
#include "core/types/result.h"

namespace leadline::decode {

/// The keys a [[source]] with decoder = "table" has besides the common ones.
struct TableOptions {
  std::string separator = ",";
  std::int64_t skip_lines = 0;
  std::string comment;
  std::vector<std::string> columns;
};
[[nodiscard]] std::span<const Key<TableOptions>> table_keys();

/// One row a sample, columns named by what they hold; a row has exactly the named columns (an empty last one
/// may be left over by a separator at the line's end). An empty field and `nan` are absent: no fact is made
/// from them. A row is refused as "fields" (count or text), "range", "truncated" or "too long" (64 KiB). Rows
/// that `valid` calls invalid give a DvlVelocity without lock where there are velocities, nothing else.
/// vel_z_mps may be left out: the instrument is then taken to move level. Error: an unknown column name (the
/// nearest known one is named), a column twice, one without those it needs, or columns that make no fact.
[[nodiscard]] Result<std::unique_ptr<Decoder>> make_table(const DecoderSettings& settings,
                                                          const TableOptions& options);

}  // namespace leadline::decode
