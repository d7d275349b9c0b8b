#include "core/decode/iec61162_450_sources.h"

#include <algorithm>
#include <span>
#include <string>
#include <utility>

namespace leadline::decode::udpbc {
namespace {

using std::chrono::seconds;

constexpr Duration kDuplicate = seconds(1);
constexpr Duration kTold = seconds(10);          // between two notes of one speaker's losses
constexpr Duration kOtherAddress = seconds(10);  // an address that was silent this long has been replaced
constexpr Duration kRemembered = seconds(60);
constexpr std::uint16_t kCounts = 1000;
/// A longer jump is no loss but a count begun anew: a sender that was started again.
constexpr std::uint16_t kMostLost = 100;
/// So far behind, a line was overtaken on its way.
constexpr std::uint16_t kOvertaken = 16;

std::string_view address_of(const SenderName& sender) {
  return sender.view().substr(0, sender.view().rfind(':'));
}

std::uint64_t fingerprint_of(std::string_view source, std::uint16_t count, std::string_view sentence) {
  std::uint64_t hash = 0xCBF29CE484222325 ^ count;  // FNV-1a
  for (const std::string_view part : {source, sentence})
    for (const char c : part) hash = (hash ^ static_cast<std::uint8_t>(c)) * 0x100000001B3;
  return hash;
}

}  // namespace

SourceBook::Verdict SourceBook::hear(const SenderName& sender, std::string_view source,
                                     std::optional<std::uint16_t> count, std::string_view sentence,
                                     std::optional<Arrival> arrival, DecoderOutput& out) {
  Verdict verdict;
  Speaker& me = speaker(sender, source);
  if (arrival && !sender.empty()) check_alone(me, *arrival, out);
  me.turn = ++turn_;
  me.heard = arrival;
  if (!count) return verdict;
  verdict.duplicate = heard_already(source, *count, sentence, arrival);
  if (!verdict.duplicate || me.count != count) verdict.lost = count_losses(me, *count, arrival, out);
  return verdict;
}

SourceBook::Speaker& SourceBook::speaker(const SenderName& sender, std::string_view source) {
  const std::span known(speakers_.data(), speaker_count_);
  for (Speaker& each : known)
    if (each.source.view() == source && each.sender == sender) return each;
  Speaker& fresh =
      speaker_count_ < speakers_.size()
          ? speakers_[speaker_count_++]
          : *std::min_element(known.begin(), known.end(),
                              [](const Speaker& a, const Speaker& b) { return a.turn < b.turn; });
  fresh = Speaker{};
  fresh.sender = sender;
  fresh.source = source;
  return fresh;
}

bool SourceBook::heard_already(std::string_view source, std::uint16_t count, std::string_view sentence,
                               std::optional<Arrival> arrival) {
  const std::uint64_t fingerprint = fingerprint_of(source, count, sentence);
  for (const Line& line : lines_)
    if (line.fingerprint == fingerprint && (!arrival || !line.heard || *arrival - *line.heard <= kDuplicate))
      return true;
  lines_[next_line_++ % lines_.size()] = {fingerprint, arrival};
  return false;
}

std::uint32_t SourceBook::count_losses(Speaker& me, std::uint16_t count, std::optional<Arrival> arrival,
                                       DecoderOutput& out) {
  const auto before = std::exchange(me.count, count);
  if (!before) return 0;
  const auto step = static_cast<std::uint16_t>((count + kCounts - *before) % kCounts);
  if (step == 1) return 0;
  if (step == 0 || step >= kCounts - kOvertaken) {
    me.count = before;
    return 0;
  }
  const bool anew = step > kMostLost + 1;
  const std::uint32_t lost = anew ? 0 : step - 1u;
  me.lost += lost;
  me.lost_untold += lost;
  if (me.told && !(arrival && *arrival - *me.told >= kTold)) return lost;
  me.told = arrival ? arrival : Arrival{};
  const std::string name(me.source.view());
  if (anew)
    out.fact(std::nullopt,
             Health{Health::Level::note, name + " counts its lines anew: " + std::to_string(count) +
                                             " after " + std::to_string(*before) +
                                             "; it was started again, or not heard for long"});
  else
    out.fact(std::nullopt, Health{Health::Level::warning, name + ": " + std::to_string(me.lost_untold) +
                                                              " lines were lost on the way, " +
                                                              std::to_string(me.lost) + " in all"});
  me.lost_untold = 0;
  return lost;
}

void SourceBook::check_alone(Speaker& me, Arrival arrival, DecoderOutput& out) {
  for (Speaker& other : std::span(speakers_.data(), speaker_count_)) {
    if (&other == &me || other.source != me.source || other.sender.empty() || !other.heard) continue;
    const bool other_address = address_of(other.sender) != address_of(me.sender);
    // It spoke, then the other one, now it again.
    const bool in_turns = me.heard && other.turn > me.turn && arrival - *me.heard <= kRemembered;
    if (!in_turns && !(other_address && arrival - *other.heard <= kOtherAddress)) continue;
    const auto lasting = [&](const Speaker& s) { return s.alarmed && arrival - *s.alarmed <= kRemembered; };
    const bool told = lasting(me) || lasting(other);
    me.alarmed = other.alarmed = arrival;
    if (told) continue;
    out.fact(std::nullopt,
             Alarm{Alarm::Priority::warning, "two senders",
                   "SFI " + std::string(me.source.view()) + " used by two senders, " +
                       std::string(other.sender.view()) + " and " + std::string(me.sender.view()) +
                       ": both are read; silence the one that does not belong there"});
  }
}

}  // namespace leadline::decode::udpbc
