#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/support/files.h"

namespace leadline::test {

/// A folder of this test's own, empty at its start.
inline std::string scratch_folder() {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  const std::string path =
      std::string(LEADLINE_BINARY_DIR) + "/scratch/" + info->test_suite_name() + "." + info->name();
  std::filesystem::remove_all(path);
  std::filesystem::create_directories(path);
  return path;
}

inline std::string write_file(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

struct Ran {
  int status = -1;
  std::string out, err;
};

/// Runs `leadline` with a shell's words.
inline Ran leadline(const std::string& words) {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  const std::string err_path = std::string(LEADLINE_BINARY_DIR) + "/scratch/" + info->test_suite_name() +
                               "." + info->name() + ".stderr";
  std::filesystem::create_directories(std::string(LEADLINE_BINARY_DIR) + "/scratch");
  const std::string command = std::string(LEADLINE_PROGRAM) + " " + words + " 2>" + err_path;
  Ran ran;
  std::FILE* pipe = ::popen(command.c_str(), "r");
  EXPECT_NE(pipe, nullptr);
  std::array<char, 4096> buffer;
  for (std::size_t n; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    ran.out.append(buffer.data(), n);
  const int status = ::pclose(pipe);
  ran.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
  ran.err = read_text(err_path);
  return ran;
}

}  // namespace leadline::test
