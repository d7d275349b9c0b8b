#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace leadline::links {

/// What a file is, told by its content and never by its name.
enum class FileKind : std::uint8_t {
  empty,
  tlog,          ///< "(unix seconds) source payload" lines
  stamped_text,  ///< ISO 8601 arrival time before each line
  nmea,          ///< plain NMEA 0183 stream
  iec61162_450,  ///< datagrams of sentences, one behind the other
  trdi_pd0,
  waterlinked_serial,
  waterlinked_json,
  navquest,
  paroscientific,
  session,  ///< a Leadline session
  sqlite,   ///< another SQLite file, see sqlite_application_id
  xtf,
  jsf,
  pcap,
  pcapng,
  mavlink,  ///< telemetry log: time stamp and MAVLink frame in turn
  nortek_dvl,
  evologics_usbl,
  xsens_mtdata2,
  pni_tcm,
  table,  ///< rows of mostly numbers in equal columns
  text,
  unknown,
};
[[nodiscard]] const char* name_of(FileKind kind);

inline constexpr std::size_t kSniffBytes = std::size_t{64} << 10;
inline constexpr std::uint32_t kSessionApplicationId = 0x4C444C4E;

/// `head`: the first kSniffBytes of the file, all of it when it is shorter; `size`: the whole file's. PD0 and
/// NMEA are also found behind garbage: by an ensemble whose checksum holds, by sentences whose checksums
/// hold.
[[nodiscard]] FileKind sniff(std::span<const std::uint8_t> head, std::uint64_t size);

/// Whose file a SQLite file says it is; empty when it is none.
[[nodiscard]] std::optional<std::uint32_t> sqlite_application_id(std::span<const std::uint8_t> head);

}  // namespace leadline::links
