#include "maps/charts/gdal_session.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal_priv.h>

#include <mutex>

namespace leadline::maps {
namespace {

constexpr std::size_t kMostFailures = 20;  // a warp can complain once a pixel

void CPL_STDCALL keep(CPLErr severity, CPLErrorNum number, const char* text) {
  if (severity != CE_Failure && severity != CE_Fatal) return;
  auto& failures = *static_cast<std::vector<GdalSession::Failure>*>(CPLGetErrorHandlerUserData());
  if (failures.size() < kMostFailures) failures.push_back({static_cast<int>(number), text});
}

void prepare() {
  static std::once_flag once;
  std::call_once(once, [] {
    CPLSetConfigOption("GDAL_PAM_ENABLED", "NO");  // never write .aux.xml beside the operator's files
    CPLSetConfigOption("GDAL_CACHEMAX", "64");     // MB
    GDALAllRegister();
  });
}

}  // namespace

GdalSession::GdalSession() {
  CPLPushErrorHandlerEx(keep, &failures_);
  prepare();
}

GdalSession::~GdalSession() {
  CPLPopErrorHandler();
  CPLErrorReset();
}

std::string GdalSession::first_failure(const std::string& otherwise) const {
  if (failures_.empty()) return otherwise;
  std::string line = failures_.front().text;
  if (const auto end = line.find('\n'); end != std::string::npos) line.resize(end);
  return line;
}

}  // namespace leadline::maps
