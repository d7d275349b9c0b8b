#include <cstdint>
#include <cstdlib>

#include "core/config/document.h"
#include "core/decode/profile.h"
#include "core/decode/table.h"
#include "core/flow/navigation_options.h"
#include "core/flow/source_options.h"

/// Any text is read or refused with its reasons, each in one line that begins with the file.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace leadline;
  auto document = config::Document::parse({reinterpret_cast<const char*>(data), size}, "f.toml");
  if (document.ok()) {
    auto root = document.root();
    NavigationSettings navigation;
    auto table = root.table("navigation");
    table.read(bind(navigation_keys(), navigation.navigation));
    table.table("aiding").read(bind(aiding_keys(), navigation.aiding));
    table.table("initial").read(bind(initial_keys(), navigation.initial));
    for (auto& given : root.tables("source")) {
      SourceOptions source;
      MountOptions mount;
      decode::TableOptions columns;
      decode::ProfileOptions profile;
      given.read(bind(source_keys(), source));
      given.table("mount").read(bind(mount_keys(), mount));
      given.read(bind(decode::table_keys(), columns));
      given.read(
          bind(std::span<const Key<decode::ProfileOptions>>(decode::profile_keys(source.decoder)), profile));
    }
    for (auto& given : root.tables("calibration")) {
      CalibrationOptions calibration;
      given.read(bind(calibration_keys(), calibration));
    }
    for (auto& given : root.tables("output")) {
      OutputOptions output;
      given.read(bind(output_keys(), output));
    }
    document.finish();
  }
  for (const auto& problem : document.problems())
    if (problem.line_text().rfind("f.toml:", 0) != 0 || problem.text.empty()) std::abort();
  return 0;
}
