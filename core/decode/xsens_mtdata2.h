#pragma once

#include <memory>

#include "core/flow/decoder.h"

namespace leadline::decode {

/// Xsens MTi, Xbus MTData2, wire-formats 10. Attitude and heading (from the quaternion where there is one)
/// only while the filter is valid by the status word, if that is sent; rates; rates with accelerations are an
/// ImuSample; latitude and longitude with a GNSS fix. Device time: UTC where the device calls it valid,
/// carried on by the sample time (which wraps after 4.97 days) in packets without. Lost packets, by their
/// counter, and a filter or self-test that fails are told as Health.
[[nodiscard]] std::unique_ptr<Decoder> make_xsens_mtdata2(const DecoderSettings& settings);

}  // namespace leadline::decode
