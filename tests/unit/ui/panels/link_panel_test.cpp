#include "ui/panels/link_panel.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QKeyEvent>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QTemporaryDir>
#include <fstream>
#include <sstream>

#include "ui/look/look.h"
#include "ui/widgets/button.h"
#include "ui/widgets/link_table.h"

namespace leadline::ui {
namespace {

struct LinkPanelTest : testing::Test {
  LinkPanelTest() {
    Look::current().set(Palette::day);
    LinkRow dvl, usbl;
    dvl.sources = {0}, dvl.names = {"dvl"}, dvl.address = "udp://:4001", dvl.state = LinkRow::State::open;
    usbl.sources = {1}, usbl.names = {"usbl"}, usbl.address = "serial:///dev/ttyS1";
    usbl.state = LinkRow::State::failed;
    usbl.last_error = "permission denied: <b>add yourself</b> to the group dialout";
    rows = {dvl, usbl};
    hear(0, "$DVL,1\r\n");
    hear(0, "$DVL,2\r\n", "checksum");
    hear(1, "<b>bold</b>\x1B[31m&amp;<br>\r\n");
    panel.set_tail(&tail);
    panel.resize(900, 380);
    panel.show();
    panel.set(rows);
    QApplication::processEvents();
  }
  ~LinkPanelTest() override { panel.set_tail(nullptr); }
  void hear(SourceId source, std::string_view bytes, const char* refused = nullptr) {
    Envelope e;
    e.seq = ++seq;
    e.arrival = Arrival{(at_ms += 200) * 1'000'000};
    e.source = source;
    e.message = RawFrame{{reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, "h:1"};
    tail.take(e);
    if (refused == nullptr) return;
    e.raw = seq;
    e.seq = ++seq;
    e.message = Rejected{refused, 0, 0};
    tail.take(e);
  }
  Button* button(const char* name) { return panel.findChild<Button*>(QString::fromLatin1(name)); }
  std::string text() {
    return panel.findChild<QPlainTextEdit*>(QStringLiteral("rawView"))->toPlainText().toStdString();
  }
  LinkTable* table() { return panel.findChild<LinkTable*>(QStringLiteral("linkTable")); }

  RawTail tail{2};
  LinkPanel panel;
  std::vector<LinkRow> rows;
  std::uint64_t seq = 0;
  std::int64_t at_ms = 1'789'394'557'000;  // 2026-09-14T14:02:37Z
};

TEST_F(LinkPanelTest, ShowsWhatTheSelectedLinkSaysToTheMillisecond) {
  EXPECT_EQ(panel.selected(), "udp://:4001");
  EXPECT_EQ(text(), "14:02:37.200   $DVL,1\n14:02:37.400 × checksum · $DVL,2");
  hear(0, "$DVL,3\r\n");
  panel.set(rows);
  EXPECT_NE(text().find("14:02:37.800   $DVL,3"), std::string::npos);
}

TEST_F(LinkPanelTest, NothingHeardIsTakenForMarkup) {
  QKeyEvent down(QEvent::KeyPress, Qt::Key_Down, Qt::NoModifier);
  QApplication::sendEvent(table(), &down);
  EXPECT_EQ(panel.selected(), "serial:///dev/ttyS1");
  EXPECT_EQ(text(), "14:02:37.600   <b>bold</b>‹1B›[31m&amp;<br>");
  EXPECT_TRUE(table()->accessibleDescription().contains(
      QStringLiteral("failed · permission denied: <b>add yourself</b> to the group dialout")));
}

TEST_F(LinkPanelTest, SelectsByKeyByMouseAndByAddress) {
  const auto press = [&](int key) {
    QKeyEvent event(QEvent::KeyPress, key, Qt::NoModifier);
    QApplication::sendEvent(table(), &event);
    return panel.selected();
  };
  EXPECT_EQ(press(Qt::Key_Up), "udp://:4001");
  EXPECT_EQ(press(Qt::Key_End), "serial:///dev/ttyS1");
  EXPECT_EQ(press(Qt::Key_Home), "udp://:4001");
  QMouseEvent click(QEvent::MouseButtonPress, QPointF(100, 19 * 2 + 9), Qt::LeftButton, Qt::LeftButton,
                    Qt::NoModifier);
  QApplication::sendEvent(table()->viewport(), &click);
  EXPECT_EQ(panel.selected(), "serial:///dev/ttyS1");
  panel.select("udp://:9999");
  EXPECT_EQ(panel.selected(), "serial:///dev/ttyS1");
  std::swap(rows[0], rows[1]);
  panel.set(rows);
  EXPECT_EQ(panel.selected(), "serial:///dev/ttyS1") << "the link, not its place";
  EXPECT_EQ(table()->selected(), 0);
  panel.set({rows[1]});
  EXPECT_EQ(panel.selected(), "udp://:4001");
  panel.set({});
  EXPECT_EQ(panel.selected(), "");
  EXPECT_EQ(text(), "");
}

TEST_F(LinkPanelTest, HeldTextStandsStillAndIsAllThereWhenItGoesOn) {
  button("holdText")->click();
  const std::string before = text();
  hear(0, "$DVL,3\r\n", "range");
  panel.set(rows);
  EXPECT_EQ(text(), before);
  EXPECT_EQ(button("holdText")->accessibleName(), QStringLiteral("Resume"));
  EXPECT_EQ(button("holdText")->shortcut(), QKeySequence("Alt+P"));
  button("refusedOnly")->click();
  EXPECT_EQ(text(), "14:02:37.400 × checksum · $DVL,2") << "of what is held";
  button("holdText")->click();
  EXPECT_EQ(text(), "14:02:37.400 × checksum · $DVL,2\n14:02:37.800 × range · $DVL,3");
  button("refusedOnly")->click();
  EXPECT_EQ(panel.lines().size(), 3U);
}

TEST_F(LinkPanelTest, ClearEmptiesTheTextOfThisLinkOnly) {
  button("clearText")->click();
  EXPECT_EQ(text(), "");
  hear(0, "$DVL,3\r\n");
  panel.set(rows);
  EXPECT_EQ(panel.lines().size(), 1U);
  panel.select("serial:///dev/ttyS1");
  EXPECT_EQ(panel.lines().size(), 1U);
}

TEST_F(LinkPanelTest, SavesWhatIsShownInFullAndSaysWhyItCannot) {
  const std::string all(5'000, 'x');
  hear(0, all + "\r\n");
  panel.set(rows);
  EXPECT_LT(text().size(), 1'000U);
  QTemporaryDir folder;
  const QString file = folder.filePath(QStringLiteral("raw.txt"));
  ASSERT_TRUE(panel.save(file));
  std::ifstream in(file.toStdString());
  std::stringstream saved;
  saved << in.rdbuf();
  EXPECT_EQ(saved.str(),
            "2026-09-14T14:02:37.200Z\t\th:1\t$DVL,1\n"
            "2026-09-14T14:02:37.400Z\trefused checksum\th:1\t$DVL,2\n"
            "2026-09-14T14:02:37.800Z\t\th:1\t" +
                all + "\n");
  const auto failed = panel.save(QStringLiteral("/nowhere/at/all/raw.txt"));
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().where, "/nowhere/at/all/raw.txt");
  EXPECT_FALSE(failed.error().what.empty());
}

TEST_F(LinkPanelTest, FollowsTheNewestUntilTheOperatorScrollsBack) {
  auto* view = panel.findChild<QPlainTextEdit*>(QStringLiteral("rawView"));
  for (int i = 0; i < 150; ++i) hear(0, "$FULL," + std::to_string(i) + "\r\n");
  panel.set(rows);
  QApplication::processEvents();
  QScrollBar* bar = view->verticalScrollBar();
  ASSERT_GT(bar->maximum(), 50);
  EXPECT_EQ(bar->value(), bar->maximum());
  panel.resize(900, 300);
  QApplication::processEvents();
  EXPECT_EQ(bar->value(), bar->maximum()) << "also when there is less room";
  bar->setValue(20);
  hear(0, "$MORE\r\n");
  panel.set(rows);
  EXPECT_EQ(bar->value(), 20);
}

TEST_F(LinkPanelTest, NothingOverlapsOrIsClippedAtAnySizeAndEverythingHasItsNames) {
  for (int i = 0; i < 20; ++i) {
    rows.push_back(rows[1]);
    rows.back().address += std::to_string(i);
  }
  panel.set(rows);
  for (const QSize size : {QSize(788, 190), QSize(892, 300), QSize(1448, 432), QSize(3360, 864)}) {
    panel.resize(size);
    QApplication::processEvents();
    std::vector<QWidget*> parts;
    for (QObject* child : panel.children())
      if (auto* widget = qobject_cast<QWidget*>(child); widget != nullptr && widget->isVisible())
        if (widget->objectName() != QStringLiteral("focusRing")) parts.push_back(widget);
    EXPECT_EQ(parts.size(), 6U);
    for (QWidget* a : parts) {
      EXPECT_TRUE(panel.rect().contains(a->geometry())) << a->objectName().toStdString();
      EXPECT_FALSE(a->accessibleName().isEmpty()) << a->objectName().toStdString();
      EXPECT_TRUE(a->focusPolicy() & Qt::TabFocus) << a->objectName().toStdString();
      EXPECT_GE(a->height(), 28) << a->objectName().toStdString();
      for (QWidget* b : parts)
        EXPECT_TRUE(a == b || !a->geometry().intersects(b->geometry())) << a->objectName().toStdString();
      if (auto* acts = qobject_cast<Button*>(a)) {
        EXPECT_TRUE(acts->toolTip().contains(QStringLiteral("(Alt+"))) << acts->objectName().toStdString();
        EXPECT_GE(acts->width(), acts->sizeHint().width()) << acts->objectName().toStdString();
      }
    }
    QKeyEvent end(QEvent::KeyPress, Qt::Key_End, Qt::NoModifier),
        home(QEvent::KeyPress, Qt::Key_Home, Qt::NoModifier);
    QApplication::sendEvent(table(), &end);
    EXPECT_EQ(table()->verticalScrollBar()->value(), table()->verticalScrollBar()->maximum());
    QApplication::sendEvent(table(), &home);
    EXPECT_EQ(table()->verticalScrollBar()->value(), 0);
  }
}

}  // namespace
}  // namespace leadline::ui
