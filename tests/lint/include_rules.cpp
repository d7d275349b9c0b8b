#include "tests/lint/include_rules.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <string_view>

namespace leadline::lint {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 6> kRooms = {"app", "core", "maps", "plugins", "sessions", "ui"};

/// "core/nav/ins/strapdown.h" -> "core/nav"; "app/main.cpp" -> "app".
std::string folder_of(const std::string& file) {
  const auto first = file.find('/');
  if (first == std::string::npos) return "";
  const auto second = file.find('/', first + 1);
  return file.substr(0, second == std::string::npos ? first : second);
}

bool stands_for(const std::string& name, const std::string& folder) {
  return name == folder || (name.back() == '/' && (folder + "/").compare(0, name.size(), name) == 0);
}

bool stands_for(const std::vector<std::string>& names, const std::string& folder) {
  return std::any_of(names.begin(), names.end(), [&](const auto& name) { return stands_for(name, folder); });
}

bool begins_as(std::string_view header, std::string_view pattern) {
  constexpr std::string_view kCapital = "[A-Z]";
  while (!pattern.empty() && pattern != "*") {
    if (header.empty()) return false;
    const bool capital = pattern.substr(0, kCapital.size()) == kCapital;
    if (capital ? header[0] < 'A' || header[0] > 'Z' : header[0] != pattern[0]) return false;
    header.remove_prefix(1);
    pattern.remove_prefix(capital ? kCapital.size() : 1);
  }
  return true;
}

struct Include {
  std::string header;
  bool quoted = false;
};

/// The header of an #include line; empty for any other line.
Include include_of(std::string_view line) {
  const auto blanks = [&] { line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size())); };
  blanks();
  if (line.empty() || line[0] != '#') return {};
  line.remove_prefix(1);
  blanks();
  if (line.substr(0, 7) != "include") return {};
  line.remove_prefix(7);
  blanks();
  if (line.empty() || (line[0] != '"' && line[0] != '<')) return {};
  const bool quoted = line[0] == '"';
  line.remove_prefix(1);
  return {std::string(line.substr(0, line.find(quoted ? '"' : '>'))), quoted};
}

class Checker {
 public:
  Checker(const Rules& rules, Findings& findings) : rules_(rules), findings_(findings) {}

  void check(const fs::path& path, const std::string& file) {
    ++findings_.files;
    const std::string folder = folder_of(file);
    const std::vector<std::string>* allowed = row_of(folder);
    if (!allowed) findings_.problems.push_back(file + ":1: the folder " + folder + " is not in the table");
    std::ifstream in(path);
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
      const Include include = include_of(line);
      if (include.header.empty()) continue;
      const std::string wrong =
          include.quoted ? ours(folder, allowed, include.header) : foreign(folder, include.header);
      if (!wrong.empty()) findings_.problems.push_back(file + ":" + std::to_string(number) + ": " + wrong);
    }
  }

 private:
  const std::vector<std::string>* row_of(const std::string& folder) const {
    for (const auto& [name, allowed] : rules_.folders)
      if (stands_for(name, folder)) return &allowed;
    return nullptr;
  }

  std::string ours(const std::string& folder, const std::vector<std::string>* allowed,
                   const std::string& header) {
    if (header.size() > 4 && header.compare(header.size() - 4, 4, ".moc") == 0)
      return "";  // moc fixes its spelling
    const std::string room = header.substr(0, header.find('/'));
    const bool from_root = std::find(kRooms.begin(), kRooms.end(), room) != kRooms.end() || room == "tests";
    if (!from_root || room == header || header.find("/../") != std::string::npos)
      return "\"" + header + "\" is not spelt from the root";
    const std::string to = folder_of(header);
    if (to == folder) return "";
    findings_.edges.emplace(folder, to);
    // A room written as "app/" is one folder with all that is below it.
    const bool same_row = allowed && row_of(to) == allowed;
    if (!allowed || same_row || stands_for(*allowed, to)) return "";
    return folder + " must not include " + to + " (\"" + header + "\")";
  }

  std::string foreign(const std::string& folder, const std::string& header) const {
    for (const auto& library : rules_.libraries)
      if (begins_as(header, library.pattern) && !stands_for(library.homes, folder))
        return "<" + header + "> has its home elsewhere than in " + folder;
    return "";
  }

  const Rules& rules_;
  Findings& findings_;
};

}  // namespace

Rules read_rules(std::istream& text) {
  Rules rules;
  std::string line;
  while (std::getline(text, line)) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    std::string first, word;
    words >> first;
    std::vector<std::string> rest;
    while (words >> word) rest.push_back(word);
    if (first.size() > 1 && first.back() == ':') {
      first.pop_back();
      if (!rules.folders.emplace(first, rest).second) rules.errors.push_back(line);
    } else if (rest.size() > 1 && rest[0] == "->") {
      rules.libraries.push_back({first, {rest.begin() + 1, rest.end()}});
    } else {
      rules.errors.push_back(line);
    }
  }
  return rules;
}

Findings check_includes(const fs::path& root, const Rules& rules) {
  Findings findings;
  Checker checker(rules, findings);
  for (const auto room : kRooms) {
    if (!fs::is_directory(root / room)) continue;
    std::vector<fs::path> files;  // in order, so that two runs read alike
    for (const auto& entry : fs::recursive_directory_iterator(root / room))
      if (entry.is_regular_file() && (entry.path().extension() == ".h" || entry.path().extension() == ".cpp"))
        files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const auto& file : files) checker.check(file, file.lexically_relative(root).generic_string());
  }
  return findings;
}

}  // namespace leadline::lint
