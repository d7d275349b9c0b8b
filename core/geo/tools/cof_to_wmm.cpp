#include <cstdio>

#include "core/geo/tools/cof_file.h"

/// cof_to_wmm WMM_2025.COF folder wmm2025: NOAA's coefficients as folder/wmm2025.wmm and .wmm.cof.
int main(int argc, char** argv) {
  using namespace leadline;
  if (argc != 4) {
    std::fprintf(stderr, "usage: cof_to_wmm FILE.COF FOLDER NAME\n");
    return 2;
  }
  const Result<geo::CofFile> cof = geo::read_cof(argv[1]);
  if (!cof) {
    std::fprintf(stderr, "%s\n", cof.error().line().c_str());
    return 1;
  }
  const Result<void> written = geo::write_wmm(cof.value(), argv[2], argv[3]);
  if (!written) {
    std::fprintf(stderr, "%s\n", written.error().line().c_str());
    return 1;
  }
  return 0;
}
