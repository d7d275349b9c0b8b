#pragma once

#include <memory>

#include "core/decode/profile.h"
#include "core/flow/decoder.h"

namespace leadline::decode {

/// IEC 61162-450: datagrams "UdPbC" of lines, each TAG blocks and one sentence, read as one stream of bytes
/// in which a header begins a datagram; one report a line. Both checksums must hold. A line must name its
/// source (s) and stand in a datagram unless header = "optional". Lines of a group wait for all of it, 1 s at
/// most
/// ("group"). Lines lost are told by n for each sender and source; a line heard again within 1 s is a
/// "duplicate". c is the device's time where the sentence gives none, unless it is more than a day off the
/// arrival. address of the form of a source (two letters, four digits) chooses its sentences. Two senders of
/// one source make an Alarm: another address at once, another port of one address when the first speaks again
/// (a program started anew has a new port).
[[nodiscard]] std::unique_ptr<Decoder> make_iec61162_450(const DecoderSettings& settings,
                                                         const ProfileOptions& profile = {});

}  // namespace leadline::decode
