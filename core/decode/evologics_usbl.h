#pragma once

#include <memory>

#include "core/flow/decoder.h"

namespace leadline::decode {

/// EvoLogics modem notifications `+++AT:len:body`, found by their length among binary user data, wire-formats
/// 8; USBLLONG makes facts. The transponder's name is its address. East, north and up are what the device has
/// turned with its own heading, whose north may be the magnetic one: a note says so once. Valid when
/// measured: t_meas where the device's clock is set (after 2001), else arrival minus its age. Not told: the
/// accuracy, whose unit no public source states. There is no checksum.
[[nodiscard]] std::unique_ptr<Decoder> make_evologics_usbl(const DecoderSettings& settings);

}  // namespace leadline::decode
