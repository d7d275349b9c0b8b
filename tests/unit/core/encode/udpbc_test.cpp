#include "core/encode/udpbc.h"

#include <gtest/gtest.h>

#include <string>

#include "core/decode/iec61162_450.h"
#include "core/encode/sentence.h"
#include "tests/support/decoder_harness.h"
#include "tests/support/files.h"

namespace leadline::encode {
namespace {

Telegrams headings(int count) {
  Telegrams out;
  for (int i = 0; i < count; ++i) Sentence(out, "HE", "HDT").heading(Angle::deg(1.7 + i), 1).text("T");
  return out;
}

test::Decoded heard(const Telegrams& datagrams) {
  return test::decode_all(*decode::make_iec61162_450({}), test::as_bytes(datagrams.bytes), Arrival{0});
}

TEST(Udpbc, OneSentenceIsOneLine) {
  Udpbc udpbc("IN0001", "NV0002");
  Telegrams out;
  for (int i = 0; i <= 17; ++i) out.clear(), udpbc.wrap(headings(1), out);
  ASSERT_EQ(out.size(), 1u);
  std::string sample = test::read_text(test::data_path("wire-samples/udpbc_single.bin"));
  sample.replace(sample.find("001.7"), 5, "1.7");
  sample.replace(sample.find("*29"), 3, "*29");  // two zeros less: the same sum
  EXPECT_EQ(out.bytes, sample);
}

TEST(Udpbc, SeveralSentencesAreOneGroupThatIsReadBack) {
  Udpbc udpbc("IN0001");
  Telegrams out;
  udpbc.wrap(headings(3), out);
  ASSERT_EQ(out.size(), 1u);
  EXPECT_EQ(out.bytes.find("\\g:1-3-1,s:IN0001,n:0*"), 6u);
  const auto d = heard(out);
  EXPECT_EQ(d.all<Heading>().size(), 3u);
  EXPECT_EQ(d.ledger.refusals().size(), 0u);
}

TEST(Udpbc, DatagramsStayInTheirBoundAndCountsWrap) {
  Udpbc udpbc("IN0001");
  Telegrams all;
  for (int i = 0; i < 150; ++i) udpbc.wrap(headings(14), all);
  std::string joined;
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_LE(all[i].size(), Udpbc::kLongestDatagram);
    EXPECT_EQ(all[i].substr(0, 6), std::string_view("UdPbC\0", 6));
  }
  const auto d = heard(all);
  EXPECT_EQ(d.all<Heading>().size(), 2100u) << "n wraps at 999, groups at 99";
  EXPECT_EQ(d.ledger.lost(), 0u);
  Telegrams many;
  Udpbc("IN0001").wrap(headings(60), many);
  EXPECT_GT(many.size(), 1u);
  for (std::size_t i = 0; i < many.size(); ++i) EXPECT_LE(many[i].size(), Udpbc::kLongestDatagram);
}

TEST(Udpbc, NothingIsNoDatagram) {
  Telegrams out;
  Udpbc("IN0001").wrap(Telegrams{}, out);
  EXPECT_EQ(out.size(), 0u);
  EXPECT_TRUE(good_sfi("IN0001"));
  for (const char* bad : {"", "IN001", "in0001", "IN00011", "I10001"}) EXPECT_FALSE(good_sfi(bad)) << bad;
}

}  // namespace
}  // namespace leadline::encode
