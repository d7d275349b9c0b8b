#include "core/decode/profile.h"

namespace leadline::decode {
namespace {

using O = ProfileOptions;
using Keys = std::vector<Key<O>>;

Key<O> velocity_sign(std::string O::*member) {
  return {"velocity_sign",
          member,
          "whose motion it sends: its own, or the bottom's below it (check with a run ahead)",
          0,
          0,
          {"vehicle", "bottom"}};
}

void add_depth_keys(double O::*atmosphere_hpa, Keys& keys) {
  keys.push_back({"atmosphere_hpa", atmosphere_hpa,
                  "subtracted before pressure becomes depth; 0: the device has done it", 0, 1100});
  keys.push_back(
      {"latitude_deg", &O::latitude_deg, "of the dive, for the gravity in pressure to depth", -90, 90});
  keys.push_back({"density_kgm3", &O::density_kgm3,
                  "of the water, all the same down to the bottom; left out: the standard ocean", 900, 1200});
}

Keys nmea0183_keys() {
  return {
      {"usbl_order",
       &O::usbl_order,
       "PSIMSSB's U and R coordinates; auto: northing first, but easting with orientation E",
       0,
       0,
       {"auto", "northing-first", "easting-first"}},
      {"usbl_filtered", &O::usbl_filtered, "PSIMSSB fixes marked F, which the transceiver has filtered, too"},
      {"usbl_clock", &O::usbl_clock, "PSIMSSB's time of day; local: it is not used", 0, 0, {"utc", "local"}},
      {"usbl_hydrophones", &O::usbl_hydrophones, "valid ones that a PTSAG or PTSAX fix needs at least", 3, 4},
      {"pashr_roll_positive",
       &O::pashr_roll_positive,
       "which side is up where PASHR's roll is positive",
       0,
       0,
       {"port-up", "starboard-up"}},
      {"pashr_heave_positive",
       &O::pashr_heave_positive,
       "where PASHR's heave is positive",
       0,
       0,
       {"up", "down"}},
      {"zda_offset_s", &O::zda_offset_s, "added to ZDA: -1 or 1 where it tells a neighbouring second", -10,
       10},
      {"estimated_positions", &O::estimated_positions, "take positions the receiver calls estimated, too"},
      {"xdr_pitch", &O::xdr_pitch, "XDR transducers that tell pitch, bow up positive"},
      {"xdr_roll", &O::xdr_roll, "XDR transducers that tell roll, starboard down positive"},
  };
}

Keys valeport_keys() {
  Keys keys{{"unit", &O::valeport_unit, "of a value sent without one", 0, 0, {"dbar", "m"}},
            {"columns",
             &O::valeport_columns,
             "of rows of numbers",
             0,
             0,
             {"pressure_dbar", "depth_m", "sound_speed_mps", "sound_speed_mmps", "-"}}};
  add_depth_keys(&O::valeport_atmosphere_hpa, keys);
  return keys;
}

Keys paroscientific_keys() {
  Keys keys{{"unit",
             &O::paroscientific_unit,
             "the device is set to (UN); no string tells it; m: of water",
             0,
             0,
             {"psi", "hpa", "mbar", "bar", "kpa", "mpa", "inhg", "mmhg", "m"}}};
  add_depth_keys(&O::paroscientific_atmosphere_hpa, keys);
  return keys;
}

Keys mavlink_keys() {
  Keys keys;
  add_depth_keys(&O::mavlink_atmosphere_hpa, keys);
  return keys;
}

}  // namespace

std::vector<Key<ProfileOptions>> profile_keys(std::string_view decoder) {
  if (decoder == "nmea0183") return nmea0183_keys();
  if (decoder == "iec61162-450") {
    Keys keys = nmea0183_keys();
    keys.push_back({"header",
                    &O::udpbc_header,
                    "optional: plain sentences, a header without its NUL and lines that name no source, too",
                    0,
                    0,
                    {"required", "optional"}});
    return keys;
  }
  if (decoder == "trdi-pd6")
    return {{"axes",
             &O::pd6_axes,
             "of BI and WI; auto: trdi's until BS is seen to be their mirror image",
             0,
             0,
             {"auto", "trdi", "waterlinked"}}};
  if (decoder == "nortek-dvl") return {velocity_sign(&O::nortek_velocity)};
  if (decoder == "navquest") return {velocity_sign(&O::navquest_velocity)};
  if (decoder == "pni-tcm")
    return {{"byte_order",
             &O::pni_byte_order,
             "of the values; frames are big-endian always",
             0,
             0,
             {"big", "little"}}};
  if (decoder == "mavlink") return mavlink_keys();
  if (decoder == "valeport") return valeport_keys();
  if (decoder == "paroscientific") return paroscientific_keys();
  return {};
}

}  // namespace leadline::decode
