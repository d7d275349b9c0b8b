#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/types/option_key.h"

namespace leadline::decode {

/// What makers and installations do differently and no telegram tells: the keys a [[source]] has besides the
/// common ones. Each decoder reads its own, see profile_keys.
struct ProfileOptions {
  // nmea0183
  std::string usbl_order = "auto";
  bool usbl_filtered = false;
  std::string usbl_clock = "utc";
  std::int64_t usbl_hydrophones = 3;
  std::string pashr_roll_positive = "port-up", pashr_heave_positive = "up";
  double zda_offset_s = 0.0;
  bool estimated_positions = false;
  std::vector<std::string> xdr_pitch = {"PTCH", "PITCH"}, xdr_roll = {"ROLL", "HEEL"};
  // iec61162-450
  std::string udpbc_header = "required";
  // trdi-pd6
  std::string pd6_axes = "auto";
  // nortek-dvl, navquest
  std::string nortek_velocity = "vehicle", navquest_velocity = "bottom";
  // pni-tcm
  std::string pni_byte_order = "big";
  // valeport, paroscientific, mavlink
  std::string valeport_unit = "dbar", paroscientific_unit = "psi";
  std::vector<std::string> valeport_columns = {"pressure_dbar", "-", "sound_speed_mps"};
  double valeport_atmosphere_hpa = 0.0, paroscientific_atmosphere_hpa = 1013.25,
         mavlink_atmosphere_hpa = 1013.25;
  double latitude_deg = 45.0;
  std::optional<double> density_kgm3;
};

/// The keys this decoder reads; none for one that reads none or is not known.
[[nodiscard]] std::vector<Key<ProfileOptions>> profile_keys(std::string_view decoder);

}  // namespace leadline::decode
