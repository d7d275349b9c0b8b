#include "core/sim/telegrams/udpbc_writer.h"

#include <fmt/format.h>

namespace leadline::sim {

std::string sfi_of(const SensorSetup& sensor, std::size_t number) {
  const auto& o = sensor.options;
  const std::string_view usual = o.kind == "gnss"      ? "GP"
                                 : o.kind == "dvl"     ? "VD"
                                 : o.kind == "ahrs"    ? "HE"
                                 : o.kind == "usbl"    ? "SN"
                                 : o.kind == "compass" ? "HC"
                                                       : "SD";
  return fmt::format("{}{:04d}", o.talker.empty() ? usual : o.talker, number % 10'000);
}

void write_udpbc(const SensorSetup& sensor, std::span<const std::string> sentences, Time device,
                 const Measurement& measurement, encode::Udpbc& udpbc, Telegrams& out) {
  Telegrams lines;
  write_nmea(sensor, sentences, device, measurement, lines);
  udpbc.wrap(lines, out);
}

}  // namespace leadline::sim
