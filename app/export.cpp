#include "app/export.h"

#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/talk.h"
#include "sessions/export/session_csv.h"
#include "sessions/export/tlog.h"

namespace leadline::app {
namespace {

Exit failed(const Error& error) {
  failure(error.line());
  return Exit::failed;
}

Exit export_log(sessions::Session& session, const ExportOptions& options) {
  if (options.output.empty()) {
    const auto written = sessions::export_tlog(session, stdout);
    return written ? Exit::done : failed(written.error());
  }
  if (!options.force && std::filesystem::exists(options.output))
    return failed({"exists already", options.output, "give --force to replace it"});
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> out(std::fopen(options.output.c_str(), "wb"),
                                                            std::fclose);
  if (!out) return failed({"cannot be written", options.output, "choose another --output"});
  const auto written = sessions::export_tlog(session, out.get());
  if (!written) return failed(written.error());
  if (std::fflush(out.get()) != 0)
    return failed({"not all of it could be written", options.output, "is the disk full?"});
  return Exit::done;
}

Exit export_tables(sessions::Session& session, const ExportOptions& options) {
  const auto runs = session.runs();
  if (!runs) return failed(runs.error());
  for (auto run = runs.value().rbegin(); run != runs.value().rend(); ++run) {
    if (run->engines.empty()) continue;
    const std::string folder =
        options.output.empty()
            ? std::filesystem::path(options.session).replace_extension("").string() + "-csv"
            : options.output;
    const auto written = sessions::export_csv(session, run->id, folder);
    if (!written) return failed(written.error());
    note("run " + std::to_string(run->id) + " written to " + folder);
    return Exit::done;
  }
  return failed({"holds no run with an engine", options.session,
                 "replay it into itself first: leadline replay S --session S"});
}

}  // namespace

Exit export_session(const ExportOptions& options) {
  auto session = sessions::Session::open(options.session, sessions::Access::read);
  if (!session) return failed(session.error());
  return options.format == "tlog" ? export_log(session.value(), options)
                                  : export_tables(session.value(), options);
}

}  // namespace leadline::app
