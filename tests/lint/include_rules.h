#pragma once

#include <filesystem>
#include <iosfwd>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace leadline::lint {

/// The table of allowed edges: folder: folders, and library header -> folders. A name with a "/" at its end
/// stands for all folders below it.
struct Rules {
  struct Library {
    std::string pattern;  ///< beginning of the header's name; "[A-Z]" is any capital letter
    std::vector<std::string> homes;
  };
  std::map<std::string, std::vector<std::string>> folders;
  std::vector<Library> libraries;
  std::vector<std::string> errors;  ///< lines that are neither
};
[[nodiscard]] Rules read_rules(std::istream& text);

/// What the includes of a source tree are, and which of them the rules do not allow.
struct Findings {
  int files = 0;
  std::set<std::pair<std::string, std::string>> edges;  ///< between different folders
  std::vector<std::string> problems;                    ///< "core/types/a.h:3: what is wrong"
};

/// Reads the .h and .cpp files below app, core, sessions, plugins, ui and maps of `root`.
[[nodiscard]] Findings check_includes(const std::filesystem::path& root, const Rules& rules);

}  // namespace leadline::lint
