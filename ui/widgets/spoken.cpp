#include "ui/widgets/spoken.h"

#include <QStringList>

#include "ui/widgets/paint_text.h"

namespace leadline::ui {
namespace {

QString unit_word(const std::string& unit) {
  static const std::pair<const char*, const char*> kWords[]{
      {"m", "metres"},         {"m/s", "metres per second"}, {"kn", "knots"}, {"°", "degrees"},
      {"° T", "degrees true"}, {"° M", "degrees magnetic"},  {"s", "seconds"}};
  for (const auto& [sign, word] : kWords)
    if (unit == sign) return QString::fromUtf8(word);
  return q(unit);
}

QStringList origin(const TileText& text) {
  QStringList words;
  if (text.simulated) words << QStringLiteral("simulated");
  if (text.replay) words << QStringLiteral("recorded");
  if (text.manual) words << QStringLiteral("typed by the operator");
  return words;
}

}  // namespace

QString state_word(ValueState state) {
  switch (state) {
    case ValueState::live:
      return QStringLiteral("live");
    case ValueState::ageing:
      return QStringLiteral("ageing");
    case ValueState::pending:
      return QStringLiteral("waiting for the vehicle");
    case ValueState::disagree:
      return QStringLiteral("command and report disagree");
    case ValueState::alert:
      return QStringLiteral("beyond its limit");
    case ValueState::stale:
      return QStringLiteral("stale");
    case ValueState::lost:
      return QStringLiteral("lost");
  }
  return {};
}

QString spoken(const TileText& text) {
  QString value = q(text.label) + QLatin1Char(' ');
  if (text.value.empty() || text.state == ValueState::lost)
    value += QStringLiteral("unknown");
  else
    value += q(text.value).replace(QChar(0x2212), QStringLiteral("minus "));
  if (!text.value_2.empty() && text.state != ValueState::lost) value += QLatin1Char(' ') + q(text.value_2);
  if (!text.unit.empty() && text.state != ValueState::lost) value += QLatin1Char(' ') + unit_word(text.unit);
  QStringList facts{value};
  if (!text.sigma.empty() && text.state != ValueState::lost)
    facts << QStringLiteral("sigma ") + q(text.sigma);
  if (!text.age.empty()) facts << QStringLiteral("age ") + q(text.age);
  facts << (text.state == ValueState::live && text.replay ? QString() : state_word(text.state));
  if (text.state == ValueState::alert && !text.limit.empty()) facts << q(text.limit);
  facts << origin(text);
  if (!text.note.empty()) facts << q(text.note);
  facts.removeAll(QString());
  return facts.join(QStringLiteral(", "));
}

QString explained(const TileText& text) {
  if (!text.tool_tip.empty()) return q(text.tool_tip);
  QStringList lines;
  lines << QStringLiteral("%1 %2 %3 %4")
               .arg(q(text.label), q(text.value), q(text.value_2), q(text.unit))
               .simplified();
  if (!text.sigma.empty()) lines << QStringLiteral("σ ") + q(text.sigma);
  if (!text.source.empty())
    lines << QStringLiteral("from ") + q(text.source) +
                 (text.was_source.empty() ? QString() : QStringLiteral(", was ") + q(text.was_source));
  const QStringList how = QStringList{state_word(text.state)} + origin(text);
  lines << (text.age.empty() ? QString() : QStringLiteral("age ") + q(text.age) + QStringLiteral(", ")) +
               how.join(QStringLiteral(", "));
  if (!text.limit.empty() && text.state == ValueState::alert) lines << q(text.limit);
  if (!text.note.empty()) lines << q(text.note);
  return lines.join(QLatin1Char('\n'));
}

}  // namespace leadline::ui
