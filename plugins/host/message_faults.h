#pragma once

#include <string_view>

#include "core/messages/message.h"

namespace leadline {

/// What is wrong with a message that third-party code made, in one of a few fixed words; empty: nothing.
/// An engine may say Solution, FixVerdict, ModeChange and Health, in its own id: "foreign message",
/// "foreign id"; every number must be finite and within its type's legal range: "not finite", "range".
[[nodiscard]] std::string_view fault_of_engine(const Message& message, Time valid, EngineId id);

/// The same for a decoder, which may say measurements and ClockReading.
[[nodiscard]] std::string_view fault_of_decoder(const Message& message);

}  // namespace leadline
