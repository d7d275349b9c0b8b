#include "app/file_account.h"

#include <algorithm>

#include "core/decode/registry.h"
#include "core/flow/bus.h"
#include "core/links/file_reader.h"
#include "core/links/sniff.h"
#include "core/links/stamped_text_source.h"
#include "core/links/stream_source.h"
#include "core/links/stream_times.h"
#include "core/links/tlog_source.h"
#include "sessions/replay/session_source.h"

namespace leadline::app {
namespace {

using links::FileKind;
using links::FileReader;

constexpr double kLeastGapS = 5.0;
constexpr std::size_t kMostSources = 64;

/// Where the positions lie and when the frames came.
class Extent final : public Sink {
 public:
  void take(const Envelope& envelope) override {
    if (std::holds_alternative<RawFrame>(envelope.message)) {
      if (arrivals_.empty() || envelope.arrival > arrivals_.back()) arrivals_.push_back(envelope.arrival);
    } else if (const auto* gnss = std::get_if<GnssFix>(&envelope.message)) {
      add(gnss->position);
    } else if (const auto* usbl = std::get_if<UsblGeographic>(&envelope.message)) {
      add(usbl->position);
    }
  }
  [[nodiscard]] const std::optional<FileAccount::Box>& box() const { return box_; }
  /// Silences of more than 5 s and of three median intervals.
  [[nodiscard]] std::uint64_t gaps() const {
    std::vector<double> intervals_s;
    for (std::size_t i = 1; i < arrivals_.size(); ++i)
      intervals_s.push_back(seconds(arrivals_[i] - arrivals_[i - 1]));
    if (intervals_s.empty()) return 0;
    auto sorted = intervals_s;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    const double longest_s = std::max(kLeastGapS, 3.0 * *middle);
    return static_cast<std::uint64_t>(
        std::count_if(intervals_s.begin(), intervals_s.end(), [&](double s) { return s > longest_s; }));
  }

 private:
  void add(const Geodetic& p) {
    if (!box_) box_ = FileAccount::Box{p.lon, p.lat, p.lon, p.lat};
    box_->west = std::min(box_->west, p.lon);
    box_->east = std::max(box_->east, p.lon);
    box_->south = std::min(box_->south, p.lat);
    box_->north = std::max(box_->north, p.lat);
  }
  std::vector<Arrival> arrivals_;
  std::optional<FileAccount::Box> box_;
};

std::string stem(const std::string& path) {
  const auto slash = path.find_last_of('/');
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

std::unique_ptr<Decoder> lenient_decoder(const std::string& name, std::optional<Time> date = {}) {
  DecoderSettings settings;
  settings.checksum_required = false;
  settings.date = date;
  return decode::make_decoder(name, settings).value();
}

struct Named {
  std::string name, decoder;
};

/// The decoder that a payload of a tlog wants, by its first bytes.
std::string decoder_of_payload(std::string_view payload) {
  constexpr std::string_view kUdpbc = "#556450624300";
  if (payload.substr(0, 3) == "#7f" || payload.substr(0, 3) == "#7F") return "trdi-pd0";
  const auto begins = [&](std::string_view with) { return payload.substr(0, with.size()) == with; };
  if (begins("#a50a")) return "nortek-dvl";
  if (begins("#faff")) return "xsens-mtdata2";
  if (begins("#00") && payload.substr(5, 2) == "05") return "pni-tcm";
  const FileKind kind =
      links::sniff({reinterpret_cast<const std::uint8_t*>(payload.data()), payload.size()}, payload.size());
  if (kind == FileKind::waterlinked_serial || kind == FileKind::waterlinked_json ||
      kind == FileKind::evologics_usbl || kind == FileKind::nortek_dvl || kind == FileKind::navquest ||
      kind == FileKind::paroscientific)
    return links::name_of(kind);
  return payload.substr(0, kUdpbc.size()) == kUdpbc ? "iec61162-450" : "nmea0183";
}

/// The sources of a tlog with the decoder their first payloads want.
std::vector<Named> tlog_sources(FileReader& file) {
  std::vector<Named> found;
  std::string_view line;
  while (found.size() < kMostSources && file.line(line)) {
    const auto stamp = links::unix_stamp(line);
    if (!stamp) continue;
    const auto rest = line.substr(stamp->length);
    const auto blank = rest.find(' ');
    if (blank == 0 || blank == std::string_view::npos) continue;
    const std::string name(rest.substr(0, blank));
    if (std::any_of(found.begin(), found.end(), [&](const Named& n) { return n.name == name; })) continue;
    found.push_back({name, decoder_of_payload(rest.substr(blank + 1))});
  }
  file.rewind();
  return found;
}

void add_ledger(const Ledger& ledger, const Named& named, bool timed, FileAccount& account) {
  for (int c = 0; c < kByteClasses; ++c)
    account.byte_classes[static_cast<std::size_t>(c)] += ledger.bytes(static_cast<ByteClass>(c));
  account.frames += ledger.frames();
  account.unknown += ledger.frames(ByteClass::unknown);
  account.unused += ledger.frames(ByteClass::unused);
  account.checksum_ok += ledger.checksums(ChecksumState::ok);
  account.checksum_bad += ledger.checksums(ChecksumState::bad);
  account.checksum_absent += ledger.checksums(ChecksumState::absent);
  account.damaged = account.damaged || ledger.damaged();
  for (const auto& reason : ledger.refusals()) account.refused[std::string(reason.name)] += reason.count;
  for (const auto& kind : ledger.kinds()) {
    FileAccount::Kind row{named.name, named.decoder, std::string(kind.name), kind.count, {}, {}, {}};
    if (timed) {
      row.first = kind.first.host();
      row.last = kind.last.host();
      const double span_s = seconds(kind.last - kind.first);
      if (kind.count > 1 && span_s > 0.0) row.rate_hz = static_cast<double>(kind.count - 1) / span_s;
    }
    account.sources.push_back(std::move(row));
  }
}

void run(Source& source, const std::vector<Named>& named, bool timed, FileAccount& account) {
  std::vector<SourceInfo> infos;
  for (const auto& n : named) {
    SourceInfo info;
    info.id = static_cast<SourceId>(infos.size());
    info.name = n.name;
    infos.push_back(std::move(info));
  }
  Bus bus(std::move(infos));
  for (std::size_t i = 0; i < named.size(); ++i)
    if (!named[i].decoder.empty()) bus.attach(static_cast<SourceId>(i), lenient_decoder(named[i].decoder));
  Extent extent;
  bus.attach(extent);
  for (Chunk chunk; source.next(chunk);) bus.take(chunk);
  bus.finish();
  for (std::size_t i = 0; i < named.size(); ++i)
    add_ledger(bus.ledger(static_cast<SourceId>(i)), named[i], timed, account);
  add_ledger(bus.stray(), {}, timed, account);
  account.box = extent.box();
  if (timed) account.gaps = extent.gaps();
}

std::optional<Error> read_stream(FileReader file, const Named& named, FileAccount& account) {
  links::StreamTimeOptions options;
  options.source = named.name;
  options.file = account.path;
  const auto maker = [&](std::optional<Time> date) { return lenient_decoder(named.decoder, date); };
  auto stamps = links::stream_times(file, maker, options);
  const bool timed = stamps.ok();  // a stream without dates is accounted for all the same
  if (file.failure()) return file.failure();
  file.rewind();
  links::StreamSource source(std::move(file), 0,
                             timed ? std::move(stamps).value() : std::vector<links::Stamp>());
  run(source, {named}, timed, account);
  return source.failure();
}

/// A session: the frames of its recording through the decoders it was recorded with, as far as this build has
/// them; everything else in the file is what keeps them.
std::optional<Error> read_session(const std::string& path, FileAccount& account) {
  auto session = sessions::Session::open(path, sessions::Access::read);
  if (!session) return session.error();
  const auto runs = session.value().runs();
  if (!runs) return runs.error();
  std::vector<Named> named;
  std::vector<sessions::NamedSource> names;
  for (const auto& run : runs.value()) {
    const auto sources = session.value().sources(run.id);
    if (!sources) return sources.error();
    for (const auto& source : sources.value()) {
      const auto same = [&](const Named& n) { return n.name == source.info.name; };
      if (std::any_of(named.begin(), named.end(), same)) continue;
      const bool known =
          source.decoder == "nmea0183" || source.decoder == "iec61162-450" || source.decoder == "trdi-pd0";
      names.push_back({source.info.name, static_cast<SourceId>(named.size())});
      named.push_back({source.info.name, known ? source.decoder : ""});
    }
  }
  auto frames = sessions::SessionSource::open(std::move(session).value(), std::move(names));
  if (!frames) return frames.error();
  run(frames.value(), named, true, account);
  std::uint64_t counted = 0;
  for (const auto bytes : account.byte_classes) counted += bytes;
  account.byte_classes[static_cast<std::size_t>(ByteClass::stamp)] +=
      account.bytes > counted ? account.bytes - counted : 0;
  return frames.value().failure();
}

void count_lines(FileReader& file, FileAccount& account) {
  for (std::string_view line; file.line(line);) account.lines += file.line_goes_on() ? 0 : 1;
  file.rewind();
}

}  // namespace

Result<FileAccount> account_of(const std::string& path) {
  auto opened = FileReader::open(path);
  if (!opened) return opened.error();
  FileReader file = std::move(opened).value();
  FileAccount account;
  account.path = path;
  account.bytes = file.size();
  const FileKind kind = links::sniff(file.peek(links::kSniffBytes), file.size());
  account.kind = links::name_of(kind);

  std::optional<Error> failure;
  switch (kind) {
    case FileKind::empty:
      account.damaged = true;
      break;
    case FileKind::tlog: {
      count_lines(file, account);
      const auto named = tlog_sources(file);
      std::vector<links::SourceName> names;
      for (std::size_t i = 0; i < named.size(); ++i)
        names.push_back({named[i].name, static_cast<SourceId>(i)});
      links::TlogSource source(std::move(file), std::move(names));
      run(source, named, true, account);
      failure = source.failure();
      break;
    }
    case FileKind::stamped_text: {
      count_lines(file, account);
      links::StampedTextSource source(std::move(file), 0);
      run(source, {{stem(path), "nmea0183"}}, true, account);
      failure = source.failure();
      break;
    }
    case FileKind::nmea:
      count_lines(file, account);
      failure = read_stream(std::move(file), {stem(path), "nmea0183"}, account);
      break;
    case FileKind::iec61162_450:
      failure = read_stream(std::move(file), {stem(path), "iec61162-450"}, account);
      break;
    case FileKind::waterlinked_serial:
    case FileKind::waterlinked_json:
    case FileKind::navquest:
    case FileKind::paroscientific:
      count_lines(file, account);
      failure = read_stream(std::move(file), {stem(path), links::name_of(kind)}, account);
      break;
    case FileKind::session:
      failure = read_session(path, account);
      break;
    case FileKind::mavlink:
    case FileKind::nortek_dvl:
    case FileKind::evologics_usbl:
    case FileKind::xsens_mtdata2:
    case FileKind::pni_tcm:
      failure = read_stream(std::move(file), {stem(path), account.kind}, account);
      break;
    case FileKind::trdi_pd0:
      failure = read_stream(std::move(file), {stem(path), "trdi-pd0"}, account);
      break;
    case FileKind::table:
    case FileKind::text:
      count_lines(file, account);
      account.byte_classes[static_cast<std::size_t>(ByteClass::unknown)] = account.bytes;
      break;
    default:
      account.byte_classes[static_cast<std::size_t>(ByteClass::unknown)] = account.bytes;
  }
  if (failure) return *failure;
  return account;
}

}  // namespace leadline::app
