// The arrangement of the house, checked: who includes whom, and which library has which home.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <iostream>
#include <sstream>

#include "tests/lint/include_rules.h"

namespace leadline::lint {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

Rules rules_of_the_house() {
  std::ifstream in(fs::path(LEADLINE_SOURCE_DIR) / "tests/lint/allowed_includes.txt");
  EXPECT_TRUE(in.good());
  return read_rules(in);
}

TEST(Includes, OfTheWholeTreeAreAllowed) {
  const Rules rules = rules_of_the_house();
  EXPECT_THAT(rules.errors, IsEmpty());
  const Findings found = check_includes(LEADLINE_SOURCE_DIR, rules);
  for (const auto& [from, to] : found.edges) std::cout << "  " << from << " -> " << to << "\n";
  std::cout << found.files << " files, " << found.edges.size() << " edges, " << found.problems.size()
            << " not allowed\n";
  for (const auto& problem : found.problems) ADD_FAILURE() << problem;
  EXPECT_GT(found.files, 20);
}

TEST(Includes, TheTableHasNoCycle) {
  // Folders are taken away once all they include is gone: what is left over is a cycle.
  std::map<std::string, std::vector<std::string>> left = rules_of_the_house().folders;
  left.erase("app/");
  for (bool progress = true; progress;) {
    progress = false;
    for (auto row = left.begin(); row != left.end();) {
      const auto is_left = [&](const std::string& to) {
        return std::any_of(left.begin(), left.end(), [&](const auto& other) {
          return other.first == to || (to.back() == '/' && other.first.compare(0, to.size(), to) == 0);
        });
      };
      const bool waits = std::any_of(row->second.begin(), row->second.end(), is_left);
      progress |= !waits;
      row = waits ? std::next(row) : left.erase(row);
    }
  }
  std::vector<std::string> cycle;
  for (const auto& [folder, to] : left) cycle.push_back(folder);
  EXPECT_THAT(cycle, IsEmpty());
}

/// A small source tree that goes away with the test.
struct Tree : testing::Test {
  fs::path root = fs::path(testing::TempDir()) / ("leadline_lint_" + std::to_string(getpid()));
  Tree() { fs::remove_all(root); }
  ~Tree() override { fs::remove_all(root); }
  void write(const std::string& file, const std::string& text) const {
    fs::create_directories((root / file).parent_path());
    std::ofstream(root / file) << text;
  }
  [[nodiscard]] std::vector<std::string> problems() const {
    return check_includes(root, rules_of_the_house()).problems;
  }
};

TEST_F(Tree, WithoutAFaultHasNoProblem) {
  write("core/flow/bus.h",
        "#pragma once\n#include <vector>\n#include \"core/flow/engine.h\"\n#include \"core/types/time.h\"\n");
  write("core/config/tree.cpp", "#include <toml++/toml.h>\n");
  write("ui/panels/p.cpp", "#include <QWidget>\n#include \"ui/chart/chart.h\"\n#include \"p.moc\"\n");
  write("app/verbs/replay.cpp",
        "#include <CLI/CLI.hpp>\n#include \"app/main.h\"\n#include \"core/nav/engines/e.h\"\n");
  const Findings found = check_includes(root, rules_of_the_house());
  EXPECT_THAT(found.problems, IsEmpty());
  EXPECT_EQ(found.files, 4);
}

TEST_F(Tree, AForbiddenEdgeIsNamedByFileAndLine) {
  write("core/types/a.h", "#pragma once\n\n#include \"core/flow/bus.h\"\n");
  write("ui/panels/p.cpp", "  #  include \"core/nav/filters/f.h\"  // why not\n");
  write("plugins/example_engine/e.cpp", "#include \"app/wiring.h\"\n");
  EXPECT_THAT(
      problems(),
      ElementsAre(
          "core/types/a.h:3: core/types must not include core/flow (\"core/flow/bus.h\")",
          "plugins/example_engine/e.cpp:1: plugins/example_engine must not include app (\"app/wiring.h\")",
          "ui/panels/p.cpp:1: ui/panels must not include core/nav (\"core/nav/filters/f.h\")"));
}

TEST_F(Tree, NobodyIncludesTests) {
  write("app/main.cpp", "#include \"tests/support/files.h\"\n");
  EXPECT_THAT(problems(),
              ElementsAre("app/main.cpp:1: app must not include tests/support (\"tests/support/files.h\")"));
}

TEST_F(Tree, AnIncludeIsSpeltFromTheRoot) {
  write("core/flow/a.cpp",
        "#include \"bus.h\"\n#include \"flow/bus.h\"\n#include \"../types/time.h\"\n"
        "#include \"core/flow/../types/time.h\"\n");
  EXPECT_THAT(problems(),
              ElementsAre("core/flow/a.cpp:1: \"bus.h\" is not spelt from the root",
                          "core/flow/a.cpp:2: \"flow/bus.h\" is not spelt from the root",
                          "core/flow/a.cpp:3: \"../types/time.h\" is not spelt from the root",
                          "core/flow/a.cpp:4: \"core/flow/../types/time.h\" is not spelt from the root"));
}

TEST_F(Tree, AFolderMustBeInTheTable) {
  write("core/utils/a.h", "#pragma once\n");
  write("core/b.h", "#pragma once\n");
  EXPECT_THAT(problems(), ElementsAre("core/b.h:1: the folder core is not in the table",
                                      "core/utils/a.h:1: the folder core/utils is not in the table"));
}

TEST_F(Tree, ALibraryStaysInItsHome) {
  write("core/nav/a.cpp",
        "#include <GeographicLib/Geodesic.hpp>\n#include <QString>\n#include <QtWidgets/QWidget>\n"
        "#include <Queue>\n#include <boost/asio.hpp>\n#include <boost/math/x.hpp>\n");
  EXPECT_THAT(
      problems(),
      ElementsAre("core/nav/a.cpp:1: <GeographicLib/Geodesic.hpp> has its home elsewhere than in core/nav",
                  "core/nav/a.cpp:2: <QString> has its home elsewhere than in core/nav",
                  "core/nav/a.cpp:3: <QtWidgets/QWidget> has its home elsewhere than in core/nav",
                  "core/nav/a.cpp:5: <boost/asio.hpp> has its home elsewhere than in core/nav"));
}

TEST(Rules, ALineThatIsNeitherIsAnError) {
  std::istringstream text(
      "# a comment\n\ncore/types:\ncore/flow: core/types\ncore/types: x\nnonsense here\nlib ->\n");
  const Rules rules = read_rules(text);
  EXPECT_EQ(rules.folders.size(), 2u);
  EXPECT_THAT(rules.errors, ElementsAre("core/types: x", "nonsense here", "lib ->"));
}

}  // namespace
}  // namespace leadline::lint
