#include "ui/widgets/clock_text.h"

#include <array>

namespace leadline::ui {

QString clock_text(Time time, int decimals) {
  const Civil civil = to_civil(time);
  QString text = QString::asprintf("%02d:%02d:%02d", civil.hour, civil.minute, civil.second);
  if (decimals > 0) {
    constexpr std::array<int, 4> kUnit{1'000'000'000, 100'000'000, 10'000'000, 1'000'000};
    const int cut = civil.nanosecond / kUnit[static_cast<std::size_t>(decimals)];
    text += QStringLiteral(".%1").arg(cut, decimals, 10, QLatin1Char('0'));
  }
  return text + QStringLiteral(" Z");
}

QString hour_text(Time time) {
  const Civil civil = to_civil(time);
  return QString::asprintf("%02d:%02d Z", civil.hour, civil.minute);
}

QString duration_words(Duration length) {
  const auto total = std::chrono::duration_cast<std::chrono::seconds>(length).count();
  if (total >= 3600) return QStringLiteral("%1 h %2 min").arg(total / 3600).arg(total / 60 % 60);
  if (total >= 60) return QStringLiteral("%1 min %2 s").arg(total / 60).arg(total % 60);
  return QStringLiteral("%1 s").arg(total);
}

}  // namespace leadline::ui
