#include "ui/look/style_sheet.h"

#include <QFile>
#include <QRegularExpression>

#include "core/types/expect.h"

namespace leadline::ui {
namespace {

QString value_of(const QString& token, const Colours& colours) {
  if (token == QLatin1String("sp1")) return QStringLiteral("4px");
  if (token == QLatin1String("sp2")) return QStringLiteral("8px");
  for (std::size_t i = 0; i < kRoles.size(); ++i)
    if (token == QLatin1String(kRoles[i].name)) return colours.of(static_cast<Role>(i)).name();
  return {};
}

}  // namespace

QString style_sheet(const Colours& colours) {
  QFile file(QStringLiteral(":/console.qss"));
  LL_EXPECT(file.open(QIODevice::ReadOnly));
  const QString sheet = QString::fromUtf8(file.readAll());
  static const QRegularExpression kToken(QStringLiteral("@([a-z0-9]+(?:\\.[a-z0-9]+)?)"));
  QString filled;
  int done = 0;
  for (auto match = kToken.globalMatch(sheet); match.hasNext();) {
    const auto token = match.next();
    const QString value = value_of(token.captured(1), colours);
    LL_EXPECT(!value.isEmpty());
    filled += sheet.midRef(done, token.capturedStart() - done);
    filled += value;
    done = token.capturedEnd();
  }
  return filled + sheet.midRef(done);
}

}  // namespace leadline::ui
