// Each way of being wrong has a plugin in tests/data/plugins; each is refused with a sentence, the rest
// starts.

#include "plugins/host/plugin_host.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <QCoreApplication>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "plugins/sdk/interface_version.h"
#include "tests/support/program.h"

namespace leadline {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::MatchesRegex;

fs::path fixture(const std::string& name) { return fs::path(LEADLINE_TEST_PLUGINS) / name; }

PluginHost load(const std::vector<fs::path>& folders, const fs::path& program = "/nonexistent") {
  return PluginHost::load({.program = program, .plugin_paths = folders, .taken_decoders = {"nmea0183"}});
}

std::vector<std::string> names(const std::vector<PluginOffer>& offers) {
  std::vector<std::string> all;
  for (const auto& offer : offers) all.push_back(offer.name);
  return all;
}

/// One refusal beside a healthy plugin that starts; gives the sentence.
std::string refusal_of(const fs::path& folder, const std::string& file) {
  const auto host = load({fixture("healthy"), folder});
  EXPECT_THAT(names(host.engines()), ElementsAre("healthy"));
  EXPECT_EQ(host.refusals().size(), 1u);
  if (host.refusals().empty()) return "";
  const Error& error = host.refusals()[0];
  EXPECT_THAT(error.where, AllOf(HasSubstr("/"), HasSubstr(file)));
  EXPECT_FALSE(error.remedy.empty());
  std::cout << error.line() << "\n";
  for (const char c : error.line()) EXPECT_GE(static_cast<unsigned char>(c), 0x20);
  return error.what + "; " + error.remedy;
}
std::string refusal_of(const std::string& name) { return refusal_of(fixture(name), name + ".so"); }

TEST(PluginHost, RefusesMetadataThatDoesNotFit) {
  EXPECT_THAT(refusal_of("wrong_number"),
              HasSubstr("was built for plugin interface 999, this program has 1; build it"));
  EXPECT_THAT(refusal_of("wrong_hash"),
              HasSubstr("was built with other interface headers (hash 0123456789ab, this program has " +
                        std::string(kInterfaceHash.substr(0, 12))));
  EXPECT_THAT(refusal_of("wrong_kind"), HasSubstr("is of kind \"painter\"; there are engine and decoder"));
  EXPECT_THAT(refusal_of("bad_name"), HasSubstr("its name \"Bad [31m Name\" is not made of"));
  EXPECT_THAT(refusal_of("no_metadata"), HasSubstr("carries no metadata"));
  EXPECT_THAT(refusal_of("foreign"),
              HasSubstr("is a plugin of another program (\"org.example.ImageFormat\")"));
}

TEST(PluginHost, RefusesTheSecondOfAName) {
  EXPECT_THAT(refusal_of("duplicate_plugin"),
              AllOf(HasSubstr("is called \"healthy\" like "), HasSubstr("healthy.so")));
  EXPECT_THAT(refusal_of("duplicate_engine"),
              AllOf(HasSubstr("brings \"healthy\", which "), HasSubstr("healthy.so")));
  EXPECT_THAT(refusal_of("duplicate_table"),
              HasSubstr("brings the table [navigation.healthy], which is there already"));
}

TEST(PluginHost, RefusesWhatCannotBeLoaded) {
  EXPECT_THAT(refusal_of("unresolved"),
              AllOf(HasSubstr("cannot be loaded"), HasSubstr("a_function_that_nobody_has")));
  EXPECT_THAT(refusal_of("wrong_root"),
              HasSubstr("says it is of kind \"engine\", but its root object is not"));
  EXPECT_THAT(refusal_of("throws_at_load"), HasSubstr("threw an exception while it was loaded"));
  EXPECT_THAT(refusal_of("throws_when_asked"), HasSubstr("threw an exception: ask somebody else"));
}

TEST(PluginHost, RefusesFilesThatAreDamagedOrNoPlugins) {
  const fs::path folder = test::scratch_folder();
  const auto refused = [&](const std::string& name) {
    const std::string sentence = refusal_of(folder, name);
    fs::remove(folder / name);
    return sentence;
  };
  test::write_file((folder / "text.so").string(), "I am a plugin, honestly.\n");
  EXPECT_THAT(refused("text.so"), HasSubstr("is not a plugin, or a damaged one"));
  test::write_file((folder / "empty.so").string(), "");
  EXPECT_THAT(refused("empty.so"), HasSubstr("is not a plugin, or a damaged one"));
  fs::create_directory(folder / "folder.so");
  EXPECT_THAT(refused("folder.so"), HasSubstr("is no file that can be read"));
  fs::create_symlink("/nowhere/at/all.so", folder / "dangling.so");
  EXPECT_THAT(refused("dangling.so"), HasSubstr("is no file that can be read"));
  ASSERT_EQ(::mkfifo((folder / "pipe.so").c_str(), 0600), 0);
  EXPECT_THAT(refused("pipe.so"), HasSubstr("is no file that can be read"));
  fs::copy_file(LEADLINE_BINARY_DIR "/libleadline-core.so", folder / "library.so");
  EXPECT_THAT(refused("library.so"), HasSubstr("is not a plugin, or a damaged one"));

  // Cut short anywhere it is refused, whether the metadata is still there or not.
  const std::string whole = test::read_text((fixture("throws") / "throws.so").string());
  for (const double part : {0.001, 0.01, 0.1, 0.3, 0.5, 0.7, 0.9}) {
    const auto size = static_cast<std::size_t>(part * static_cast<double>(whole.size()));
    const std::string name = "cut_" + std::to_string(size) + ".so";
    test::write_file((folder / name).string(), whole.substr(0, size));
    EXPECT_THAT(refused(name), testing::AnyOf(HasSubstr("is not a plugin, or a damaged one"),
                                              HasSubstr("cannot be loaded")));
  }
}

TEST(PluginHost, ReadsMetadataBeforeAnyCodeRuns) {
  // Its constructor throws: had its code run, the sentence would be another.
  const fs::path folder = test::scratch_folder();
  std::string bytes = test::read_text((fixture("throws_at_load") / "throws_at_load.so").string());
  const std::string hash(kInterfaceHash);
  std::size_t at = bytes.find(hash);
  ASSERT_NE(at, std::string::npos) << "the metadata is readable text in the file";
  for (; at != std::string::npos; at = bytes.find(hash, at)) bytes[at] = bytes[at] == '0' ? '1' : '0';
  test::write_file((folder / "p.so").string(), bytes);
  EXPECT_THAT(refusal_of(folder, "p.so"), HasSubstr("was built with other interface headers"));
}

TEST(PluginHost, LoadsNothingFromTheEnvironmentOrTheCurrentFolder) {
  const fs::path folder = test::scratch_folder();
  for (const auto* below : {"", "plugins", "engines"}) {
    fs::create_directories(folder / below);
    fs::copy_file(fixture("healthy") / "healthy.so", folder / below / "healthy.so");
  }
  const fs::path before = fs::current_path();
  fs::current_path(folder);
  ::setenv("QT_PLUGIN_PATH", folder.c_str(), 1);
  const fs::path program = folder / "bin";
  fs::create_directories(program);
  int argc = 1;
  char name[] = "leadline";
  char* argv[] = {name, nullptr};
  const QCoreApplication application(argc, argv);
  const auto host = load({}, program);
  ::unsetenv("QT_PLUGIN_PATH");
  fs::current_path(before);
  EXPECT_THAT(host.plugins(), IsEmpty());
  EXPECT_THAT(host.refusals(), IsEmpty());
  EXPECT_EQ(load({}, folder).plugins().size(), 1u) << "the program's own folder is looked at";
}

TEST(PluginHost, TellsFileAndHashOfWhatItLoaded) {
  const auto host = load({fixture("healthy")});
  ASSERT_EQ(host.plugins().size(), 1u);
  const LoadedPlugin& plugin = host.plugins()[0];
  EXPECT_EQ(plugin.name, "healthy");
  EXPECT_EQ(plugin.kind, PluginKind::engine);
  EXPECT_FALSE(plugin.house);
  EXPECT_EQ(plugin.file, fs::canonical(fixture("healthy") / "healthy.so").string());
  std::FILE* pipe = ::popen(("sha256sum " + plugin.file).c_str(), "r");
  char sum[65] = {};
  ASSERT_EQ(std::fread(sum, 1, 64, pipe), 64u);
  ::pclose(pipe);
  EXPECT_EQ(plugin.sha256, sum);
}

TEST(PluginHost, TakesFoldersInTheirOrderAndFilesByName) {
  const fs::path folder = test::scratch_folder();
  fs::copy_file(fixture("healthy") / "healthy.so", folder / "b.so");
  fs::copy_file(fixture("throws") / "throws.so", folder / "a.so");
  test::write_file((folder / "notes.txt").string(), "not looked at");
  const auto host = load({fixture("blocks"), folder, folder, folder / "." / "", "/no/such/folder"});
  EXPECT_THAT(names(host.engines()), ElementsAre("blocks", "throws", "healthy"));
  ASSERT_EQ(host.refusals().size(), 1u) << "a folder named twice is no duplicate";
  EXPECT_THAT(host.refusals()[0].line(),
              MatchesRegex("/no/such/folder: cannot be read .*; check --plugin-path"));
}

TEST(PluginHost, HostsTheNavigationCoreAsTheHousePlugin) {
  const auto host = load({fixture("healthy")}, program_folder());
  EXPECT_THAT(host.refusals(), IsEmpty());
  ASSERT_EQ(host.plugins().size(), 2u);
  EXPECT_EQ(host.plugins()[0].name, "navigation");
  EXPECT_TRUE(host.plugins()[0].house);
  EXPECT_TRUE(host.has_engine("fusion") && host.has_engine("dead-reckoning") && host.has_engine("healthy"));
  std::vector<std::string> paths;
  const EngineTables tables = host.engine_tables();
  for (const auto& table : tables.tables()) paths.push_back(table.path);
  EXPECT_THAT(paths, testing::IsSupersetOf({"fusion", "imu", "healthy"}));
  EXPECT_TRUE(host.make_engine("fusion", tables, {}, nullptr).ok());
  EXPECT_TRUE(host.make_ship_track(tables, {}, nullptr).ok());
}

TEST(PluginHost, TheHousePluginFromAnotherFolderIsAGuest) {
  const auto host = load({program_folder() / "plugins"});
  ASSERT_EQ(host.plugins().size(), 1u);
  EXPECT_FALSE(host.plugins()[0].house);
  EXPECT_TRUE(host.make_engine("fusion", host.engine_tables(), {}, nullptr).ok());
  EXPECT_FALSE(host.make_ship_track(host.engine_tables(), {}, nullptr).ok());
}

TEST(PluginHost, TablesBelongToOneConfiguration) {
  const auto host = load({}, program_folder());
  const EngineTables first = host.engine_tables(), second = host.engine_tables();
  const auto imu_bias = [](const EngineTables& tables) -> double& {
    for (const auto& table : tables.tables())
      if (table.path == "imu") return *std::get<double*>(table.keys.at(0).target);
    std::abort();
  };
  imu_bias(first) = 77.0;
  EXPECT_EQ(imu_bias(first), 77.0);
  EXPECT_NE(imu_bias(second), 77.0);
}

TEST(PluginHost, AnEngineThatIsNotThereOrWillNotBeMadeIsAnError) {
  const auto host = load({fixture("healthy"), fixture("throws_when_made")});
  const auto unknown = host.make_engine("fusio", host.engine_tables(), {}, nullptr);
  ASSERT_FALSE(unknown.ok());
  EXPECT_EQ(unknown.error().line(),
            "no engine is called \"fusio\"; the plugins have healthy, throws-when-made");
  const auto threw = host.make_engine("throws-when-made", host.engine_tables(), {}, nullptr);
  ASSERT_FALSE(threw.ok());
  EXPECT_THAT(threw.error().line(), HasSubstr("could not be made: it threw something"));
  EXPECT_FALSE(host.make_decoder("depth-line", {}, nullptr).ok());
  EXPECT_EQ(host.source_settings("depth-line"), nullptr);
}

}  // namespace
}  // namespace leadline
