// main() of every test that draws: no screen, no scaling, one look.

#include <gtest/gtest.h>

#include <QApplication>

// fontconfig keeps what it read of fonts registered by a program until the process ends.
extern "C" const char* __lsan_default_suppressions();  // NOLINT: the leak checker's name for it
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig"; }  // NOLINT

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  qputenv("QT_SCALE_FACTOR", "1");
  qputenv("QT_FONT_DPI", "96");
  qunsetenv("QT_PLUGIN_PATH");
  qunsetenv("QT_STYLE_OVERRIDE");
  // Never deleted: Qt's offscreen plugin loses its screen then, which the leak checker would tell as ours.
  static const auto* const application = new QApplication(argc, argv);
  Q_UNUSED(application)
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
