#include "core/links/file_reader.h"

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "tests/support/files.h"
#include "tests/unit/core/links/made_file.h"

namespace leadline::links {
namespace {

using test::MadeFile;

std::vector<std::pair<std::string, bool>> lines_of(FileReader& reader) {
  std::vector<std::pair<std::string, bool>> lines;
  for (std::string_view line; reader.line(line);) lines.emplace_back(line, reader.line_goes_on());
  return lines;
}

TEST(FileReader, SaysWhatIsWrongWithAFileThatIsMissingAFolderOrClosedToUs) {
  const auto missing = FileReader::open("/no/such/file.tlog");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().line(), "/no/such/file.tlog: there is no such file; check the path");

  const auto folder = FileReader::open(::testing::TempDir());
  ASSERT_FALSE(folder);
  EXPECT_THAT(folder.error().line(), ::testing::HasSubstr("is a folder; name the files in it"));

  const auto device = FileReader::open("/dev/null");
  ASSERT_FALSE(device);
  EXPECT_THAT(device.error().line(), ::testing::HasSubstr("is not a plain file"));

  const MadeFile secret("x");
  ASSERT_EQ(::chmod(secret.path().c_str(), 0), 0);
  const bool root = ::geteuid() == 0;
  if (root) {
    ASSERT_EQ(::seteuid(65534), 0);
  }
  const auto closed = FileReader::open(secret.path());
  if (root) {
    ASSERT_EQ(::seteuid(0), 0);
  }
  ASSERT_FALSE(closed);
  EXPECT_THAT(closed.error().line(), ::testing::HasSubstr("may not be read; give yourself read permission"));
}

TEST(FileReader, ANamedPipeIsRefusedInsteadOfWaitingForAWriter) {
  const std::string path = ::testing::TempDir() + "leadline_links_pipe_" + std::to_string(::getpid());
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  EXPECT_FALSE(FileReader::open(path));
  ::unlink(path.c_str());
}

TEST(FileReader, LinesKeepTheirTerminatorsAndTheLastMayHaveNone) {
  const MadeFile file("one\r\n\ntwo");
  FileReader reader = file.open();
  using Lines = std::vector<std::pair<std::string, bool>>;
  EXPECT_EQ(lines_of(reader), (Lines{{"one\r\n", false}, {"\n", false}, {"two", false}}));
  EXPECT_EQ(reader.offset(), reader.size());
  reader.rewind();
  EXPECT_EQ(lines_of(reader).size(), 3u);
  EXPECT_FALSE(reader.failure());
}

TEST(FileReader, ALineAboveTheCeilingComesInFlaggedPieces) {
  constexpr std::size_t kCeiling = FileReader::kLineCeiling;
  const MadeFile file(std::string(2 * kCeiling + 7, 'x') + "\n" + std::string(kCeiling - 1, 'y') + "\n" +
                      std::string(kCeiling, 'z'));
  FileReader reader = file.open();
  const auto lines = lines_of(reader);
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(lines[0].first.size(), kCeiling);
  EXPECT_TRUE(lines[0].second);
  EXPECT_TRUE(lines[1].second);
  EXPECT_EQ(lines[2], std::make_pair(std::string(7, 'x') + "\n", false));
  EXPECT_EQ(lines[3].first.size(), kCeiling) << "its terminator is the last that fits";
  EXPECT_FALSE(lines[3].second);
  EXPECT_EQ(lines[4].first.size(), kCeiling);
  EXPECT_FALSE(lines[4].second) << "the file ends there: nothing goes on";
}

TEST(FileReader, LinesAcrossTheWindowsEdgeAreTheSameAsAnywhere) {
  std::string content;
  for (int i = 0; content.size() < 5 * FileReader::kWindow / 2; ++i)
    content += std::to_string(i) + std::string(static_cast<std::size_t>(i % 97), '.') + "\n";
  const MadeFile file(content);
  FileReader reader = file.open();
  std::string joined;
  int expected = 0;
  for (std::string_view line; reader.line(line); joined += line)
    ASSERT_EQ(line.substr(0, line.find_first_of(".\n")), std::to_string(expected++));
  EXPECT_EQ(joined, content);
}

TEST(FileReader, TakeGivesAllBytesInOrderAndPeekConsumesNone) {
  std::string content(3 * FileReader::kWindow + 11, '\0');
  for (std::size_t i = 0; i < content.size(); ++i) content[i] = static_cast<char>(i * 2654435761u >> 13);
  const MadeFile file(content);
  FileReader reader = file.open();
  std::string joined;
  for (std::size_t n = 1;; n = n * 7 % (FileReader::kWindow + 1)) {
    const auto peeked = reader.peek(n);
    const std::string ahead(peeked.begin(), peeked.end());
    const auto bytes = reader.take(n);
    ASSERT_EQ(ahead, std::string(bytes.begin(), bytes.end()));
    joined += ahead;
    if (bytes.empty()) break;
  }
  EXPECT_EQ(joined, content);
}

TEST(FileReader, AFileCutShortWhileWeReadEndsEarly) {
  const MadeFile file(std::string(4 * FileReader::kWindow, 'x'));
  FileReader reader = file.open();
  EXPECT_EQ(reader.take(1000).size(), 1000u);
  std::filesystem::resize_file(file.path(), 10);
  std::size_t rest = 0;
  for (auto bytes = reader.take(65536); !bytes.empty(); bytes = reader.take(65536)) rest += bytes.size();
  EXPECT_EQ(rest, FileReader::kWindow - 1000) << "what was read before is all there is";
}

TEST(FileReader, ADiskThatFailsIsReported) {
  auto opened = FileReader::open("/proc/self/mem");  // address 0 cannot be read: EIO
  ASSERT_TRUE(opened) << opened.error().line();
  FileReader reader = std::move(opened).value();
  EXPECT_TRUE(reader.take(10).empty());
  ASSERT_TRUE(reader.failure());
  EXPECT_THAT(reader.failure()->line(), ::testing::HasSubstr("/proc/self/mem: cannot be read further"));
}

}  // namespace
}  // namespace leadline::links
