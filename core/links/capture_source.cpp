#include "core/links/capture_source.h"

#include <pcap/pcap.h>

#include <algorithm>

namespace leadline::links {
namespace {

constexpr std::size_t kMostWaiting = 64, kMostStreams = 4096, kMostNames = 256;

}  // namespace

struct CaptureSource::File {
  explicit File(pcap_t* open) : pcap(open) {}
  ~File() { ::pcap_close(pcap); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  pcap_t* pcap;
  std::string path;
};

CaptureSource::CaptureSource(std::unique_ptr<File> file) : file_(std::move(file)) {}
CaptureSource::CaptureSource(CaptureSource&&) noexcept = default;
CaptureSource::~CaptureSource() = default;

Result<CaptureSource> CaptureSource::open(const std::string& path, std::vector<CapturedSource> sources) {
  std::array<char, PCAP_ERRBUF_SIZE> why{};
  pcap_t* const pcap =
      ::pcap_open_offline_with_tstamp_precision(path.c_str(), PCAP_TSTAMP_PRECISION_NANO, why.data());
  if (pcap == nullptr)
    return Error{std::string("is no capture that can be read (") + why.data() + ")", path, ""};
  auto file = std::make_unique<File>(pcap);
  file->path = path;
  CaptureSource source(std::move(file));
  source.sources_ = std::move(sources);
  return source;
}

bool CaptureSource::next(Chunk& chunk) {
  if (next_source_ == given_.sources.size()) {
    while (ready_.empty())
      if (!read_packet()) return false;
    given_ = std::move(ready_.front());
    ready_.pop_front();
    next_source_ = 0;
  }
  chunk = Chunk{};
  chunk.source = given_.sources[next_source_++];
  chunk.arrival = given_.arrival;
  chunk.bytes = given_.bytes;
  chunk.sender = given_.sender;
  return true;
}

bool CaptureSource::read_packet() {
  if (failure_) return false;
  pcap_pkthdr* header = nullptr;
  const std::uint8_t* data = nullptr;
  const int got = ::pcap_next_ex(file_->pcap, &header, &data);
  if (got != 1) {
    if (got == PCAP_ERROR)
      failure_ = Error{std::string("ends in the middle of a packet (") + ::pcap_geterr(file_->pcap) + ")",
                       file_->path, "what was before it is used"};
    return false;
  }
  const auto packet = captured_packet(::pcap_datalink(file_->pcap), {data, header->caplen});
  if (!packet) {
    ++not_understood_;
    return true;
  }
  // With nanosecond precision asked for, tv_usec holds nanoseconds.
  take(*packet, arrival_at({header->ts.tv_sec * std::int64_t{1'000'000'000} + header->ts.tv_usec}));
  return true;
}

std::vector<SourceId> CaptureSource::sources_of(const CapturedPacket& packet) const {
  std::vector<SourceId> found;
  const bool udp = packet.protocol == CapturedPacket::Protocol::udp;
  for (const auto& [id, link] : sources_) {
    const bool mine = udp ? link.kind == LinkKind::udp && link.port == packet.to_port
                          : (link.kind == LinkKind::tcp && link.port == packet.from_port) ||
                                (link.kind == LinkKind::tcp_listen && link.port == packet.to_port);
    if (mine) found.push_back(id);
  }
  return found;
}

void CaptureSource::count_for_nobody(const CapturedPacket& packet) {
  const std::string name =
      (packet.protocol == CapturedPacket::Protocol::udp ? "udp " : "tcp ") + std::to_string(packet.to_port);
  const bool full = for_nobody_.size() >= kMostNames - 1 && !for_nobody_.contains(name);
  ++for_nobody_[full ? "(others)" : name];
}

void CaptureSource::take(const CapturedPacket& packet, Arrival arrival) {
  auto sources = sources_of(packet);
  if (sources.empty()) {
    if (!packet.payload.empty()) count_for_nobody(packet);
    return;
  }
  if (packet.protocol == CapturedPacket::Protocol::tcp) return take_tcp(packet, sources, arrival);
  if (packet.payload.empty()) return;
  ready_.push_back(
      {std::move(sources), arrival, packet.sender(), {packet.payload.begin(), packet.payload.end()}});
}

void CaptureSource::take_tcp(const CapturedPacket& packet, const std::vector<SourceId>& sources,
                             Arrival arrival) {
  const Flow flow{packet.from, packet.from_port, packet.to, packet.to_port};
  if (streams_.size() >= kMostStreams && !streams_.contains(flow)) streams_.clear();
  Stream& stream = streams_[flow];
  if (packet.begins) stream = {packet.sequence + 1, {}};
  if (packet.payload.empty()) return;
  const std::uint32_t begins = packet.begins ? packet.sequence + 1 : packet.sequence;
  if (!stream.next) stream.next = begins;  // captured from its middle on
  const auto hand_on = [&](std::span<const std::uint8_t> bytes) {
    ready_.push_back({sources, arrival, packet.sender(), {bytes.begin(), bytes.end()}});
    *stream.next += static_cast<std::uint32_t>(bytes.size());
  };
  const auto ahead = static_cast<std::int32_t>(begins - *stream.next);
  if (ahead > 0) {
    stream.waiting.emplace(begins, std::vector<std::uint8_t>(packet.payload.begin(), packet.payload.end()));
  } else if (const auto again = static_cast<std::size_t>(-std::int64_t{ahead});
             again < packet.payload.size()) {
    hand_on(packet.payload.subspan(again));
  }
  const auto nearest = [&] {
    return std::min_element(stream.waiting.begin(), stream.waiting.end(), [&](const auto& a, const auto& b) {
      return a.first - *stream.next < b.first - *stream.next;
    });
  };
  while (!stream.waiting.empty()) {
    // Those behind us by number are what was sent again: their distance, as a signed number, is negative.
    auto first = std::find_if(stream.waiting.begin(), stream.waiting.end(), [&](const auto& w) {
      return static_cast<std::int32_t>(w.first - *stream.next) <= 0;
    });
    if (first == stream.waiting.end()) {
      if (stream.waiting.size() < kMostWaiting) break;
      first = nearest();
      missing_bytes_ += first->first - *stream.next;
      stream.next = first->first;
    }
    const auto behind = static_cast<std::size_t>(*stream.next - first->first);
    if (behind < first->second.size()) hand_on(std::span(first->second).subspan(behind));
    stream.waiting.erase(first);
  }
}

}  // namespace leadline::links
