#include "core/links/sniff.h"

#include "tests/support/decoder_harness.h"
#include "tests/support/files.h"
#include "tests/unit/core/links/made_file.h"

namespace leadline::links {
namespace {

FileKind kind_of(std::string_view content) {
  return sniff(test::as_bytes(content.substr(0, kSniffBytes)), content.size());
}

std::string bytes(std::initializer_list<int> values) {
  std::string text;
  for (const int v : values) text += static_cast<char>(v);
  return text;
}

TEST(Sniff, TellsTextInstrumentsByTheirLines) {
  const std::string serial =
      "wrx,112.83,0.007,0.017,0.006,0.000,0.93,y,0*d2\r\nwru,0,0.070,1.10,-40,-95*9c\r\n";
  EXPECT_EQ(kind_of(serial), FileKind::waterlinked_serial);
  EXPECT_NE(kind_of("wrx,112.83,0.007,0.017,0.006,0.000,0.93,y,0*d3\r\n"), FileKind::waterlinked_serial)
      << "its CRC fails";
  EXPECT_EQ(kind_of(R"({"vx":0.1,"format":"json_v3.1","type":"velocity"})"
                    "\n"),
            FileKind::waterlinked_json);
  EXPECT_EQ(kind_of(R"({"vx":0.1})"
                    "\n"),
            FileKind::text);
  EXPECT_EQ(kind_of("$#NQ.RES 0X0000 1 1 1 1 4.3 4.5 4.3 4.2\r\n"), FileKind::navquest);
  EXPECT_EQ(kind_of("*0001174.63512\r\n*0001UN=1\r\n*0001174.63514\r\n"), FileKind::paroscientific);
  EXPECT_NE(kind_of("*1\r\n*2\r\n"), FileKind::paroscientific);
}

TEST(Sniff, TellsEveryBundledFileByItsContent) {
  struct Case {
    const char* file;
    FileKind kind;
  };
  const Case cases[] = {
      {"wire-samples/udpbc_single.bin", FileKind::iec61162_450},
      {"wire-samples/udpbc_group.bin", FileKind::iec61162_450},
      {"dvl_pd0_adcp/RDI_7f79.000", FileKind::trdi_pd0},
      {"dvl_pd0_adcp/RDI_test01.000", FileKind::trdi_pd0},
      {"dvl_pd0_adcp/RDI_withBT.000", FileKind::trdi_pd0},
      {"dvl_pd0_adcp/RiverPro_test01.PD0", FileKind::trdi_pd0},
      {"dvl_pd0_adcp/sentinelv_b5.pd0", FileKind::trdi_pd0},
      {"dvl_pd0_adcp/winriver01.PD0", FileKind::trdi_pd0},
      {"dvl_pd0_adcp/winriver02.PD0", FileKind::trdi_pd0},
      {"dvl_pd0_remus600/adcp_auv_3.pd0", FileKind::trdi_pd0},
      {"dvl_pd0_remus600/adcp_auv_51.pd0", FileKind::trdi_pd0},
      {"dvl_pd0_remus600/glider/LA100204.PD0", FileKind::trdi_pd0},
      {"dvl_pd0_remus600/glider/LA281913.PD0", FileKind::trdi_pd0},
      {"dvl_pd0_remus600/glider/LB180210_3_corrupted.PD0", FileKind::trdi_pd0},
      {"dvl_pd0_remus600/glider/LB180210_50.PD0", FileKind::trdi_pd0},
      {"dvl_pd0_remus600/glider/ND072023.PD0", FileKind::trdi_pd0},
      {"dvl_pd0_remus600/glider/NE051400.PD0", FileKind::trdi_pd0},
      {"wire-samples/pd0_range_msb.bin", FileKind::trdi_pd0},
      {"wire-samples/pd0_ship_bt.bin", FileKind::trdi_pd0},
      {"wire-samples/pd0_ship_bt_invalid.bin", FileKind::trdi_pd0},
      {"wire-samples/nmea.txt", FileKind::nmea},
      {"wire-samples/ALL.txt", FileKind::text},
      {"nmea_gpsd/ac12.log", FileKind::nmea},
      {"nmea_gpsd/ait250.log", FileKind::nmea},
      {"nmea_openrvdas_nbp1406/NBP1406_adcp-2014-08-01", FileKind::stamped_text},
      {"nmea_openrvdas_nbp1406/NBP1406_gp02-2014-08-01", FileKind::stamped_text},
      {"nmea_openrvdas_nbp1406/NBP1406_gyr1-2014-08-01", FileKind::stamped_text},
      {"nmea_openrvdas_nbp1406/NBP1406_knud-2014-08-01", FileKind::stamped_text},
      {"nmea_openrvdas_nbp1406/NBP1406_mbdp-2014-08-01", FileKind::stamped_text},
      {"nmea_openrvdas_nbp1406/NBP1406_s330-2014-08-01", FileKind::stamped_text},
      {"nmea_openrvdas_nbp1406/NBP1406_svp1-2014-08-01", FileKind::stamped_text},
      {"geomag_wmm/WMM2015v2testvalues.txt", FileKind::table},
      {"geomag_wmm/WMM2020_TEST_VALUES.txt", FileKind::table},
      {"geomag_wmm/WMM2020testvalues.txt", FileKind::table},
      {"geomag_wmm/WMM2025_TEST_VALUES.txt", FileKind::table},
      {"reference-navigation/fusion_1h.csv", FileKind::table},
      {"wire-samples/nortek_df21.bin", FileKind::nortek_dvl},
      {"wire-samples/xsens_mtdata2.bin", FileKind::xsens_mtdata2},
      {"wire-samples/pni_data.bin", FileKind::pni_tcm},
      {"ardusub_mavlink/small.tlog", FileKind::mavlink},
      {"reference-navigation/fusion_1h.txt", FileKind::text},
      {"usbl_psimssb_lines/lines.tsv", FileKind::text},
      {"dvl_pd0_remus600/adcp_auv_51.yml", FileKind::text},
      {"dvl_pd0_adcp/SOURCE.md", FileKind::text},
  };
  for (const Case& c : cases) {
    auto file = FileReader::open(test::data_path(c.file));
    ASSERT_TRUE(file) << file.error().line();
    const FileKind kind = sniff(file.value().peek(kSniffBytes), file.value().size());
    EXPECT_EQ(kind, c.kind) << c.file << " was taken for " << name_of(kind);
  }
}

TEST(Sniff, TellsTextInputsApart) {
  EXPECT_EQ(kind_of(""), FileKind::empty);
  EXPECT_EQ(kind_of("(1795350919.500000) gps $GPZDA,1*00\n(1795350919.6"), FileKind::tlog);
  EXPECT_EQ(kind_of("# made\n\n(1795350919.500000) dvl #7f7f0a\n"), FileKind::tlog);
  EXPECT_EQ(kind_of("\xEF\xBB\xBF(1.5) dvl #7f7f0a\n"), FileKind::tlog);
  EXPECT_EQ(kind_of("2014-08-01T00:00:00.003000Z 1631.00\n"), FileKind::stamped_text);
  EXPECT_EQ(kind_of("$GPZDA,123519.50,22,11,2026,00,00*68\r\n"), FileKind::nmea);
  EXPECT_EQ(kind_of("\\s:IN0001*59\\$HEHDT,001.7,T*29\r\n!AIVDM,1,1,,A,x,0*00\r\n"), FileKind::nmea);
  EXPECT_EQ(kind_of("1.0,2.0,3.0\n1.1,2.0,nan\n"), FileKind::table);
  EXPECT_EQ(kind_of("t,a,b\n1.0;2.0\n1.1;2.0\n1.2;\n1.3;-4e-3\n"), FileKind::table);
  EXPECT_EQ(kind_of("  1  2\n 10\t20\n"), FileKind::table);
  EXPECT_EQ(kind_of("% Matlab\n% comment\n2017/08/01 00:00:00.5 1.0 2.0\n"), FileKind::table);
  EXPECT_EQ(kind_of("2017-08-01 00:00:00.5 1.0 2.0\n2017-08-01 00:00:00.6 1.0 2.0\n"), FileKind::table)
      << "date and time columns are no arrival stamp";
  EXPECT_EQ(kind_of("Dear diary,\ntoday we dived.\n"), FileKind::text);
}

TEST(Sniff, TellsInstrumentsApartByWhatTheirTelegramsProve) {
  const std::string usbl = "user data+++AT:9:RECVIM,1,\r\nmore";
  EXPECT_EQ(kind_of(usbl.substr(9)), FileKind::evologics_usbl);
  EXPECT_EQ(kind_of(usbl + usbl), FileKind::evologics_usbl);
  EXPECT_EQ(kind_of(usbl), FileKind::text) << "one alone may be a quotation";
  EXPECT_EQ(kind_of("+++AT:8:RECVIM,1,\r\nmore"), FileKind::text);
  EXPECT_EQ(kind_of("$PNORBT7,1.0*00\r\n$PNORWT7,1.0*00\r\n"), FileKind::nortek_dvl);
  EXPECT_EQ(kind_of("$PNORBT7,1.0*00\r\n$HEHDT,1.7,T*00\r\n"), FileKind::nmea);
  const std::string pni = bytes({0, 5, 4, 0xBF, 0x71});
  EXPECT_EQ(kind_of(pni + pni + "x"), FileKind::pni_tcm);
  EXPECT_NE(kind_of(pni + "xxxxx"), FileKind::pni_tcm);
  const std::string xsens = bytes({0xFA, 0xFF, 0x36, 0, 0xCB});
  EXPECT_EQ(kind_of("?" + xsens), FileKind::xsens_mtdata2);
  EXPECT_NE(kind_of(bytes({0xFA, 0xFF, 0x36, 0, 0xCC})), FileKind::xsens_mtdata2);
}

TEST(Sniff, TellsBinaryInputsApart) {
  const std::string zeros(100, '\0');
  std::string sqlite = std::string("SQLite format 3\0", 16) + zeros;
  EXPECT_EQ(kind_of(sqlite), FileKind::sqlite);
  EXPECT_EQ(sqlite_application_id(test::as_bytes(sqlite)), 0u);
  sqlite.replace(68, 4, "LDLN");
  EXPECT_EQ(kind_of(sqlite), FileKind::session);
  EXPECT_EQ(sqlite_application_id(test::as_bytes(sqlite)), kSessionApplicationId);
  EXPECT_EQ(sqlite_application_id(test::as_bytes("SQLite format 3")), std::nullopt);

  std::string xtf(4096, '\0');
  xtf[0] = 0x7B;
  EXPECT_EQ(kind_of(xtf), FileKind::unknown);
  std::string wide = xtf;
  xtf.replace(1024, 2, bytes({0xCE, 0xFA}));
  wide.replace(2048, 2, bytes({0xCE, 0xFA}));
  EXPECT_EQ(kind_of(xtf), FileKind::xtf);
  EXPECT_EQ(kind_of(wide), FileKind::xtf) << "more than six channels";

  const std::string header = bytes({0x01, 0x16, 0x0D, 0, 0x50, 0, 0, 0x14, 0, 0, 0, 0, 4, 0, 0, 0});
  EXPECT_EQ(kind_of(header + "abcd" + header + "abcd"), FileKind::jsf);
  EXPECT_EQ(kind_of(header + "abcdefgh" + header), FileKind::unknown);

  EXPECT_EQ(kind_of(bytes({0xD4, 0xC3, 0xB2, 0xA1}) + zeros), FileKind::pcap);
  EXPECT_EQ(kind_of(bytes({0xA1, 0xB2, 0x3C, 0x4D}) + zeros), FileKind::pcap);
  EXPECT_EQ(kind_of(bytes({0x0A, 0x0D, 0x0D, 0x0A, 28, 0, 0, 0, 0x4D, 0x3C, 0x2B, 0x1A}) + zeros),
            FileKind::pcapng);

  const std::string stamp = bytes({0x00, 0x06, 0x60, 0xDE, 0x4F, 0x50, 0x60, 0x70});
  const std::string v1 = stamp + bytes({0xFE, 2, 0, 1, 1, 0, 7, 7, 0xAA, 0xBB});
  const std::string v2 = stamp + bytes({0xFD, 2, 0, 0, 0, 1, 1, 0, 0, 0, 7, 7, 0xAA, 0xBB});
  EXPECT_EQ(kind_of(v1 + v2 + v1), FileKind::mavlink);
  EXPECT_EQ(kind_of(v2), FileKind::mavlink);
  EXPECT_EQ(kind_of(v1 + zeros), FileKind::unknown);
}

TEST(Sniff, FindsPd0BehindGarbageByAChecksumThatHolds) {
  std::string ensemble = test::read_text(test::data_path("wire-samples/pd0_ship_bt.bin"));
  EXPECT_EQ(kind_of(std::string(5000, '\x7F') + ensemble), FileKind::trdi_pd0);
  EXPECT_EQ(kind_of("$GPZDA,123519.50,22,11,2026,00,00*68\r\n" + ensemble), FileKind::trdi_pd0);
  ensemble[100] = static_cast<char>(ensemble[100] ^ 1);
  EXPECT_EQ(kind_of(ensemble), FileKind::unknown);
  EXPECT_EQ(kind_of(std::string(kSniffBytes, '\x7F')), FileKind::unknown);
}

TEST(Sniff, FindsNmeaAmongBinaryByChecksumsThatHold) {
  const std::string sentence = "$HEHDT,001.7,T*29\r\n";
  const std::string junk = bytes({0xB5, 0x62, 1, 7, 0, 0, 0x80, 0xFF});
  EXPECT_EQ(kind_of(junk + sentence + junk + sentence), FileKind::nmea);
  EXPECT_EQ(kind_of(junk + sentence), FileKind::unknown);
}

TEST(Sniff, AnyBytesHaveAKindWithAName) {
  std::mt19937 random(1);
  const std::string pd0 = test::read_text(test::data_path("dvl_pd0_remus600/adcp_auv_3.pd0"));
  const std::string nmea = test::read_text(test::data_path("wire-samples/nmea.txt"));
  for (int i = 0; i < 2000; ++i) {
    const std::string bad = test::damaged(i % 2 == 0 ? pd0 : nmea, random, i % 4 < 2 ? 2.0 : 100.0);
    const FileKind kind = kind_of(bad);
    ASSERT_STRNE(name_of(kind), "");
    ASSERT_EQ(kind == FileKind::empty, bad.empty());
  }
}

}  // namespace
}  // namespace leadline::links
