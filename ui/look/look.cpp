#include "ui/look/look.h"

#include <QApplication>
#include <QFile>
#include <QFontDatabase>
#include <QPalette>
#include <QPointer>
#include <QToolTip>
#include <algorithm>
#include <array>

#include "core/types/expect.h"
#include "ui/look/console_style.h"
#include "ui/look/focus_ring.h"
#include "ui/look/font_file.h"
#include "ui/look/style_sheet.h"

// Outside the namespace, as the macro declares a function of the global one.
static void init_resources() { Q_INIT_RESOURCE(console); }

namespace leadline::ui {
namespace {

constexpr std::array<double, 5> kDimmer{1.0, 0.7, 0.5, 0.35, 0.25};

QPalette palette_of(const Colours& colours) {
  QPalette palette;
  const auto set = [&](std::initializer_list<QPalette::ColorRole> roles, Role role) {
    for (const auto r : roles) palette.setColor(QPalette::All, r, colours.of(role));
  };
  set({QPalette::Window, QPalette::AlternateBase}, Role::bg_panel);
  set({QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::HighlightedText,
       QPalette::ToolTipText},
      Role::text);
  set({QPalette::Base}, Role::bg_tile);
  set({QPalette::Button, QPalette::Light, QPalette::ToolTipBase}, Role::bg_raised);
  set({QPalette::BrightText}, Role::alarm_mark);
  set({QPalette::Highlight}, Role::select);
  set({QPalette::Link}, Role::focus);
  set({QPalette::LinkVisited, QPalette::PlaceholderText}, Role::text_2);
  set({QPalette::Midlight, QPalette::Mid}, Role::line);
  set({QPalette::Dark}, Role::line_strong);
  set({QPalette::Shadow}, Role::bg_window);
  for (const auto r : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, r, colours.of(Role::text_off));
  palette.setColor(QPalette::Disabled, QPalette::Highlight, colours.of(Role::line));
  return palette;
}

void apply(const Colours& colours) {
  const QPalette palette = palette_of(colours);
  QApplication::setPalette(palette);
  QToolTip::setPalette(palette);
  qApp->setStyleSheet(style_sheet(colours));
}

// B612 Mono names "B612" as its second family, so whoever asks for B612 by name may get the fixed pitch. Ours
// is registered under a name that nothing else on the machine has.
constexpr char kFamily[] = "B6LL", kMonoFamily[] = "B6LM";

void register_fonts() {
  const std::pair<const char*, const char*> files[]{{"B612-Regular", kFamily},
                                                    {"B612-Bold", kFamily},
                                                    {"B612Mono-Regular", kMonoFamily},
                                                    {"B612Mono-Bold", kMonoFamily}};
  for (const auto& [name, family_name] : files) {
    QFile file(QStringLiteral(":/fonts/%1.otf").arg(QLatin1String(name)));
    LL_EXPECT(file.open(QIODevice::ReadOnly));
    QFontDatabase::addApplicationFontFromData(renamed_font(file.readAll(), family_name));
  }
  for (const char* name : {kFamily, kMonoFamily})
    QFont::insertSubstitution(QString::fromLatin1(name), QStringLiteral("DejaVu Sans"));
}

QFont family(const char* name, int px, bool bold) {
  QFont made(QString::fromLatin1(name));
  made.setPixelSize(px);
  made.setBold(bold);
  made.setHintingPreference(QFont::PreferNoHinting);
  made.setStyleStrategy(QFont::PreferAntialias);
  return made;
}

}  // namespace

Look& Look::current() {
  static QPointer<Look> look;  // goes with its QApplication
  if (!look) look = new Look;
  return *look;
}

Look::Look() : QObject(QCoreApplication::instance()) {
  init_resources();
  register_fonts();
  QApplication::setFont(font(13));
  QToolTip::setFont(font(13));
  QApplication::setStyle(new ConsoleStyle);
  QApplication::setEffectEnabled(Qt::UI_AnimateMenu, false);
  QApplication::setEffectEnabled(Qt::UI_AnimateCombo, false);
  QApplication::setEffectEnabled(Qt::UI_AnimateTooltip, false);
  QApplication::setEffectEnabled(Qt::UI_FadeTooltip, false);
  apply(colours_);
  new FocusRing(this);
}

void Look::set(Palette palette, int dimmer_step) {
  dimmer_step = std::clamp(dimmer_step, 0, static_cast<int>(kDimmer.size()) - 1);
  const Colours colours(palette, kDimmer[static_cast<std::size_t>(dimmer_step)]);
  dimmer_step_ = dimmer_step;
  if (colours == colours_) return;
  colours_ = colours;
  apply(colours_);
  emit lookChanged();
}

QFont font(int px, bool bold) { return family(kFamily, px, bold); }
QFont mono_font(int px) { return family(kMonoFamily, px, false); }

}  // namespace leadline::ui
