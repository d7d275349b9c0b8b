// Colours live in the role table: no other file under ui/ names one.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>

namespace leadline::ui {
namespace {

namespace fs = std::filesystem;

const std::regex& forbidden() {
  static const std::regex kForbidden(
      R"(#[0-9A-Fa-f]{6}\b|"#[0-9A-Fa-f]{3}"|\b0x[Ff][Ff][0-9A-Fa-f]{6}\b)"
      R"(|\bQt::(white|black|red|darkRed|green|darkGreen|blue|darkBlue|cyan|darkCyan|magenta|darkMagenta|yellow|darkYellow|gray|darkGray|lightGray)\b)"
      R"(|\bQColorConstants\b|\bQColor\s*\(\s*(?!0, 0, 0, 0\))["0-9])");
  return kForbidden;
}

TEST(ColourLint, NoFileButTheRoleTableNamesAColour) {
  const fs::path root = fs::path(LEADLINE_SOURCE_DIR) / "ui";
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    const std::string kind = entry.path().extension().string();
    if (kind != ".h" && kind != ".cpp" && kind != ".qss" && kind != ".svg") continue;
    if (entry.path() == root / "look" / "role.h") continue;
    ++files;
    std::ifstream in(entry.path());
    std::string line;
    for (int number = 1; std::getline(in, line); ++number)
      EXPECT_FALSE(std::regex_search(line, forbidden()))
          << entry.path().lexically_relative(root.parent_path()).string() << ":" << number << ": " << line;
  }
  EXPECT_GT(files, 40);
}

TEST(ColourLint, SeesWhatItLooksFor) {
  for (const char* line : {"QColor(\"#A0B1C2\")", "pen(Qt::red)", "QColor(12, 3, 4)", "return 0xFF102030;"})
    EXPECT_TRUE(std::regex_search(line, forbidden())) << line;
  for (const char* line : {"#include <QColor>", "fill(Qt::transparent)", "QColor(0, 0, 0, 0)",
                           "colours.of(Role::ink)", "Qt::NoPen"})
    EXPECT_FALSE(std::regex_search(line, forbidden())) << line;
}

}  // namespace
}  // namespace leadline::ui
