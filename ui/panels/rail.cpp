#include "ui/panels/rail.h"

#include <QPainter>
#include <algorithm>

#include "ui/look/look.h"
#include "ui/widgets/paint_text.h"
#include "ui/widgets/tool_button.h"

namespace leadline::ui {
namespace {

constexpr int kButton = 40, kStep = 44, kLeast = 28;
constexpr int kApart = 16, kClose = 7;  ///< groups, where there is room and where there is not

ToolButton* button(const char* name, const char* icon, const char* words, const char* key, QWidget* parent) {
  return new ToolButton(name, QString::fromLatin1(icon), QString::fromLatin1(words), QString::fromLatin1(key),
                        parent);
}

}  // namespace

Rail::Rail(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("rail"));
  setAccessibleName(QStringLiteral("Tools"));
  tools_ = {button("toolSelect", "select", "Select", "S", this), button("toolPan", "pan", "Pan", "P", this),
            button("toolMeasure", "measure", "Measure range and bearing", "M", this)};
  follow_ = button("follow", "follow", "Follow the vehicle", "F2", this);
  orientations_ = {button("northUp", "north-up", "North up", "N", this),
                   button("headUp", "head-up", "Head up", "H", this),
                   button("courseUp", "course-up", "Course up", "C", this)};
  layers_ = button("layers", "layers", "Layers", "F4", this);
  links_ = button("links", "links", "Links and what they say", "F7", this);
  closer_ = button("zoomIn", "plus", "Closer", "+", this);
  farther_ = button("zoomOut", "minus", "Farther", "-", this);
  palette_ = button("palette", "palette", "Day, dusk, night", "F5", this);
  for (std::size_t i = 0; i < tools_.size(); ++i) {
    tools_[i]->setCheckable(true);
    orientations_[i]->setCheckable(true);
    // The window answers by set_tool() and set_orientation(); until then nothing has changed.
    connect(tools_[i], &ToolButton::clicked, this, [this, i](bool checked) {
      tools_[i]->setChecked(!checked);
      emit toolChosen(static_cast<Tool>(i));
    });
    connect(orientations_[i], &ToolButton::clicked, this, [this, i](bool checked) {
      orientations_[i]->setChecked(!checked);
      emit orientationChosen(static_cast<Orientation>(i));
    });
  }
  follow_->setCheckable(true);
  connect(follow_, &ToolButton::clicked, this, [this](bool checked) {
    follow_->setChecked(!checked);
    emit followToggled();
  });
  connect(layers_, &ToolButton::clicked, this, [this] { emit layersRequested(); });
  links_->setCheckable(true);
  links_->hide();
  connect(links_, &ToolButton::clicked, this, [this](bool checked) {
    links_->setChecked(!checked);
    emit linksToggled();
  });
  connect(closer_, &ToolButton::clicked, this, [this] { emit zoomed(+1); });
  connect(farther_, &ToolButton::clicked, this, [this] { emit zoomed(-1); });
  connect(palette_, &ToolButton::clicked, this, [this] { emit paletteStepped(); });
  ToolButton* before = nullptr;
  for (const auto& group : groups())
    for (ToolButton* b : group) {
      if (before) setTabOrder(before, b);
      before = b;
    }
  set_tool(Tool::select);
  set_orientation(Orientation::north_up);
  set_fold(Fold::wide);
}

std::vector<std::vector<ToolButton*>> Rail::groups() const {
  return {{tools_.begin(), tools_.end()},
          {follow_, orientations_[0], orientations_[1], orientations_[2], layers_},
          {closer_, farther_},
          {links_, palette_}};
}

void Rail::set_tool(Tool tool) {
  for (std::size_t i = 0; i < tools_.size(); ++i) tools_[i]->setChecked(i == static_cast<std::size_t>(tool));
}

void Rail::set_following(bool following) { follow_->setChecked(following); }

void Rail::set_orientation(Orientation orientation) {
  for (std::size_t i = 0; i < orientations_.size(); ++i)
    orientations_[i]->setChecked(i == static_cast<std::size_t>(orientation));
}

void Rail::set_links(bool any, bool shown) {
  links_->setChecked(shown);
  if (links_->isHidden() != any) return;
  links_->setVisible(any);
  place();
  update();
}

void Rail::set_fold(Fold fold) {
  fold_ = fold;
  setFixedWidth(sizeHint().width());
  place();
  update();
}

QSize Rail::sizeHint() const { return {fold_ == Fold::wide ? 52 : 44, 540}; }

void Rail::resizeEvent(QResizeEvent* /*event*/) { place(); }

void Rail::place() {
  // Where height is short the buttons stand closer, and are lower where that is not enough.
  auto all = groups();
  int count = 0;
  for (auto& group : all) {
    std::erase_if(group, [this](const ToolButton* b) { return b == links_ && links_->isHidden(); });
    count += static_cast<int>(group.size());
  }
  const bool roomy = height() >= count * kStep + 3 * kApart + 14;
  const int step = roomy ? kStep : std::clamp((height() - 3 * kClose - 6) / count, kLeast, kButton);
  const int high = std::min(step, kButton);
  const int between = roomy ? kApart : kClose;
  const int x = (width() - kButton) / 2;
  int y = roomy ? 8 : 3;
  rules_.clear();
  for (const auto& group : all) {
    if (y > 10) {
      rules_.push_back(y + (between - (step - high)) / 2);
      y += between;
    }
    for (ToolButton* b : group) {
      b->setGeometry(x, y, kButton, high);
      y += step;
    }
  }
}

void Rail::paintEvent(QPaintEvent* /*event*/) {
  const Colours& colours = Look::current().colours();
  QPainter painter(this);
  painter.fillRect(rect(), colours.of(Role::bg_panel));
  draw_rule(painter, {width() - 1, 0}, {width() - 1, height() - 1}, colours.of(Role::line));
  for (const int y : rules_) draw_rule(painter, {14, y}, {width() - 15, y}, colours.of(Role::line));
}

}  // namespace leadline::ui
