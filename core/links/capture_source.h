#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "core/flow/source.h"
#include "core/links/capture_packet.h"
#include "core/links/link_address.h"
#include "core/types/result.h"

namespace leadline::links {

/// Which source is meant by what was sent to a port: that of its link.
struct CapturedSource {
  SourceId id = kNoSource;
  LinkAddress link;
};

/// A network capture (.pcap, .pcapng) as a Source: UDP datagrams to the port of a source's link, and TCP
/// streams to it (tcp-listen) or from it (tcp), put into order, as they were heard. Packets for nobody are
/// counted. TCP: what was sent again is left out; behind a gap that nothing fills within 64 segments the
/// stream goes on.
class CaptureSource final : public Source {
 public:
  using Counts = std::map<std::string, std::uint64_t>;  ///< packets by "udp 5000"

  [[nodiscard]] static Result<CaptureSource> open(const std::string& path,
                                                  std::vector<CapturedSource> sources);
  CaptureSource(CaptureSource&&) noexcept;
  ~CaptureSource() override;

  bool next(Chunk& chunk) override;
  /// Packets of no source's port, by port: at most 256 of them, the last for "(others)".
  [[nodiscard]] const Counts& for_nobody() const { return for_nobody_; }
  [[nodiscard]] std::uint64_t not_understood() const { return not_understood_; }  ///< packets
  [[nodiscard]] std::uint64_t missing_bytes() const {
    return missing_bytes_;
  }  ///< of TCP streams, never captured
  /// Why it ended before its end.
  [[nodiscard]] const std::optional<Error>& failure() const { return failure_; }

 private:
  using Flow =
      std::tuple<std::array<std::uint8_t, 16>, std::uint16_t, std::array<std::uint8_t, 16>, std::uint16_t>;
  struct Stream {
    std::optional<std::uint32_t> next;                           // sequence number
    std::map<std::uint32_t, std::vector<std::uint8_t>> waiting;  // by distance from `next`
  };
  struct Ready {
    std::vector<SourceId> sources;
    Arrival arrival;
    std::string sender;
    std::vector<std::uint8_t> bytes;
  };
  struct File;

  explicit CaptureSource(std::unique_ptr<File> file);
  [[nodiscard]] bool read_packet();
  void take(const CapturedPacket& packet, Arrival arrival);
  void take_tcp(const CapturedPacket& packet, const std::vector<SourceId>& sources, Arrival arrival);
  [[nodiscard]] std::vector<SourceId> sources_of(const CapturedPacket& packet) const;
  void count_for_nobody(const CapturedPacket& packet);

  std::unique_ptr<File> file_;
  std::vector<CapturedSource> sources_;
  std::map<Flow, Stream> streams_;
  std::deque<Ready> ready_;
  Ready given_;
  std::size_t next_source_ = 0;
  Counts for_nobody_;
  std::uint64_t not_understood_ = 0, missing_bytes_ = 0;
  std::optional<Error> failure_;
};

}  // namespace leadline::links
