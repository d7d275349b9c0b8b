#include "core/geo/tools/cof_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/support/files.h"

namespace leadline::geo {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
namespace fs = std::filesystem;

std::string noaa(const std::string& name) {
  return std::string(LEADLINE_SOURCE_DIR) + "/core/geo/magnetic/" + name;
}

class CofFileTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / "leadline_cof";
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// NOAA's 2025 file with the first `from` turned into `to`.
  std::string spoilt(const std::string& from, const std::string& to) {
    std::string text = test::read_text(noaa("WMM_2025.COF"));
    const auto where = text.find(from);
    EXPECT_NE(where, std::string::npos);
    text.replace(where, from.size(), to);
    const std::string path = (folder_ / "spoilt.COF").string();
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }

  fs::path folder_;
};

std::int32_t int_at(const std::string& bytes, std::size_t offset) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<std::uint8_t>(bytes[offset + i]);
  return static_cast<std::int32_t>(value);
}

double double_at(const std::string& bytes, std::size_t offset) {
  std::uint64_t bits = 0;
  for (std::size_t i = 8; i-- > 0;) bits = bits << 8 | static_cast<std::uint8_t>(bytes[offset + i]);
  double value = 0.0;
  std::memcpy(&value, &bits, 8);
  return value;
}

TEST_F(CofFileTest, ReadsNoaasCoefficients) {
  const CofFile cof = read_cof(noaa("WMM_2025.COF")).value();
  EXPECT_EQ(cof.epoch_year, 2025.0);
  EXPECT_EQ(cof.name, "WMM-2025");
  EXPECT_EQ(cof.release_date, "11/13/2024");
  EXPECT_EQ(cof.g[1][0], -29351.8);
  EXPECT_EQ(cof.h[1][1], 4545.4);
  EXPECT_EQ(cof.g_rate[2][1], -5.2);
  EXPECT_EQ(cof.h_rate[1][1], -21.5);
  EXPECT_EQ(cof.g[12][12], -0.7);
}

TEST_F(CofFileTest, WritesTheCoefficientsOrderByOrder) {
  const CofFile cof = read_cof(noaa("WMM_2025.COF")).value();
  ASSERT_TRUE(write_wmm(cof, folder_.string(), "wmm2025").ok());
  const std::string bytes = test::read_text((folder_ / "wmm2025.wmm.cof").string());

  const std::size_t cosines = 91, sines = 78, set = 8 + 8 * (cosines + sines);
  ASSERT_EQ(bytes.size(), 8 + 2 * set);
  EXPECT_EQ(bytes.substr(0, 8), "WMM2025-");
  const Harmonics* expected[2][2] = {{&cof.g, &cof.h}, {&cof.g_rate, &cof.h_rate}};
  std::size_t at = 8;
  for (const auto& [cosine, sine] : expected) {
    EXPECT_EQ(int_at(bytes, at), 12);
    EXPECT_EQ(int_at(bytes, at + 4), 12);
    at += 8;
    EXPECT_EQ(double_at(bytes, at), 0.0);  // C(0,0): there are no magnetic monopoles
    for (std::size_t m = 0; m <= 12; ++m)
      for (std::size_t n = m; n <= 12; ++n, at += 8)
        EXPECT_EQ(double_at(bytes, at), (*cosine)[n][m]) << n << " " << m;
    for (std::size_t m = 1; m <= 12; ++m)
      for (std::size_t n = m; n <= 12; ++n, at += 8)
        EXPECT_EQ(double_at(bytes, at), (*sine)[n][m]) << n << " " << m;
  }
}

TEST_F(CofFileTest, BytesAreLittleEndian) {
  CofFile cof = read_cof(noaa("WMM_2020.COF")).value();
  cof.g[1][0] = 1.0;  // 3FF0000000000000
  ASSERT_TRUE(write_wmm(cof, folder_.string(), "wmm2020").ok());
  const std::string bytes = test::read_text((folder_ / "wmm2020.wmm.cof").string());
  EXPECT_EQ(bytes.substr(8, 4), std::string("\x0C\0\0\0", 4));
  EXPECT_EQ(bytes.substr(24, 8), std::string("\0\0\0\0\0\0\xF0\x3F", 8));
}

TEST_F(CofFileTest, MetadataHoldsEpochAndFiveYears) {
  ASSERT_TRUE(write_wmm(read_cof(noaa("WMM_2015v2.COF")).value(), folder_.string(), "wmm2015v2").ok());
  const std::string text = test::read_text((folder_ / "wmm2015v2.wmm").string());
  EXPECT_EQ(text.substr(0, 7), "WMMF-1\n");
  for (const char* line :
       {"\nEpoch           2015\n", "\nMaxTime         2020\n", "\nNormalization   schmidt\n",
        "\nByteOrder       little\n", "\nID              WMM2015V\n"})
    EXPECT_THAT(text, HasSubstr(line));
}

TEST_F(CofFileTest, MalformedFilesAreRefusedWithFileAndLine) {
  const auto refused_at = [](const std::string& path) {
    const auto cof = read_cof(path);
    return cof.ok() ? "accepted" : cof.error().where;
  };
  EXPECT_THAT(refused_at(spoilt("    2025.0            WMM-2025     11/13/2024", "WMM-2025 2025.0")),
              EndsWith("spoilt.COF:1"));
  EXPECT_THAT(refused_at(spoilt("2025.0", "25.0")), EndsWith("spoilt.COF:1"));
  EXPECT_THAT(refused_at(spoilt("-1410.8", "-14l0.8")), EndsWith("spoilt.COF:3"));
  EXPECT_THAT(refused_at(spoilt("-21.5\n", "\n")), EndsWith("spoilt.COF:3"));
  EXPECT_THAT(refused_at(spoilt("-21.5\n", "-21.5 7\n")), EndsWith("spoilt.COF:3"));
  EXPECT_THAT(refused_at(spoilt("  2  0  ", "  2  1  ")), EndsWith("spoilt.COF:4"));
  EXPECT_THAT(refused_at(spoilt("999999999999999999999999999999999999999999999999\n", "")),
              "accepted");  // NOAA closes twice
  EXPECT_THAT(refused_at(spoilt("\n9999", "\n8888")), EndsWith("spoilt.COF:92"));
  EXPECT_THAT(refused_at((folder_ / "absent.COF").string()), EndsWith("absent.COF"));
}

TEST_F(CofFileTest, AFileCutAfterARowIsRefused) {
  const std::string text = test::read_text(noaa("WMM_2025.COF"));
  const std::string path = (folder_ / "cut.COF").string();
  std::ofstream(path, std::ios::binary) << text.substr(0, text.find("  3  0"));
  const auto cof = read_cof(path);
  ASSERT_FALSE(cof.ok());
  EXPECT_THAT(cof.error().where, EndsWith("cut.COF:7"));
}

TEST_F(CofFileTest, AFolderThatIsNotThereIsAnError) {
  const auto written = write_wmm(CofFile{}, (folder_ / "nowhere").string(), "wmm");
  ASSERT_FALSE(written.ok());
  EXPECT_THAT(written.error().where, HasSubstr("nowhere"));
}

}  // namespace
}  // namespace leadline::geo
