#include "tests/support/picture.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QtGlobal>
#include <algorithm>
#include <cstdlib>
#include <vector>

namespace leadline::test {
namespace {

constexpr int kChannelStep = 24;
constexpr int kBlock = 16;

bool apart(QRgb a, QRgb b) {
  return std::abs(qRed(a) - qRed(b)) > kChannelStep || std::abs(qGreen(a) - qGreen(b)) > kChannelStep ||
         std::abs(qBlue(a) - qBlue(b)) > kChannelStep;
}

}  // namespace

PictureDifference compare(const QImage& actual, const QImage& expected) {
  const QImage a = actual.convertToFormat(QImage::Format_RGB32);
  const QImage b = expected.convertToFormat(QImage::Format_RGB32);
  PictureDifference found;
  if (a.size() != b.size() || a.isNull()) return {1.0, 1.0, a};
  found.marked = QImage(a.size(), QImage::Format_RGB32);
  const int columns = (a.width() + kBlock - 1) / kBlock;
  std::vector<int> blocks(static_cast<std::size_t>(columns * ((a.height() + kBlock - 1) / kBlock)), 0);
  long long different = 0;
  for (int y = 0; y < a.height(); ++y) {
    const auto* row_a = reinterpret_cast<const QRgb*>(a.constScanLine(y));
    const auto* row_b = reinterpret_cast<const QRgb*>(b.constScanLine(y));
    auto* row_m = reinterpret_cast<QRgb*>(found.marked.scanLine(y));
    for (int x = 0; x < a.width(); ++x) {
      const bool differs = apart(row_a[x], row_b[x]);
      row_m[x] =
          differs ? qRgb(255, 0, 255) : qRgb(qRed(row_b[x]) / 3, qGreen(row_b[x]) / 3, qBlue(row_b[x]) / 3);
      if (!differs) continue;
      ++different;
      ++blocks[static_cast<std::size_t>(y / kBlock * columns + x / kBlock)];
    }
  }
  found.different_share = static_cast<double>(different) / (static_cast<double>(a.width()) * a.height());
  found.worst_block_share = *std::max_element(blocks.begin(), blocks.end()) / double{kBlock * kBlock};
  return found;
}

void expect_picture(const QImage& actual, const std::string& name) {
  const QString golden = QStringLiteral(LEADLINE_SOURCE_DIR "/tests/ui/pictures/%1.png").arg(name.c_str());
  if (qEnvironmentVariableIsSet("LEADLINE_RENEW_PICTURES")) {
    QDir().mkpath(QStringLiteral(LEADLINE_SOURCE_DIR "/tests/ui/pictures"));
    ASSERT_TRUE(actual.convertToFormat(QImage::Format_RGB32).save(golden, "PNG", 0)) << golden.toStdString();
    return;
  }
  const QImage expected(golden);
  ASSERT_FALSE(expected.isNull()) << golden.toStdString()
                                  << " is not there; look at the picture, then ./dev screenshots";
  ASSERT_EQ(actual.size(), expected.size()) << name;
  const PictureDifference found = compare(actual, expected);
  if (found.same()) return;
  const QString folder = QStringLiteral(LEADLINE_BINARY_DIR "/pictures");
  QDir().mkpath(folder);
  const QString stem = folder + "/" + QString::fromStdString(name);
  actual.save(stem + "-actual.png");
  expected.save(stem + "-expected.png");
  found.marked.save(stem + "-difference.png");
  ADD_FAILURE() << name << ": " << found.different_share * 100 << " % of the pixels differ, "
                << found.worst_block_share * 100 << " % of the worst block; see " << stem.toStdString()
                << "-*.png";
}

}  // namespace leadline::test
