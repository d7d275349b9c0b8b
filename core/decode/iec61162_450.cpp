#include "core/decode/iec61162_450.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <utility>

#include "core/decode/iec61162_450_framing.h"
#include "core/decode/iec61162_450_queue.h"
#include "core/decode/iec61162_450_sources.h"
#include "core/decode/iec61162_450_tag.h"
#include "core/decode/nmea0183_sentence.h"
#include "core/types/expect.h"

namespace leadline::decode {
namespace udpbc {
namespace {

using nmea0183::report_of;

constexpr Duration kGroupWaits = std::chrono::seconds(1);
constexpr Duration kClockOff = std::chrono::hours(24);
constexpr std::string_view kDuplicate = "duplicate", kGroup = "group", kNoHeader = "no header",
                           kNoSource = "no source";

/// Two letters and four digits.
bool is_sfi(std::string_view text) {
  const auto between = [](char c, char low, char high) { return c >= low && c <= high; };
  return text.size() == 6 && between(text[0], 'A', 'Z') && between(text[1], 'A', 'Z') &&
         std::all_of(text.begin() + 2, text.end(), [&](char c) { return between(c, '0', '9'); });
}

DecoderSettings without_sfi(DecoderSettings settings) {
  if (is_sfi(settings.address)) settings.address = {};
  return settings;
}

nmea0183::Line::End as_sentence_end(LineEnd end) {
  return end == LineEnd::stream ? nmea0183::Line::End::stream : nmea0183::Line::End::terminator;
}

/// Gives facts the sender's time where the sentence gives none.
class Dated final : public DecoderOutput {
 public:
  Dated(DecoderOutput& out, std::optional<Time> time) : out_(out), time_(time) {}
  void fact(std::optional<Time> device_time, const Message& message) override {
    const bool measured = !std::holds_alternative<Health>(message);
    out_.fact(device_time || !measured ? device_time : time_, message);
  }
  void frame(const FrameReport& report) override { out_.frame(report); }

 private:
  DecoderOutput& out_;
  std::optional<Time> time_;
};

class Iec61162_450 final : public Decoder, private PieceReader {
 public:
  Iec61162_450(const DecoderSettings& settings, const ProfileOptions& profile)
      : lenient_(profile.udpbc_header == "optional"),
        chosen_(is_sfi(settings.address) ? settings.address : std::string_view()),
        sentences_(without_sfi(settings), profile),
        framing_(*this) {}

  void sender(std::string_view name) override { sender_ = SenderName(name); }

  void feed(std::span<const std::uint8_t> bytes, std::optional<Arrival> arrival,
            DecoderOutput& out) override {
    out_ = &out;
    arrival_ = arrival;
    for (Group& group : groups_)
      if (group.open && arrival && group.begun && *arrival - *group.begun > kGroupWaits) drop(group);
    queue_.hand_on(out);
    framing_.feed(bytes);
  }

  void finish(DecoderOutput& out) override {
    out_ = &out;
    framing_.finish();
    for (Group& group : groups_)
      if (group.open) drop(group);
    queue_.hand_on(out);
  }

 private:
  // --- what the framing tells

  void header(const Token& token, std::uint64_t offset) override {
    datagram_ = token.binary ? std::nullopt : std::optional(offset);
    FrameReport report = report_of(token.binary ? ByteClass::unused : ByteClass::decoded, token.name);
    report.block = !token.binary;  // its lines are the telegrams
    tell(offset, kHeaderBytes, report);
  }

  void content(bool binary, std::uint64_t offset, std::uint32_t length) override {
    tell(offset, length, report_of(binary ? ByteClass::unused : ByteClass::skipped));
  }

  void line(std::string_view text, LineEnd end, std::uint64_t offset) override {
    line_ = ticket(offset);
    end_of_line_ = offset + text.size();
    if (const auto report = read_line(text, end)) queue_.decide(line_, *report);
  }

  void line_length(std::uint32_t length) override {
    queue_.set_length(line_, length);
    queue_.hand_on(*out_);
  }

  // --- lines

  /// Empty: it waits for the rest of its group.
  std::optional<FrameReport> read_line(std::string_view text, LineEnd end) {
    constexpr std::string_view kHeader = "UdPbC", kBeginnings = "\\$!";
    if (text.find_first_not_of(' ') == std::string_view::npos) return report_of(ByteClass::comment);
    const bool in_datagram = datagram_.has_value();
    if (lenient_ && text.size() > kHeader.size() && text.substr(0, kHeader.size()) == kHeader &&
        kBeginnings.find(text[kHeader.size()]) != std::string_view::npos)
      text.remove_prefix(kHeader.size());
    if (kBeginnings.find(text.front()) == std::string_view::npos) return read_rubbish(text);
    if (end == LineEnd::too_long) return refused(text, nmea0183::kReasonTooLong);
    if (end == LineEnd::header) return refused(text, nmea0183::kReasonTruncated);
    if (!in_datagram && !lenient_) return refused(text, kNoHeader);
    if (in_datagram && !lenient_ && end_of_line_ - *datagram_ > kLongestDatagram)
      return refused(text, nmea0183::kReasonTooLong);

    Tag tag;
    std::string_view sentence = text;
    if (const auto fault = take_tags(sentence, tag); !fault.empty()) return refused(text, fault);
    if (sentence.empty()) return report_of(ByteClass::unused, "TAG");
    if (sentence[0] == '\\' || kBeginnings.find(sentence[0]) == std::string_view::npos)
      return refused(sentence, nmea0183::kReasonTorn);
    if (sentence.size() > nmea0183::kLongestSentence) return refused(sentence, nmea0183::kReasonTooLong);
    return read_tagged(tag, sentence, end);
  }

  static FrameReport read_rubbish(std::string_view text) {
    if (!nmea0183::is_printable(text)) return report_of(ByteClass::skipped);
    if (nmea0183::ends_in_checksum(text))
      return report_of(ByteClass::refused, nmea0183::kSentence, nmea0183::kReasonTorn);
    return report_of(ByteClass::unknown, "text");
  }

  /// A line that is not read, by the kind of its sentence where that can be seen.
  FrameReport refused(std::string_view text, std::string_view reason) {
    const std::size_t start = text.find_first_of("$!");
    FrameReport report = report_of(ByteClass::refused, nmea0183::kSentence, reason);
    if (start != std::string_view::npos && nmea0183::is_printable(text))
      report.kind = sentences_.inspect(text.substr(start), nmea0183::Line::End::too_long).kind;
    return report;
  }

  std::optional<FrameReport> read_tagged(const Tag& tag, std::string_view sentence, LineEnd end) {
    const bool grouped = tag.group && tag.group->total > 1;
    const std::string_view source = !tag.source.empty() || !grouped ? tag.source : source_of_group(tag);
    if (!source.empty()) {
      const auto verdict = book_.hear(sender_, source, tag.count, sentence, arrival_, *out_);
      queue_.set_lost(line_, verdict.lost);
      if (verdict.duplicate) return report_of(ByteClass::unused, kDuplicate);
    }
    if (grouped) {
      if (tag.group->total > Group::kMostLines) return refused(sentence, kGroup);
      return hold(group_of(tag), tag, sentence, end);
    }
    if (source.empty() && !lenient_) return refused(sentence, kNoSource);
    return read_sentence(source, tag.time, sentence, end);
  }

  FrameReport read_sentence(std::string_view source, std::optional<Time> time, std::string_view sentence,
                            LineEnd end) {
    if (!chosen_.empty() && source != chosen_) {
      FrameReport report = sentences_.inspect(sentence, as_sentence_end(end));
      if (report.byte_class == ByteClass::decoded) report.byte_class = ByteClass::unused;
      return report;
    }
    time = trusted(time);
    if (time && !arrival_) out_->fact(time, ClockReading{"TAG", time->ns, {}});
    Dated dated(*out_, time);
    return sentences_.read(sentence, as_sentence_end(end), arrival_, dated);
  }

  /// A sender without a set clock does not say when.
  std::optional<Time> trusted(std::optional<Time> time) {
    if (!time || !arrival_ || std::chrono::abs(*time - arrival_->host()) <= kClockOff) return time;
    if (!std::exchange(clock_told_, true))
      out_->fact(std::nullopt,
                 Health{Health::Level::warning,
                        "a sender's clock (TAG c) is more than a day off the host's: the time of "
                        "arrival is used instead"});
    return std::nullopt;
  }

  // --- groups

  /// Only its first line need name the source; the last of its lines may come twice.
  std::string_view source_of_group(const Tag& tag) const {
    std::string_view closed;
    for (const Group& group : groups_) {
      if (!group.is(sender_, tag)) continue;
      if (group.open) return group.source.view();
      closed = group.source.view();
    }
    return closed;
  }

  Group& group_of(const Tag& tag) {
    for (Group& group : groups_) {
      if (!group.open || !group.is(sender_, tag)) continue;
      if (!group.lines[tag.group->line - 1].here) return group;
      drop(group);  // its number is used again
    }
    auto* fresh = std::find_if(groups_.begin(), groups_.end(), [](const Group& g) { return !g.open; });
    if (fresh == groups_.end()) {
      fresh = std::min_element(groups_.begin(), groups_.end(),
                               [](const Group& a, const Group& b) { return a.turn < b.turn; });
      drop(*fresh);
    }
    fresh->open = true;
    fresh->sender = sender_;
    fresh->id = tag.group->id;
    fresh->total = tag.group->total;
    fresh->received = 0;
    fresh->source = {};
    fresh->time = std::nullopt;
    fresh->begun = arrival_;
    fresh->turn = ++group_turn_;
    for (auto& line : fresh->lines) line.here = false;
    return *fresh;
  }

  std::optional<FrameReport> hold(Group& group, const Tag& tag, std::string_view sentence, LineEnd end) {
    if (!group.time) group.time = tag.time;
    if (group.source.empty()) group.source = tag.source;
    FrameReport seen = sentences_.inspect(sentence, as_sentence_end(end));
    Group::Line& line = group.lines[tag.group->line - 1];
    if (!seen.reason.empty()) return seen;  // so the group stays incomplete
    line.here = true;
    line.ticket = line_;
    line.size = static_cast<std::uint32_t>(sentence.size());
    std::memcpy(line.text.data(), sentence.data(), sentence.size());
    if (++group.received == group.total) read_group(group);
    return std::nullopt;
  }

  void read_group(Group& group) {
    group.open = false;
    for (std::uint32_t i = 0; i < group.total; ++i) {
      const Group::Line& line = group.lines[i];
      queue_.decide(line.ticket, group.source.empty() && !lenient_
                                     ? refused(line.sentence(), kNoSource)
                                     : read_sentence(group.source.view(), group.time, line.sentence(),
                                                     LineEnd::terminator));
    }
  }

  void drop(Group& group) {
    group.open = false;
    for (std::uint32_t i = 0; i < group.total; ++i)
      if (group.lines[i].here)
        queue_.decide(group.lines[i].ticket, refused(group.lines[i].sentence(), kGroup));
  }

  // --- reports

  ReportQueue::Ticket ticket(std::uint64_t offset) {
    queue_.hand_on(*out_);
    while (queue_.full()) {  // behind a group, or there would be room
      auto* oldest = groups_.end();
      for (auto* group = groups_.begin(); group != groups_.end(); ++group)
        if (group->open && (oldest == groups_.end() || group->turn < oldest->turn)) oldest = group;
      LL_EXPECT(oldest != groups_.end());
      drop(*oldest);
      queue_.hand_on(*out_);
    }
    return queue_.add(offset);
  }

  void tell(std::uint64_t offset, std::uint32_t length, const FrameReport& report) {
    const auto at = ticket(offset);
    queue_.set_length(at, length);
    queue_.decide(at, report);
    queue_.hand_on(*out_);
  }

  bool lenient_;
  std::string_view chosen_;  // the only source whose sentences are facts
  nmea0183::SentenceDecoder sentences_;
  SourceBook book_;
  ReportQueue queue_;
  std::array<Group, 8> groups_;
  Framing framing_;

  SenderName sender_;
  std::optional<Arrival> arrival_;
  DecoderOutput* out_ = nullptr;
  std::optional<std::uint64_t> datagram_;  // offset of its header
  ReportQueue::Ticket line_ = 0;           // of the line being read
  std::uint64_t end_of_line_ = 0;
  std::uint64_t group_turn_ = 0;
  bool clock_told_ = false;
};

}  // namespace
}  // namespace udpbc

std::unique_ptr<Decoder> make_iec61162_450(const DecoderSettings& settings, const ProfileOptions& profile) {
  return std::make_unique<udpbc::Iec61162_450>(settings, profile);
}

}  // namespace leadline::decode
