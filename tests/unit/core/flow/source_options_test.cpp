#include "core/flow/source_options.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace leadline {
namespace {

template <class Options>
void expect_documented(std::span<const Key<Options>> keys) {
  Options options;
  std::set<std::string_view> names;
  std::set<const void*> targets;
  for (const BoundKey& key : bind(keys, options)) {
    EXPECT_TRUE(names.insert(key.name).second) << key.name << " twice";
    const void* target = std::visit([](auto* p) -> const void* { return p; }, key.target);
    EXPECT_TRUE(targets.insert(target).second) << key.name << " sets what another key sets";
    EXPECT_FALSE(key.help.empty()) << key.name;
    if (const auto* number = std::get_if<double*>(&key.target)) {
      EXPECT_GE(**number, key.min) << key.name;
      EXPECT_LE(**number, key.max) << key.name;
    }
    const auto* text = std::get_if<std::string*>(&key.target);
    if (text && !key.choices.empty()) {
      EXPECT_NE(std::find(key.choices.begin(), key.choices.end(), **text), key.choices.end()) << key.name;
    }
  }
}

TEST(SourceKeys, AreDocumentedAndTheirDefaultsLegal) {
  expect_documented(source_keys());
  expect_documented(mount_keys());
  expect_documented(calibration_keys());
}

TEST(SourceKeys, SetTheMemberTheyAreNamedAfter) {
  MountOptions mount;
  for (const BoundKey& key : bind(mount_keys(), mount))
    if (key.name == "yaw_deg") *std::get<double*>(key.target) = 45.0;
  EXPECT_EQ(mount.yaw_deg, 45.0);
  EXPECT_EQ(mount.pitch_deg, 0.0);
}

}  // namespace
}  // namespace leadline
