#include "core/decode/iec61162_450.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "core/decode/iec61162_450_tag.h"
#include "tests/support/decoder_harness.h"
#include "tests/support/files.h"

namespace leadline::test {
namespace {

constexpr Arrival kArrival{1'795'350'919'600'000'000};  // 2026-11-22T12:35:19.6Z
constexpr std::string_view kHeader("UdPbC\0", 6);
constexpr std::string_view kHdt = "$HEHDT,001.7,T*29\r\n";

Arrival after(double s) { return kArrival + duration(s); }

std::string sum_of(std::string_view text) {
  unsigned sum = 0;
  for (const char c : text) sum ^= static_cast<std::uint8_t>(c);
  constexpr char kDigits[] = "0123456789ABCDEF";
  return {kDigits[sum >> 4], kDigits[sum & 15]};
}
std::string tag(const std::string& content) { return "\\" + content + "*" + sum_of(content) + "\\"; }
std::string datagram(const std::string& lines) { return std::string(kHeader) + lines; }
std::string hdt(const std::string& content) { return datagram(tag(content) + std::string(kHdt)); }

decode::ProfileOptions lenient() {
  decode::ProfileOptions profile;
  profile.udpbc_header = "optional";
  return profile;
}

Decoded decode_udpbc(std::string_view bytes, const decode::ProfileOptions& profile = {},
                     std::size_t chunk = 0, std::optional<Arrival> arrival = kArrival) {
  return decode_all(*decode::make_iec61162_450({}, profile), as_bytes(bytes), arrival, chunk);
}

/// A conversation: datagrams of senders at times.
struct Talk {
  std::unique_ptr<Decoder> decoder = decode::make_iec61162_450({});
  Decoded out;
  void hear(const std::string& bytes, double at_s, std::string_view sender = "10.0.0.1:60004") {
    decoder->sender(sender);
    decoder->feed(as_bytes(bytes), after(at_s), out);
  }
  Decoded& end() { return decoder->finish(out), out; }
};

/// What became of each report: kind, -kind unused, kind!reason refused, ? skipped or unknown, [kind] a block.
std::string classes(const Decoded& d) {
  std::string text;
  for (const FrameReport& f : d.frames) {
    if (!text.empty()) text += ' ';
    if (f.byte_class == ByteClass::unused) text += '-';
    if (f.byte_class == ByteClass::unknown || f.byte_class == ByteClass::skipped) text += '?';
    text += f.block ? "[" + std::string(f.kind) + "]" : std::string(f.kind);
    if (f.byte_class == ByteClass::refused) text += "!" + std::string(f.reason);
  }
  return text;
}

bool covers(const Decoded& d, std::size_t size) {
  std::uint64_t covered = 0;
  for (const FrameReport& f : d.frames) {
    if (f.offset != covered || f.length == 0) return false;
    covered += f.length;
  }
  return covered == size;
}

std::string single() { return read_text(data_path("wire-samples/udpbc_single.bin")); }
std::string group() { return read_text(data_path("wire-samples/udpbc_group.bin")); }

/// One of everything.
std::string everything() {
  return single() + group() + hdt("s:HE0001,n:1") + std::string("NkPgN\0\x01\x02\r\n\x03$", 12) +
         datagram("\r\n" + tag("s:GP0001,n:4,c:1795350919") +
                  "$GPGGA,123519.50,5912.34567,N,00512.34567,E,4,14,0.7,41.20,M,44.10,M,1.2,0123*71\r\n" +
                  tag("g:1-3-7,s:GP0001,n:5") + std::string(kHdt) + "garbage\r" + tag("s:GP0001,n:9") +
                  "$GPXYZ,1*51\n") +
         "\xFF\xFE" + hdt("s:HE0001,n:2") + hdt("s:HE0001,n:2") + std::string(1600, 'x') + single();
}

// --- the samples of wire-formats 2 ---

TEST(Iec61162_450, SingleGivesItsHeading) {
  const Decoded d = decode_udpbc(single());
  ASSERT_EQ(d.all<Heading>().size(), 1u);
  EXPECT_NEAR(d.all<Heading>()[0].heading.deg(), 1.7, 1e-9);
  EXPECT_EQ(classes(d), "[UdPbC] HDT");
  EXPECT_EQ(d.frames[1].checksum, ChecksumState::ok);
  EXPECT_TRUE(covers(d, 52));
  EXPECT_FALSE(d.first<Heading>()->device_time);
}

TEST(Iec61162_450, GroupIsReadWholeUnderTheSourceOfItsFirstLine) {
  const Decoded d = decode_udpbc(group());
  EXPECT_TRUE(covers(d, group().size()));
  EXPECT_EQ(d.frames.size(), 3u) << classes(d);
  EXPECT_EQ(d.ledger.refusals().size(), 0u) << classes(d);
  EXPECT_EQ(d.ledger.frames(), 2u);
}

TEST(Iec61162_450, RealLinesAreRead) {
  const Decoded rot = decode_udpbc(datagram("\\s:HE0001*45\\$HEROT,+000.05,A*35\r\n"));
  ASSERT_EQ(rot.all<Rates>().size(), 1u);
  EXPECT_NEAR(rot.all<Rates>()[0].rate_z_rps, 0.05 / 60.0 * kRadPerDeg, 1e-12);

  const Decoded gll = decode_udpbc(
      datagram("\\s:IN0001,n:881,c:1683881316755*4D\\$INGLL,5416.4774,N,01201.8283,E,084836.75,A,A*7F\r\n"),
      {}, 0, Arrival{1'683'881'316'800'000'000});
  ASSERT_EQ(gll.all<GnssFix>().size(), 1u);
  EXPECT_EQ(gll.first<GnssFix>()->device_time, parse_iso8601("2023-05-12T08:48:36.75Z"))
      << "the sentence's own time goes before TAG's c";

  const Decoded two = decode_udpbc(datagram("\\d:HE0002*51\\\\s:HE0001*45\\$HEROT,+000.05,A*35\r\n"));
  EXPECT_EQ(two.all<Rates>().size(), 1u) << "several blocks a line";
}

// --- TAG blocks ---

TEST(Iec61162_450, TagKeysAreTaken) {
  using decode::udpbc::Tag, decode::udpbc::take_tags;
  const std::string text = tag("s:IN0001,d:NV0002,n:17,g:1-2-34,t:hello,r:12,a:xyz,q:new") + "$rest";
  std::string_view line = text;
  Tag t;
  ASSERT_EQ(take_tags(line, t), "");
  EXPECT_EQ(line, "$rest");
  EXPECT_EQ(t.source, "IN0001");
  EXPECT_EQ(t.destination, "NV0002");
  EXPECT_EQ(t.count, 17);
  EXPECT_EQ(t.group->line, 1u);
  EXPECT_EQ(t.group->total, 2u);
  EXPECT_EQ(t.group->id, 34u);
  EXPECT_EQ(t.text, "hello");
  EXPECT_EQ(t.relative, "12");
  EXPECT_EQ(t.authentication, "xyz");
  ASSERT_EQ(t.other_count, 1u);
  EXPECT_EQ(t.others[0].key, "q");
  for (const char* bad : {"n:1000", "n:-1", "n:", "g:1-2", "g:3-2-1", "g:0-2-1", "c:12x", "s:", "plain"}) {
    const std::string one = tag(bad);
    std::string_view rest = one;
    Tag broken;
    EXPECT_EQ(take_tags(rest, broken), "TAG") << bad;
  }
}

TEST(Iec61162_450, CIsSecondsOrMillisecondsByMagnitudeAndTimesWhatHasNoTime) {
  const auto time_with = [](const std::string& c) {
    return decode_udpbc(hdt("s:HE0001,c:" + c)).first<Heading>()->device_time;
  };
  EXPECT_EQ(time_with("1795350919"), parse_iso8601("2026-11-22T12:35:19Z"));
  EXPECT_EQ(time_with("1795350919755"), parse_iso8601("2026-11-22T12:35:19.755Z"));
  EXPECT_FALSE(time_with("1683881316")) << "years off the arrival: a clock that is not set";
  EXPECT_EQ(decode_udpbc(hdt("s:HE0001,c:7") + hdt("s:HE0001,c:8")).all<Health>().size(), 1u) << "told once";
  const Decoded plain = decode_udpbc(hdt("s:HE0001,c:1795350919"), {}, 0, std::nullopt);
  ASSERT_EQ(plain.all<ClockReading>().size(), 1u) << "a plain stream finds its times by it";
  EXPECT_EQ(plain.all<ClockReading>()[0].telegram.view(), "TAG");
}

TEST(Iec61162_450, BothChecksumsAreChecked) {
  std::string broken_tag = hdt("s:HE0001,n:1"), broken_sentence = broken_tag;
  broken_tag[9] ^= 1;
  broken_sentence[broken_sentence.find("001.7")] ^= 1;
  EXPECT_EQ(classes(decode_udpbc(broken_tag)), "[UdPbC] HDT!TAG checksum");
  EXPECT_EQ(classes(decode_udpbc(broken_sentence)), "[UdPbC] HDT!checksum");
  EXPECT_EQ(classes(decode_udpbc(datagram("\\s:HE0001*45$HEHDT,001.7,T*29\r\n"))), "[UdPbC] HDT!TAG");
  EXPECT_EQ(classes(decode_udpbc(datagram("\\s:HE0001\\$HEHDT,001.7,T*29\r\n"))), "[UdPbC] HDT!TAG checksum");
}

// --- what is accepted only if configured ---

TEST(Iec61162_450, PlainSentencesHeadersWithoutNulAndNamelessLinesNeedTheirSetting) {
  const struct {
    std::string text;
    const char *strict, *lenient;
  } cases[] = {
      {std::string(kHdt), "HDT!no header", "HDT"},
      {tag("s:HE0001") + std::string(kHdt), "HDT!no header", "HDT"},
      {"UdPbC" + tag("s:HE0001") + std::string(kHdt), "sentence!torn", "HDT"},
      {datagram(std::string(kHdt)), "[UdPbC] HDT!no source", "[UdPbC] HDT"},
      {datagram(tag("n:1") + std::string(kHdt)), "[UdPbC] HDT!no source", "[UdPbC] HDT"},
  };
  for (const auto& c : cases) {
    EXPECT_EQ(classes(decode_udpbc(c.text)), c.strict);
    EXPECT_EQ(classes(decode_udpbc(c.text, lenient())), c.lenient);
    EXPECT_EQ(decode_udpbc(c.text).all<Heading>().size(), 0u);
    EXPECT_EQ(decode_udpbc(c.text, lenient()).all<Heading>().size(), 1u);
  }
}

TEST(Iec61162_450, BinaryDatagramsAreRecognisedAndSkipped) {
  for (const std::string token : {"RaUdP", "RrUdP", "RpUdP", "NkPgN"}) {
    const std::string bytes = token + std::string("\0$\r\nUdPb\0\x80$HEHDT\r\n", 18) + single();
    const Decoded d = decode_udpbc(bytes);
    EXPECT_EQ(classes(d), "-" + token + " - [UdPbC] HDT");
    EXPECT_TRUE(covers(d, bytes.size()));
  }
}

TEST(Iec61162_450, AnSfiAsAddressChoosesItsSentences) {
  const std::string chosen = "HE0002";
  DecoderSettings settings;
  settings.address = chosen;
  const std::string bytes = hdt("s:HE0001,n:1") + hdt("s:HE0002,n:1");
  const Decoded d = decode_all(*decode::make_iec61162_450(settings), as_bytes(bytes), kArrival);
  EXPECT_EQ(classes(d), "[UdPbC] -HDT [UdPbC] HDT");
  EXPECT_EQ(d.all<Heading>().size(), 1u);
}

// --- groups ---

TEST(Iec61162_450, AnIncompleteGroupIsDroppedAfterASecond) {
  Talk talk;
  talk.hear(datagram(tag("g:1-2-5,s:HE0001,n:1") + std::string(kHdt)), 0.0);
  talk.hear(hdt("s:HE0002,n:1"), 0.9);
  EXPECT_EQ(talk.out.frames.size(), 1u) << "reports wait behind the group, facts do not";
  EXPECT_EQ(talk.out.all<Heading>().size(), 1u);
  talk.hear(hdt("s:HE0002,n:2"), 1.1);
  EXPECT_EQ(classes(talk.end()), "[UdPbC] HDT!group [UdPbC] HDT [UdPbC] HDT");
  EXPECT_EQ(talk.out.all<Heading>().size(), 2u);
}

TEST(Iec61162_450, AGroupMayComeInAnyOrderAndInSeveralDatagrams) {
  Talk talk;
  talk.hear(datagram(tag("g:2-2-5,n:2") + "$HEHDT,002.7,T*2A\r\n"), 0.0);
  talk.hear(datagram(tag("g:1-2-5,s:HE0001,n:1") + std::string(kHdt)), 0.3);
  const Decoded& d = talk.end();
  EXPECT_EQ(classes(d), "[UdPbC] HDT [UdPbC] HDT");
  ASSERT_EQ(d.all<Heading>().size(), 2u);
  EXPECT_NEAR(d.all<Heading>()[0].heading.deg(), 1.7, 1e-9) << "in the order of their numbers";
}

TEST(Iec61162_450, GroupsWithoutEndStayBounded) {
  std::string bytes;
  for (int i = 0; i < 3000; ++i)
    bytes += datagram(tag("g:1-9-" + std::to_string(i) + ",s:HE0001,n:" + std::to_string(i % 1000)) +
                      std::string(kHdt));
  const Decoded d = decode_udpbc(bytes);
  EXPECT_TRUE(covers(d, bytes.size()));
  EXPECT_EQ(d.all<Heading>().size(), 0u);
  EXPECT_EQ(d.ledger.refusals()[0].count, 3000u);
}

// --- counts, duplicates, senders ---

std::uint64_t lost_in(const std::vector<int>& counts) {
  Talk talk;
  double at_s = 0.0;
  for (const int n : counts) talk.hear(hdt("s:HE0001,n:" + std::to_string(n)), at_s += 2.0);
  return talk.end().ledger.lost();
}

TEST(Iec61162_450, LossesAreCountedByNOverItsWrap) {
  EXPECT_EQ(lost_in({17, 18, 19}), 0u);
  EXPECT_EQ(lost_in({998, 999, 0, 1}), 0u) << "the wrap is no loss";
  EXPECT_EQ(lost_in({17, 21}), 3u);
  EXPECT_EQ(lost_in({998, 2}), 3u);
  EXPECT_EQ(lost_in({700, 0, 1}), 0u) << "started again";
  EXPECT_EQ(lost_in({17, 19, 18, 20}), 1u) << "overtaken on its way";
  Talk talk;
  talk.hear(hdt("s:HE0001,n:1"), 0.0);
  talk.hear(hdt("s:HE0002,n:500"), 0.1);
  talk.hear(hdt("s:HE0001,n:3"), 0.2);
  EXPECT_EQ(talk.end().ledger.lost(), 1u) << "for each source";
  ASSERT_EQ(talk.out.all<Health>().size(), 1u);
  EXPECT_EQ(talk.out.all<Health>()[0].text.view(), "HE0001: 1 lines were lost on the way, 1 in all");
}

TEST(Iec61162_450, DuplicatesWithinASecondAreUnused) {
  Talk talk;
  talk.hear(hdt("s:HE0001,n:1"), 0.0);
  talk.hear(hdt("s:HE0001,n:1"), 0.9);
  talk.hear(hdt("s:HE0001,n:1"), 2.0);
  EXPECT_EQ(classes(talk.end()), "[UdPbC] HDT [UdPbC] -duplicate [UdPbC] HDT");
  EXPECT_EQ(talk.out.all<Heading>().size(), 2u);
}

TEST(Iec61162_450, TwoSendersOfOneSourceAreAnAlarmAtOnce) {
  Talk talk;
  for (int i = 0; i < 40; ++i) {
    talk.hear(hdt("s:HE0001,n:" + std::to_string(i)), i * 1.0, "10.0.0.1:60004");
    if (i >= 10) talk.hear(hdt("s:HE0001,n:" + std::to_string(i + 100)), i * 1.0 + 0.5, "10.0.0.9:60004");
  }
  const auto alarms = talk.end().all<Alarm>();
  ASSERT_EQ(alarms.size(), 1u) << "once while it lasts";
  EXPECT_EQ(
      alarms[0].text.view(),
      "SFI HE0001 used by two senders, 10.0.0.1:60004 and 10.0.0.9:60004: both are read; silence the one "
      "that does not belong there");
  EXPECT_EQ(talk.out.all<Heading>().size(), 70u) << "both are read";
}

TEST(Iec61162_450, AProgramStartedAnewIsNoSecondSender) {
  Talk talk;
  for (int i = 0; i < 5; ++i) talk.hear(hdt("s:HE0001,n:" + std::to_string(i)), i * 1.0, "10.0.0.1:4000");
  for (int i = 0; i < 5; ++i) talk.hear(hdt("s:HE0001,n:" + std::to_string(i)), 5.0 + i, "10.0.0.1:4001");
  EXPECT_EQ(talk.out.all<Alarm>().size(), 0u);
  talk.hear(hdt("s:HE0001,n:9"), 10.0, "10.0.0.1:4000");
  EXPECT_EQ(talk.end().all<Alarm>().size(), 1u) << "the first speaks again: there are two";
}

TEST(Iec61162_450, ASourceTakenOverLongAfterIsNoSecondSender) {
  Talk talk;
  talk.hear(hdt("s:HE0001,n:1"), 0.0, "10.0.0.1:4000");
  talk.hear(hdt("s:HE0001,n:2"), 11.0, "10.0.0.2:4000");
  EXPECT_EQ(talk.end().all<Alarm>().size(), 0u);
}

// --- damage and cuts ---

TEST(Iec61162_450, EverySplitGivesTheSame) {
  const std::string bytes = everything();
  const auto at_once = decode::make_iec61162_450({});
  const Decoded whole = decode_all(*at_once, as_bytes(bytes), kArrival);
  EXPECT_TRUE(covers(whole, bytes.size())) << classes(whole);
  for (std::size_t chunk = 1; chunk <= 64; ++chunk) {
    const auto decoder = decode::make_iec61162_450({});
    ASSERT_TRUE(same(whole, decode_all(*decoder, as_bytes(bytes), kArrival, chunk))) << chunk;
  }
  for (std::size_t split = 0; split <= bytes.size(); ++split) {
    const auto decoder = decode::make_iec61162_450({});
    Decoded out;
    decoder->feed(as_bytes(bytes).first(split), kArrival, out);
    decoder->feed(as_bytes(bytes).subspan(split), kArrival, out);
    decoder->finish(out);
    ASSERT_TRUE(same(whole, out)) << split << "\n" << classes(whole) << "\n" << classes(out);
  }
}

TEST(Iec61162_450, EveryPrefixIsAccountedFor) {
  const std::string bytes = everything();
  for (std::size_t size = 0; size <= bytes.size(); ++size)
    ASSERT_TRUE(covers(decode_udpbc(std::string_view(bytes).substr(0, size)), size)) << size;
}

TEST(Iec61162_450, NoChangedByteMakesAnotherFact) {
  const Decoded right = decode_udpbc(single());
  for (std::size_t at = 0; at < single().size(); ++at)
    for (int change = 1; change < 256; ++change) {
      std::string bytes = single();
      bytes[at] = static_cast<char>(bytes[at] ^ change);
      const Decoded d = decode_udpbc(bytes);
      ASSERT_TRUE(covers(d, bytes.size())) << at;
      for (const auto& fact : d.all<Heading>()) ASSERT_EQ(fact, right.all<Heading>()[0]) << at;
      const Decoded after_it = decode_udpbc(bytes + single());
      ASSERT_GE(after_it.all<Heading>().size(), 1u) << at << ": the next datagram is whole";
    }
}

TEST(Iec61162_450, ADatagramBehindAnyRubbishIsRead) {
  std::mt19937 random(7);
  for (int i = 0; i < 400; ++i) {
    std::string rubbish(random() % 1472, '\0');
    for (char& c : rubbish) c = static_cast<char>(random());
    if (i % 4 == 0) rubbish = "$" + rubbish;
    if (i % 4 == 1) rubbish = "#" + std::string(rubbish.size() * 3, 'a');
    const Decoded d = decode_udpbc(rubbish + single());
    ASSERT_TRUE(covers(d, rubbish.size() + 52));
    ASSERT_EQ(d.all<Heading>().size(), 1u) << i;
  }
}

TEST(Iec61162_450, LinesCutByTheNextDatagramAreTruncated) {
  const std::string bytes = single().substr(0, 40) + single();
  EXPECT_EQ(classes(decode_udpbc(bytes)), "[UdPbC] HDT!truncated [UdPbC] HDT");
}

}  // namespace
}  // namespace leadline::test
