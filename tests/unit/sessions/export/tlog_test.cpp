#include "sessions/export/tlog.h"

#include <gtest/gtest.h>

#include "core/links/tlog_source.h"
#include "tests/unit/sessions/made_session.h"

namespace leadline::sessions {
namespace {

using test::MadeFolder;

std::vector<test::KeptEnvelope> frames_of(const std::vector<std::string>& payloads) {
  std::vector<test::KeptEnvelope> all;
  for (const auto& payload : payloads) {
    auto& kept = all.emplace_back();
    kept.bytes.assign(payload.begin(), payload.end());
    kept.envelope.seq = all.size();
    kept.envelope.message = RawFrame{};
    kept.envelope.source = static_cast<SourceId>(all.size() % 2);
    kept.envelope.arrival = {test::kStartNs + static_cast<std::int64_t>(all.size()) * 1'234'567'000};
    kept.envelope.valid = kept.envelope.wall_utc = kept.envelope.arrival.host();
  }
  return all;
}

std::string exported(const MadeFolder& folder, const std::vector<test::KeptEnvelope>& frames,
                     TlogFigures& figures) {
  const std::string path = folder.file("s.leadline"), log = folder.file("s.tlog");
  test::make_session(path, frames);
  auto session = Session::open(path, Access::read).value();
  std::FILE* out = std::fopen(log.c_str(), "wb");
  const auto done = export_tlog(session, out);
  std::fclose(out);
  EXPECT_TRUE(done) << done.error().line();
  if (done) figures = done.value();
  return log;
}

TEST(Tlog, SentencesAreTextAndEverythingElseIsHex) {
  MadeFolder folder;
  TlogFigures figures;
  const std::string log = exported(
      folder,
      frames_of({"$GPHDT,1.5,T*0A\r\n", "$GPHDT,1.5,T*0A\n", "$GPHDT,no end", "two\nlines\n",
                 std::string("\x7f\x7f\x00", 3), "#7f\n", " blank first\n", "\n", "", "caf\xc3\xa9\n"}),
      figures);
  EXPECT_EQ(test::content(log),
            "(1700000001.234567) gps $GPHDT,1.5,T*0A\r\n"
            "(1700000002.469134) dvl $GPHDT,1.5,T*0A\n"
            "(1700000003.703701) gps #2447504844542c6e6f20656e64\n"
            "(1700000004.938268) dvl #74776f0a6c696e65730a\n"
            "(1700000006.172835) gps #7f7f00\n"
            "(1700000007.407402) dvl #2337660a\n"
            "(1700000008.641969) gps #20626c616e6b2066697273740a\n"
            "(1700000009.876536) dvl #0a\n"
            "(1700000011.111103) gps #\n"
            "(1700000012.345670) dvl #636166c3a90a\n");
  EXPECT_EQ(figures.frames, 10U);
  EXPECT_EQ(figures.lines, 10U);
}

TEST(Tlog, ReadBackItGivesTheSameBytesAtTheSameArrivals) {
  MadeFolder folder;
  test::MessageMaker maker;
  std::vector<std::string> payloads;
  for (int i = 0; i < 500; ++i) {
    std::string payload;
    const auto length = maker.random() % 60;
    for (std::uint32_t k = 0; k < length; ++k)
      payload += static_cast<char>(i % 2 ? ' ' + maker.random() % 95 : maker.random() % 256);
    if (i % 4 < 3) payload += i % 4 ? "\r\n" : "\n";
    payloads.push_back(payload);
  }
  payloads.push_back(std::string(100'000, 'x'));
  const auto frames = frames_of(payloads);
  TlogFigures figures;
  links::TlogSource source(links::FileReader::open(exported(folder, frames, figures)).value(),
                           {{"dvl", 0}, {"gps", 1}});
  EXPECT_EQ(figures.lines, frames.size() + 4) << "the long one in five pieces";
  Chunk chunk;
  for (std::size_t i = 0; i + 1 < frames.size(); ++i) {
    ASSERT_TRUE(source.next(chunk));
    ASSERT_EQ(std::vector<std::uint8_t>(chunk.bytes.begin(), chunk.bytes.end()), frames[i].bytes) << i;
    ASSERT_EQ(chunk.arrival, frames[i].envelope.arrival);
    ASSERT_EQ(chunk.source, frames[i].envelope.source);
    ASSERT_FALSE(chunk.settled) << i;
  }
  std::vector<std::uint8_t> rest;
  while (source.next(chunk)) rest.insert(rest.end(), chunk.bytes.begin(), chunk.bytes.end());
  EXPECT_EQ(rest, frames.back().bytes);
}

}  // namespace
}  // namespace leadline::sessions
