#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/flow/engine.h"
#include "core/flow/source_info.h"
#include "sessions/export/csv_file.h"

namespace leadline::sessions {

/// What a replay writes into its --csv folder (product page): `<engine>.csv`, `fixes.csv` of the first engine
/// and
/// `<engine>_fixes.csv` of the others, `ship.csv` where there are ship positions.
class SolutionCsv final : public Sink {
 public:
  /// Makes the folder, takes away what an earlier replay left in it. Error: it cannot be written.
  [[nodiscard]] static Result<SolutionCsv> create(const std::string& folder,
                                                  const std::vector<std::string>& engines,
                                                  const std::vector<SourceInfo>& sources);
  void take(const Envelope& envelope) override;
  [[nodiscard]] Result<void> close();

 private:
  void row(CsvFile& csv, Time t, const Solution& solution);

  std::string folder_;
  std::vector<std::string> source_names_;
  std::vector<const char*> source_bodies_;
  std::vector<CsvFile> solutions_, fixes_;
  std::optional<CsvFile> ship_;
  std::optional<Error> failure_;
};

}  // namespace leadline::sessions
