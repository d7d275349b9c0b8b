#include "app/info.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/file_account.h"
#include "app/talk.h"

namespace leadline::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kClassNames[kByteClasses] = {"decoded", "unused",  "unknown", "refused",
                                                   "stamp",   "comment", "skipped"};

Json utc(std::optional<Time> t) { return t ? Json(iso8601(*t, 3)) : Json(nullptr); }

Json json_of(const FileAccount& a) {
  Json j;
  j["path"] = a.path;
  j["kind"] = a.kind;
  j["bytes"] = a.bytes;
  for (std::size_t c = 0; c < kByteClasses; ++c) j["byte_classes"][kClassNames[c]] = a.byte_classes[c];
  j["lines"] = a.lines;
  j["frames"] = a.frames;
  j["checksum_ok"] = a.checksum_ok;
  j["checksum_bad"] = a.checksum_bad;
  j["checksum_absent"] = a.checksum_absent;
  j["unknown"] = a.unknown;
  j["unused"] = a.unused;
  j["refused"] = Json::object();
  for (const auto& [reason, count] : a.refused) j["refused"][reason] = count;
  j["sources"] = Json::array();
  for (const auto& s : a.sources)
    j["sources"].push_back({{"name", s.name},
                            {"decoder", s.decoder},
                            {"kind", s.kind},
                            {"count", s.count},
                            {"rate_hz", s.rate_hz ? Json(*s.rate_hz) : Json(nullptr)},
                            {"first_utc", utc(s.first)},
                            {"last_utc", utc(s.last)}});
  j["gaps"] = a.gaps;
  j["bbox"] = a.box ? Json({a.box->west.deg(), a.box->south.deg(), a.box->east.deg(), a.box->north.deg()})
                    : Json(nullptr);
  return j;
}

void print_text(const FileAccount& a) {
  fmt::print("{}: {}, {} bytes", a.path, a.kind, a.bytes);
  if (a.lines > 0) fmt::print(", {} lines", a.lines);
  fmt::print("\n  bytes:");
  for (std::size_t c = 0; c < kByteClasses; ++c)
    if (a.byte_classes[c] > 0) fmt::print(" {} {}", kClassNames[c], a.byte_classes[c]);
  fmt::print("\n  frames: {}, checksum ok {}, bad {}, absent {}, unused {}, unknown {}\n", a.frames,
             a.checksum_ok, a.checksum_bad, a.checksum_absent, a.unused, a.unknown);
  for (const auto& [reason, count] : a.refused) fmt::print("  refused: {} {}\n", count, reason);
  for (const auto& s : a.sources) {
    fmt::print("  {:<14} {:>8}", s.kind, s.count);
    if (s.rate_hz) fmt::print("  {:7.3f} Hz", *s.rate_hz);
    if (s.first) fmt::print("  {} to {}", iso8601(*s.first), iso8601(*s.last));
    fmt::print("\n");
  }
  if (a.gaps > 0) fmt::print("  gaps: {}\n", a.gaps);
  if (a.box)
    fmt::print("  positions: {:.5f} to {:.5f} north, {:.5f} to {:.5f} east\n", a.box->south.deg(),
               a.box->north.deg(), a.box->west.deg(), a.box->east.deg());
}

}  // namespace

Exit info(const std::vector<std::string>& files, bool json) {
  Exit exit = Exit::done;
  Json all;
  all["files"] = Json::array();
  for (const auto& path : files) {
    const auto account = account_of(path);
    if (!account) {
      failure(account.error().line());
      exit = Exit::failed;
      continue;
    }
    if (json)
      all["files"].push_back(json_of(account.value()));
    else
      print_text(account.value());
    if (account.value().bytes == 0) warning(path + ": is empty");
    if (account.value().damaged && exit == Exit::done) exit = Exit::damaged;
  }
  if (json) fmt::print("{}\n", all.dump(2, ' ', false, Json::error_handler_t::replace));
  return exit;
}

}  // namespace leadline::app
