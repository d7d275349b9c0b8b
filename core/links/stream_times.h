#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/flow/decoder.h"
#include "core/links/file_reader.h"
#include "core/links/stream_source.h"

namespace leadline::links {

struct StreamTimeOptions {
  std::optional<Time> date;         ///< the source's `date`, midnight UTC
  double rate_hz = 0.0;             ///< of telegrams without times of their own; 0: not used
  std::string source, file;         ///< for messages
  bool gps_time = false;            ///< the device's clock runs on GPS time
  std::int64_t time_offset_ns = 0;  ///< added to the device's clock
};

/// Makes a fresh decoder of the source, given the host time to date times of day with.
using DecoderMaker = std::function<std::unique_ptr<Decoder>(std::optional<Time> date)>;

/// When the bytes of a plain stream arrived, as told by its own telegrams: a Stamp at the start of each
/// telegram with a new ClockReading (where there are none at all: with a new device time of its facts).
/// The host time is the first reading, else noon of options.date. Times never go back, and one that jumps by
/// more than an hour counts only when the next reading confirms it: lies within an hour of it, or goes on in
/// the same stride. Without any time the k-th telegram is at date + k / rate_hz. Reads the file twice,
/// streaming. Error: a stream without date or time of which the options say nothing, or a disk that fails.
[[nodiscard]] Result<std::vector<Stamp>> stream_times(FileReader& file, const DecoderMaker& make_decoder,
                                                      const StreamTimeOptions& options);

}  // namespace leadline::links
