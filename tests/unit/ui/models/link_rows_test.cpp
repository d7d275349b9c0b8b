#include "ui/models/link_rows.h"

#include <gtest/gtest.h>

#include "ui/bridge/snapshot.h"

namespace leadline::ui {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

Snapshot snapshot() {
  Snapshot s;
  s.now = *parse_iso8601("2026-09-14T14:02:37Z");
  SourceState dvl, usbl, beacon;
  dvl.name = "dvl", dvl.rate_hz = 5.0, dvl.period_s = 0.2, dvl.last = s.now - milliseconds(200);
  dvl.latency_s = 0.041;
  usbl.name = "usbl", usbl.rate_hz = 0.125, usbl.period_s = 8.0, usbl.last = s.now - seconds(3);
  usbl.latency_s = 1.1, usbl.refused = 12, usbl.last_refusal = "checksum";
  beacon.name = "beacon", beacon.rate_hz = 1.0, beacon.period_s = 1.0, beacon.last = s.now - seconds(14);
  beacon.refused = 2, beacon.last_refusal = "range";
  s.sources = {dvl, usbl, beacon};
  return s;
}

LinkState link(const char* address, std::vector<SourceId> sources, bool open, const char* error = "") {
  return {address, std::move(sources), open, error, 1'234'567, 8'910, 0};
}

TEST(LinkRows, AreTheSumOfTheirSources) {
  const auto rows =
      link_rows({link("udp://:4001", {0}, true), link("udp://:4002", {1, 2}, true)}, snapshot());
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].names, std::vector<std::string>{"dvl"});
  EXPECT_EQ(rows[0].refused, 0U);
  EXPECT_EQ(rows[0].heard, ValueState::live);
  EXPECT_EQ(rows[1].names, (std::vector<std::string>{"usbl", "beacon"}));
  EXPECT_DOUBLE_EQ(rows[1].rate_hz, 1.125);
  EXPECT_EQ(rows[1].refused, 14U);
  EXPECT_EQ(rows[1].last_refusal, "checksum") << "of the one heard last";
  EXPECT_DOUBLE_EQ(*rows[1].latency_s, 1.1);
  EXPECT_NEAR(*rows[1].age_s, 3.0, 1e-9) << "the youngest of its sources";
  EXPECT_EQ(rows[1].heard, ValueState::live) << "3 s is young where one comes each 8 s";
}

TEST(LinkRows, FailedIsClosedWithAReasonAndAHealedLinkKeepsItsLastError) {
  const auto rows =
      link_rows({link("udp://:1", {0}, true, "connection refused"), link("udp://:2", {1}, false),
                 link("serial:///dev/ttyS0", {2}, false, "permission denied")},
                snapshot());
  EXPECT_EQ(rows[0].state, LinkRow::State::open);
  EXPECT_EQ(rows[1].state, LinkRow::State::closed);
  EXPECT_EQ(rows[2].state, LinkRow::State::failed);
  EXPECT_EQ(link_cells(rows[0])[2], "open");
  EXPECT_EQ(link_cells(rows[1])[2], "closed");
  EXPECT_EQ(link_cells(rows[2])[2], "failed · permission denied");
  EXPECT_EQ(link_trouble(rows[0]), "last error: connection refused");
  EXPECT_EQ(link_trouble(rows[2]), "last error: permission denied · last refusal: range");
  EXPECT_EQ(rows[2].heard, ValueState::stale);
  EXPECT_EQ(links_open(rows), "1 of 3 open");
}

TEST(LinkRows, OfWhatWasNeverHeardNothingIsInvented) {
  const auto rows = link_rows({{"tcp://10.0.0.9:7000", {9}, false, "", 0, 0, 0}}, snapshot());
  EXPECT_TRUE(rows[0].names.empty());
  EXPECT_FALSE(rows[0].age_s || rows[0].latency_s);
  EXPECT_EQ(rows[0].heard, ValueState::lost);
  EXPECT_EQ(link_cells(rows[0]),
            (LinkCells{"", "tcp://10.0.0.9:7000", "closed", "0 B", "0", "", "0", "", "0", ""}));
  EXPECT_EQ(link_trouble(rows[0]), "");
}

TEST(LinkRows, FiguresReadAtAGlance) {
  LinkRow row;
  row.rate_hz = 5.0, row.latency_s = 0.041, row.age_s = 14.2, row.kernel_drops = 1'204,
  row.frames = 1'234'567;
  const auto bytes = [&](std::uint64_t n) {
    row.bytes = n;
    return link_cells(row)[3];
  };
  EXPECT_EQ(bytes(999), "999 B");
  EXPECT_EQ(bytes(1'000), "1.00 kB");
  EXPECT_EQ(bytes(12'345), "12.3 kB");
  EXPECT_EQ(bytes(999'499), "999 kB");
  EXPECT_EQ(bytes(999'500), "1.00 MB");
  EXPECT_EQ(bytes(7'300'000'000), "7.30 GB");
  EXPECT_EQ(bytes(18'000'000'000'000'000'000U), "18000000 TB");
  const LinkCells cells = link_cells(row);
  EXPECT_EQ(cells[4], "1 234 567");
  LinkRow many = row;
  many.frames = 11'204'311, many.refused = 104'000, many.kernel_drops = 10'000;
  EXPECT_EQ(link_cells(many)[4], "11.2 M");
  EXPECT_EQ(link_cells(many)[6], "104 k");
  EXPECT_EQ(link_cells(many)[8], "10.0 k");
  EXPECT_EQ(cells[5], "5.0 Hz");
  EXPECT_EQ(cells[7], "41 ms");
  EXPECT_EQ(cells[8], "1 204");
  EXPECT_EQ(cells[9], "14 s");
  EXPECT_EQ(link_trouble(row), "1 204 dropped by the kernel, which had no room");
}

}  // namespace
}  // namespace leadline::ui
