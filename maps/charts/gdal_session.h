#pragma once

#include <string>
#include <vector>

namespace leadline::maps {

/// While one lives, GDAL is ready and what it complains of on this thread is kept here instead of being
/// printed.
class GdalSession {
 public:
  GdalSession();
  ~GdalSession();
  GdalSession(const GdalSession&) = delete;
  GdalSession& operator=(const GdalSession&) = delete;

  struct Failure {
    int number;  ///< CPLE_*
    std::string text;
  };
  [[nodiscard]] const std::vector<Failure>& failures() const { return failures_; }
  /// One line, without the text of a file; `otherwise` when GDAL said nothing.
  [[nodiscard]] std::string first_failure(const std::string& otherwise) const;
  void clear() { failures_.clear(); }

 private:
  std::vector<Failure> failures_;
};

}  // namespace leadline::maps
