#include "core/decode/nmea0183_table.h"

#include <algorithm>

namespace leadline::decode::nmea0183 {
namespace {

// Standard sentences by their formatter, in alphabetical order. Known and unused ones are those the standard
// lists and public logs hold.
constexpr KnownSentence kStandard[] = {
    {"AAM", nullptr},  {"ABK", nullptr},  {"ABM", nullptr},  {"ALM", nullptr},  {"ALR", nullptr},
    {"APA", nullptr},  {"APB", nullptr},  {"BBM", nullptr},  {"BEC", nullptr},  {"BOD", nullptr},
    {"BWC", nullptr},  {"BWR", nullptr},  {"BWW", nullptr},  {"DBK", nullptr},  {"DBS", nullptr},
    {"DBT", read_dbt}, {"DPT", read_dpt}, {"DSC", nullptr},  {"DSE", nullptr},  {"DTM", nullptr},
    {"FSI", nullptr},  {"GBS", nullptr},  {"GFA", nullptr},  {"GGA", read_gga}, {"GLC", nullptr},
    {"GLL", read_gll}, {"GNS", read_gns}, {"GRS", nullptr},  {"GSA", nullptr},  {"GST", read_gst},
    {"GSV", nullptr},  {"GTD", nullptr},  {"HBT", nullptr},  {"HDG", read_hdg}, {"HDM", read_hdm},
    {"HDT", read_hdt}, {"HSC", nullptr},  {"LCD", nullptr},  {"MDA", nullptr},  {"MSK", nullptr},
    {"MSS", nullptr},  {"MTA", nullptr},  {"MTW", nullptr},  {"MWD", nullptr},  {"MWV", nullptr},
    {"OSD", nullptr},  {"RMA", nullptr},  {"RMB", nullptr},  {"RMC", read_rmc}, {"ROT", read_rot},
    {"RPM", nullptr},  {"RSA", nullptr},  {"RSD", nullptr},  {"RTE", nullptr},  {"SSD", nullptr},
    {"STI", nullptr},  {"STN", nullptr},  {"THS", read_ths}, {"TLL", nullptr},  {"TTM", nullptr},
    {"TXT", nullptr},  {"VBW", read_vbw}, {"VDM", nullptr},  {"VDO", nullptr},  {"VDR", nullptr},
    {"VHW", nullptr},  {"VLW", read_vlw}, {"VPW", nullptr},  {"VSD", nullptr},  {"VTG", read_vtg},
    {"VWR", nullptr},  {"VWT", nullptr},  {"WCV", nullptr},  {"WPL", nullptr},  {"XDR", read_xdr},
    {"XTE", nullptr},  {"XTR", nullptr},  {"ZDA", read_zda}, {"ZDL", nullptr},  {"ZFO", nullptr},
    {"ZTG", nullptr}};

// Makers' sentences by their address: whole where they are read, else by its beginning.
constexpr KnownSentence kMakers[] = {
    {"PSXN", read_psxn},   {"PSIMSSB", read_psimssb}, {"PASHR", read_pashr}, {"PRDID", read_prdid},
    {"PUHAW", read_puhaw}, {"PTSAG", read_ptsag},     {"PTSAX", read_ptsax}, {"PVIPS2", read_pvips2},
    {"PAIR", nullptr},     {"PDTINFO", nullptr},      {"PERC", nullptr},     {"PFEC", nullptr},
    {"PFST", nullptr},     {"PGLOR", nullptr},        {"PGRM", nullptr},     {"PJLT", nullptr},
    {"PKOD", nullptr},     {"PLCS", nullptr},         {"PMGL", nullptr},     {"PMGN", nullptr},
    {"PMTK", nullptr},     {"PNVG", nullptr},         {"PORZD", nullptr},    {"PQ", nullptr},
    {"PRWII", nullptr},    {"PRWIZCH", nullptr},      {"PSIMS", nullptr},    {"PSLIB", nullptr},
    {"PSRF", nullptr},     {"PSTI", nullptr},         {"PSTM", nullptr},     {"PTFT", nullptr},
    {"PTNL", nullptr},     {"PTNT", nullptr},         {"PTSAY", nullptr},    {"PUBX", nullptr}};

/// Five bits of each letter of a formatter: one number for each three capitals.
constexpr std::size_t slot(std::string_view formatter) {
  return static_cast<std::size_t>(formatter[0] & 31) << 10 |
         static_cast<std::size_t>(formatter[1] & 31) << 5 | static_cast<std::size_t>(formatter[2] & 31);
}

/// By slot: one more than the index in kStandard, 0 for none.
constexpr auto kIndex = [] {
  static_assert(std::size(kStandard) < 255);
  std::array<std::uint8_t, 32 * 32 * 32> index{};
  for (std::size_t i = 0; i < std::size(kStandard); ++i)
    index[slot(kStandard[i].kind)] = static_cast<std::uint8_t>(i + 1);
  return index;
}();

const KnownSentence* find_standard(std::string_view formatter) {
  const std::size_t found = kIndex[slot(formatter)];
  return found > 0 && kStandard[found - 1].kind == formatter ? &kStandard[found - 1] : nullptr;
}

const KnownSentence* find_maker(std::string_view address) {
  for (const KnownSentence& known : kMakers)
    if (known.read ? address == known.kind : address.substr(0, known.kind.size()) == known.kind)
      return &known;
  return nullptr;
}

}  // namespace

const KnownSentence* find_sentence(std::string_view address, bool encapsulated) {
  const bool standard = address.size() == 5 && address[0] != 'P';
  const KnownSentence* known = nullptr;
  if (standard)
    known = find_standard(address.substr(2));
  else if (!address.empty() && address[0] == 'P')
    known = find_maker(address);
  return known && encapsulated && known->read ? nullptr : known;
}

std::string_view UnknownNames::intern(std::string_view address) {
  const bool plain = std::all_of(address.begin(), address.end(), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
  });
  if (address.empty() || !plain) return "other";
  const std::string_view name =
      address.size() == 5 && address[0] != 'P' ? address.substr(2) : address.substr(0, 16);
  for (std::size_t i = 0; i < count_; ++i)
    if (names_[i].view() == name) return names_[i].view();
  if (count_ == names_.size()) return "other";
  names_[count_] = Text<16>(name);
  return names_[count_++].view();
}

}  // namespace leadline::decode::nmea0183
