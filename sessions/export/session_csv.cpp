#include "sessions/export/session_csv.h"

#include "sessions/export/solution_csv.h"

namespace leadline::sessions {

Result<void> export_csv(Session& session, RunId run, const std::string& folder) {
  const auto runs = session.runs();
  if (!runs) return runs.error();
  const Run* found = nullptr;
  for (const Run& each : runs.value())
    if (each.id == run) found = &each;
  if (found == nullptr)
    return Error{"has no run " + std::to_string(run), session.path(), "see `leadline info`"};
  const auto recorded = session.sources(run);
  if (!recorded) return recorded.error();
  std::vector<SourceInfo> sources;
  for (const auto& source : recorded.value()) sources.push_back(source.info);

  auto csv = SolutionCsv::create(folder, found->engines, sources);
  if (!csv) return csv.error();
  const auto take = [&](const Envelope& envelope) {
    if (std::holds_alternative<FixVerdict>(envelope.message) && envelope.source >= sources.size())
      return true;  // a verdict on a source that is not there: no row can name it
    csv.value().take(envelope);
    return true;
  };
  if (auto done = session.read<Solution>(run, take); !done) return done;
  if (auto done = session.read<FixVerdict>(run, take); !done) return done;
  return csv.value().close();
}

}  // namespace leadline::sessions
