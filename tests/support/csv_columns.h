#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "tests/support/files.h"

namespace leadline::test {

/// A table of numbers whose first line names the columns.
class CsvColumns {
 public:
  explicit CsvColumns(const std::string& path) {
    const std::string text = read_text(path);
    const char* at = text.c_str();
    while (*at != '\0' && *at != '\n') {
      std::string name;
      while (*at != '\0' && *at != ',' && *at != '\n') name += *at++;
      if (*at == ',') ++at;
      const std::size_t index = columns_.size();
      columns_[name] = index;
    }
    while (*at == '\n' && at[1] != '\0') {
      std::vector<double> row;
      row.reserve(columns_.size());
      do {
        char* end = nullptr;
        row.push_back(std::strtod(at + 1, &end));
        at = end;
      } while (*at == ',');
      EXPECT_EQ(row.size(), columns_.size()) << "row " << rows_.size();
      rows_.push_back(std::move(row));
    }
  }
  [[nodiscard]] std::size_t column(const std::string& name) const { return columns_.at(name); }
  [[nodiscard]] const std::vector<std::vector<double>>& rows() const { return rows_; }

 private:
  std::map<std::string, std::size_t> columns_;
  std::vector<std::vector<double>> rows_;
};

}  // namespace leadline::test
