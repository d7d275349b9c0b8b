// The raw monitor in the window: where it stands, when it is there, how it looks.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>

#include "tests/support/picture.h"
#include "tests/ui/shown.h"
#include "ui/models/link_rows.h"
#include "ui/panels/link_panel.h"

namespace leadline::ui {
namespace {

/// Six links of the moment made by hand: one failed, one that refuses, one with drops, two sources on one.
std::vector<LinkState> links_of(Snapshot& snapshot) {
  snapshot.sources[1].refused = 3;
  snapshot.sources[1].last_refusal = "checksum";
  snapshot.sources[3].last = snapshot.now - std::chrono::seconds(161);
  snapshot.sources[3].rate_hz = 0.0;
  snapshot.sources[3].latency_s.reset();
  return {{"tcp://192.168.2.15:1034", {0}, true, "", 41'204'311, 41'180, 0},
          {"udp://:4002", {1}, true, "", 1'204'511, 12'407, 0},
          {"udp://239.192.0.4:60004", {2}, true, "", 9'310'884'120, 11'204'311, 1'204},
          {"serial:///dev/ttyUSB0?baud=9600",
           {3},
           false,
           "permission denied: add yourself to the group dialout",
           4'120,
           96,
           0},
          {"udp://:4005", {4, 5}, true, "address already in use", 8'411'202, 101'204, 0}};
}

void say(RawTail& tail, Time now) {
  std::uint64_t seq = 0;
  const auto hear = [&](SourceId source, std::string_view bytes, int age_ms, const char* refused = nullptr) {
    Envelope e;
    e.seq = ++seq;
    e.arrival = Arrival{(now - std::chrono::milliseconds(age_ms)).ns};
    e.source = source;
    e.message = RawFrame{{reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()},
                         source == 0 ? "" : "192.168.2.20:4002"};
    tail.take(e);
    if (refused == nullptr) return;
    e.raw = e.seq;
    e.seq = ++seq;
    e.message = Rejected{refused, 0, 0};
    tail.take(e);
  };
  for (int i = 30; i > 0; --i) {
    hear(1, "$PSIMSSB,140" + std::to_string(100 + i) + ".21,B07,A,,C,H,M,12.41,-8.20,1512.6,0.81,N,,*5A\r\n",
         8'000 * i + 431);
    if (i == 2)
      hear(1,
           "$PSIMSSB,140\x1B"
           "11.02,B07,A,,C,H,M,1\xF0.4,-8.2,1511.9*00\r\n",
           12'218, "checksum");
  }
  hear(1, {"\x7F\x7F\xB6\x02\x00\x06\x12\x00\x4D\x00\x8E\x00\x50\x01\xA2\x01\x00\x02", 18}, 2'004, "unknown");
  std::string ensemble("\x7F\x7F", 2);
  for (int i = 0; i < 700; ++i) ensemble += static_cast<char>(i * 37 % 251);
  for (int i = 10; i > 0; --i) hear(0, ensemble, 200 * i);
}

class ConsoleLinks : public testing::Test {
 protected:
  void show(QSize size, Palette palette, bool replay = false) {
    Look::current().set(palette);
    made_.snapshot.replay = replay;
    background_.load_coastline(LEADLINE_CHARTS);
    window_.chart().set_background(&background_);
    window_.resize(size);
    window_.set_history(&made_.history, 0);
    window_.chart().set_metres_per_px(0.7);
    window_.chart().set_centre(made_.snapshot.vehicle->solution.position);
    const auto links = links_of(made_.snapshot);
    window_.show_snapshot(made_.snapshot);
    say(tail_, made_.snapshot.now);
    window_.link_panel().set_tail(&tail_);
    window_.set_links(link_rows(links, made_.snapshot));
    window_.freeze();
    window_.show();
    window_.setFocus();
    QApplication::processEvents();
  }
  QImage picture(QSize size, Palette palette) {
    show(size, palette);
    window_.show_link_panel(true);
    window_.link_panel().select("udp://:4002");
    return test::picture_of(window_, window_.chart());
  }
  void press(const char* name) {
    auto* action = window_.findChild<QAction*>(QString::fromLatin1(name));
    ASSERT_NE(action, nullptr);
    action->trigger();
    QApplication::processEvents();
  }
  [[nodiscard]] bool rail_has_it() const {
    return window_.findChild<QAbstractButton*>(QStringLiteral("links"))->isVisible();
  }

  test::HandMade made_ = test::hand_made(test::kEastSea);
  Background background_;
  RawTail tail_{6};
  ConsoleWindow window_;
};

TEST_F(ConsoleLinks, LookAsTheyDidWhenLookedAtByDay) {
  test::expect_picture(picture({1920, 1080}, Palette::day), "console_links_day");
}

TEST_F(ConsoleLinks, LookAsTheyDidWhenLookedAtByNightWithinItsLimits) {
  const QImage night = picture({1280, 800}, Palette::night);
  test::expect_picture(night, "console_links_night");
  double mean = 0.0, most = 0.0;
  for (int y = 0; y < night.height(); ++y)
    for (int x = 0; x < night.width(); ++x) {
      const double l = test::luminance(night.pixel(x, y));
      mean += l;
      most = std::max(most, l);
    }
  mean /= static_cast<double>(night.width()) * night.height();
  std::printf("night with links: mean luminance %.4f, highest %.3f\n", mean, most);
  EXPECT_LE(mean, 0.020);
  EXPECT_LE(most, 0.305);
}

TEST_F(ConsoleLinks, LookAsTheyDidWhenLookedAtInTheSmallestWindow) {
  test::expect_picture(picture({800, 600}, Palette::dusk), "console_links_small_dusk");
}

TEST_F(ConsoleLinks, AreFoldedUntilAskedForAndAbsentWithoutLinksAndInReplay) {
  show({1280, 800}, Palette::day);
  LinkPanel& panel = window_.link_panel();
  EXPECT_FALSE(panel.isVisible());
  EXPECT_TRUE(rail_has_it());
  const QRect before = window_.chart().geometry();
  press("links");
  EXPECT_TRUE(panel.isVisible());
  EXPECT_LT(window_.chart().height(), before.height());
  press("links");
  EXPECT_FALSE(panel.isVisible());
  EXPECT_EQ(window_.chart().geometry(), before);
  window_.findChild<QAbstractButton*>(QStringLiteral("links"))->click();
  EXPECT_TRUE(panel.isVisible());
  made_.snapshot.replay = true;
  window_.show_snapshot(made_.snapshot);
  EXPECT_FALSE(panel.isVisible());
  EXPECT_FALSE(rail_has_it());
  made_.snapshot.replay = false;
  window_.show_snapshot(made_.snapshot);
  EXPECT_TRUE(panel.isVisible());
  window_.set_links({});
  EXPECT_FALSE(panel.isVisible());
  EXPECT_FALSE(rail_has_it());
  EXPECT_EQ(window_.chart().geometry(), before);
}

TEST_F(ConsoleLinks, NothingOverlapsAtAnySize) {
  for (const QSize size : {QSize(800, 600), QSize(1024, 768), QSize(1280, 800), QSize(1600, 900),
                           QSize(1920, 1080), QSize(3840, 2160)})
    for (const bool drawer : {false, true}) {
      show(size, Palette::day);
      window_.show_link_panel(!drawer);
      if (drawer) press("regions");
      QApplication::processEvents();
      std::vector<QWidget*> parts;
      for (QObject* child : window_.children())
        if (auto* widget = qobject_cast<QWidget*>(child);
            widget != nullptr && widget->isVisible() && widget->objectName() != "focusRing")
          parts.push_back(widget);
      for (QWidget* a : parts) {
        EXPECT_TRUE(window_.rect().contains(a->geometry())) << a->objectName().toStdString();
        for (QWidget* b : parts)
          EXPECT_TRUE(a == b || !a->geometry().intersects(b->geometry()))
              << a->objectName().toStdString() << " over " << b->objectName().toStdString();
      }
      EXPECT_EQ(window_.link_panel().isVisible(), !drawer);
      if (!drawer) {
        EXPECT_GE(window_.link_panel().height(), 190) << size.height();
        EXPECT_GE(window_.link_panel().width(), 640) << size.width();
      }
      EXPECT_GE(window_.chart().width(), size.width() / 2);
      EXPECT_GE(window_.chart().height(), size.height() * 2 / 5);
      auto* rail = window_.findChild<QWidget*>(QStringLiteral("rail"));
      if (!rail->isVisible()) continue;
      for (auto* button : rail->findChildren<QAbstractButton*>())
        EXPECT_TRUE(rail->rect().contains(button->geometry()))
            << button->objectName().toStdString() << " at " << size.height();
    }
}

TEST_F(ConsoleLinks, AreReachedByKeyboard) {
  show({1920, 1080}, Palette::day);
  window_.show_link_panel(true);
  window_.chart().setFocus();
  press("regions");
  EXPECT_TRUE(window_.link_panel().isAncestorOf(QApplication::focusWidget()));
}

}  // namespace
}  // namespace leadline::ui
