// repeat_log FILE N: a stamped text log N times over, each time a day later. The dates inside ZDA and RMC
// move with the stamps, so that the long log is as true as the short one.

#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "core/types/time.h"

namespace {

using namespace leadline;

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> fields(1);
  for (const char c : text) {
    if (c == ',')
      fields.emplace_back();
    else
      fields.back().push_back(c);
  }
  return fields;
}

/// The sentence with its date `days` later and its checksum, if it had one, made anew.
std::string later(std::string sentence, std::int64_t days) {
  const bool is_zda = sentence.find("ZDA,") != std::string::npos,
             is_rmc = sentence.find("RMC,") != std::string::npos;
  if (!is_zda && !is_rmc) return sentence;
  const auto star = sentence.find('*');
  const bool checked = star != std::string::npos;
  auto fields = split(sentence.substr(0, star));
  Civil c;
  if (is_zda)
    c = {std::stoi(fields[4]), std::stoi(fields[3]), std::stoi(fields[2])};
  else
    c = {2000 + std::stoi(fields[9].substr(4, 2)), std::stoi(fields[9].substr(2, 2)),
         std::stoi(fields[9].substr(0, 2))};
  const Civil moved = to_civil(*from_civil(c) + std::chrono::hours(24 * days));
  if (is_zda) {
    fields[2] = fmt::format("{:02}", moved.day);
    fields[3] = fmt::format("{:02}", moved.month);
    fields[4] = fmt::format("{:04}", moved.year);
  } else {
    fields[9] = fmt::format("{:02}{:02}{:02}", moved.day, moved.month, moved.year % 100);
  }
  std::string out = fields[0];
  for (std::size_t i = 1; i < fields.size(); ++i) out += "," + fields[i];
  if (!checked) return out;
  unsigned sum = 0;
  for (std::size_t i = 1; i < out.size(); ++i) sum ^= static_cast<unsigned char>(out[i]);
  return out + fmt::format("*{:02X}", sum);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return std::fputs("repeat_log FILE N\n", stderr), 2;
  std::vector<std::string> lines;
  std::ifstream in(argv[1]);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  std::string out;
  for (std::int64_t day = 0; day < std::stoi(argv[2]); ++day) {
    for (const auto& line : lines) {
      const auto blank = line.find(' ');
      const auto stamp = parse_iso8601(line.substr(0, blank));
      if (!stamp) return std::fprintf(stderr, "no stamp: %s\n", line.c_str()), 1;
      out +=
          iso8601(*stamp + std::chrono::hours(24 * day), 6) + " " + later(line.substr(blank + 1), day) + "\n";
    }
    std::cout << out;
    out.clear();
  }
  return std::cout.good() ? 0 : 1;
}
