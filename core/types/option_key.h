#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace leadline {

/// One configuration key of a room: the room exports a plain Options struct and a table of these; `config`
/// walks the table, `app` hands it over, and nobody below `app` sees TOML. The default is the struct's own.
template <class Options>
struct Key {
  using Member =
      std::variant<double Options::*, std::optional<double> Options::*, bool Options::*,
                   std::int64_t Options::*, std::string Options::*, std::vector<std::string> Options::*>;
  std::string_view name;  ///< as in the file, unit suffix included
  Member member;
  std::string_view help;  ///< one line for the operator
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  std::vector<std::string_view> choices = {};  ///< the legal texts; empty: any
};

/// A key tied to the variable it sets; its present value is the default.
struct BoundKey {
  using Target = std::variant<double*, std::optional<double>*, bool*, std::int64_t*, std::string*,
                              std::vector<std::string>*>;
  std::string_view name;
  Target target;
  std::string_view help;
  double min, max;
  std::vector<std::string_view> choices;
};

template <class Options>
[[nodiscard]] std::vector<BoundKey> bind(std::span<const Key<Options>> keys, Options& options) {
  std::vector<BoundKey> bound;
  bound.reserve(keys.size());
  for (const auto& key : keys) {
    auto target = std::visit([&](auto member) -> BoundKey::Target { return &(options.*member); }, key.member);
    bound.push_back({key.name, target, key.help, key.min, key.max, key.choices});
  }
  return bound;
}

}  // namespace leadline
