#pragma once

#include <QImage>
#include <string>

namespace leadline::test {

/// How far two pictures of one size are apart.
struct PictureDifference {
  double different_share = 0.0;    ///< of all pixels, those that differ by more than 24 in a channel
  double worst_block_share = 0.0;  ///< the same within the worst block of 16 x 16 px
  QImage marked;                   ///< the expected one dimmed, differences in magenta
  [[nodiscard]] bool same() const { return different_share <= 0.002 && worst_block_share <= 0.30; }
};
[[nodiscard]] PictureDifference compare(const QImage& actual, const QImage& expected);

/// Fails the running test unless the picture is tests/ui/pictures/<name>.png; then writes <name>-actual,
/// -expected and -difference.png under build/<preset>/pictures. LEADLINE_RENEW_PICTURES=1 renews the golden
/// one instead.
void expect_picture(const QImage& actual, const std::string& name);

}  // namespace leadline::test
