#include "plugins/host/plugin_host.h"

#include <fmt/format.h>

#include <QObject>
#include <algorithm>

#include "core/types/expect.h"
#include "plugins/host/guarded_decoder.h"
#include "plugins/host/watched_engine.h"

namespace leadline {
namespace {

constexpr std::string_view kHousePlugin = "navigation";
constexpr const char* kAskItsMaker = "ask its maker";

/// Calls into a plugin on behalf of the host: what it throws becomes an Error.
template <class Call>
auto at_the_door(const std::string& where, Call call) -> Result<decltype(call())> {
  std::string what = "something that is no std::exception";
  try {
    return call();
  } catch (const std::exception& e) {
    what = e.what();
  } catch (...) {
  }
  return Error{"threw an exception: " + what, where, kAskItsMaker};
}

template <class Call>
auto made_at_the_door(const std::string& where, Call call) -> decltype(call()) {
  auto made = at_the_door(where, std::move(call));
  if (!made) return made.error();
  if (made.value() && !made.value().value()) return Error{"made nothing", where, kAskItsMaker};
  return std::move(made).value();
}

const PluginOffer* find(const std::vector<PluginOffer>& offers, std::string_view name) {
  const auto found =
      std::find_if(offers.begin(), offers.end(), [&](const auto& o) { return o.name == name; });
  return found == offers.end() ? nullptr : &*found;
}

Error unknown(const char* what, std::string_view name, const std::vector<PluginOffer>& offers) {
  std::string known;
  for (const auto& offer : offers) known += (known.empty() ? "" : ", ") + offer.name;
  return Error{fmt::format("no {} is called \"{}\"", what, name), "",
               known.empty() ? fmt::format("no plugin brings one; see `leadline list {}s`", what)
                             : fmt::format("the plugins have {}", known)};
}

bool good_name(const std::string& name) {
  return !name.empty() && name.size() <= 64 && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
  });
}

/// All that an engine's thread may look at, alive as long as it.
struct Kept {
  EnginePlugin* plugin;
  std::string name;
  std::shared_ptr<EngineSettings> settings;
  std::vector<SourceInfo> sources;
  std::shared_ptr<const geo::MagneticModel> magnetic;
  EngineSetup setup;
};

}  // namespace

std::vector<OptionTable> EngineTables::tables() const {
  std::vector<OptionTable> all;
  for (const auto& settings : settings_) {
    if (!settings) continue;
    auto own = at_the_door("", [&] { return settings->tables(); });
    if (!own) continue;  // it answered when it was loaded: an engine made from it will say what is wrong
    for (auto& table : own.value()) all.push_back(std::move(table));
  }
  return all;
}

PluginHost PluginHost::load(const PluginSearch& search) {
  PluginHost host;
  PluginCandidates candidates = find_plugins(search);
  host.refusals_ = std::move(candidates.refusals);
  for (const auto& candidate : candidates.files)
    if (const auto added = host.add(candidate, search.taken_decoders); !added)
      host.refusals_.push_back(added.error());
  return host;
}

Result<void> PluginHost::add(const PluginCandidate& candidate,
                             const std::vector<std::string>& taken_decoders) {
  const std::string file = candidate.file.string();
  const auto refused = [&](std::string what, const char* remedy) {
    return Error{std::move(what), file, remedy};
  };
  const auto metadata = read_metadata(candidate.file);
  if (!metadata) return metadata.error();
  const auto& [name, kind, sha256] = metadata.value();
  for (const auto& other : plugins_)
    if (other.name == name)
      return refused(fmt::format("is called \"{}\" like {}, which was found first", name, other.file),
                     "keep one of the two");

  const auto object = load_root(candidate.file);
  if (!object) return object.error();
  Root root;
  if (kind == PluginKind::engine)
    root.engine = qobject_cast<EnginePlugin*>(object.value());
  else
    root.decoder = qobject_cast<DecoderPlugin*>(object.value());
  if (!root.engine && !root.decoder)
    return refused(fmt::format("says it is of kind \"{}\", but its root object is not", name_of(kind)),
                   kAskItsMaker);

  auto listed =
      at_the_door(file, [&] { return root.engine ? root.engine->engines() : root.decoder->decoders(); });
  if (!listed) return listed.error();
  const std::vector<Offer>& offers = listed.value();
  if (offers.empty()) return refused(fmt::format("brings no {}", name_of(kind)), kAskItsMaker);
  auto& given = kind == PluginKind::engine ? engines_ : decoders_;
  if (const auto free = check_free(offers, given, file); !free) return free.error();
  for (const auto& offer : offers)
    if (root.decoder &&
        std::find(taken_decoders.begin(), taken_decoders.end(), offer.name) != taken_decoders.end())
      return refused(fmt::format("brings a decoder \"{}\", which the program has itself", offer.name),
                     kAskItsMaker);
  if (root.engine)
    if (const auto checked = check_tables(root, file); !checked) return checked.error();

  for (const auto& offer : offers) given.push_back({offer.name, offer.help, name});
  plugins_.push_back({name, kind, file, sha256, candidate.house && name == kHousePlugin});
  roots_.push_back(root);
  return {};
}

Result<void> PluginHost::check_free(const std::vector<Offer>& offers, const std::vector<PluginOffer>& given,
                                    const std::string& file) const {
  for (auto offer = offers.begin(); offer != offers.end(); ++offer) {
    if (!good_name(offer->name))
      return Error{"brings something whose name is not made of small letters, digits and -", file,
                   kAskItsMaker};
    if (const auto* other = find(given, offer->name))
      return Error{fmt::format("brings \"{}\", which {} does already", offer->name,
                               plugins_[index_of(other->plugin)].file),
                   file, "keep one of the two"};
    if (std::any_of(offers.begin(), offer, [&](const Offer& o) { return o.name == offer->name; }))
      return Error{fmt::format("brings \"{}\" twice", offer->name), file, kAskItsMaker};
  }
  return {};
}

Result<void> PluginHost::check_tables(const Root& root, const std::string& file) const {
  std::vector<std::string> taken{"aiding", "initial"};
  for (const auto& table : engine_tables().tables()) taken.push_back(table.path);
  auto own = at_the_door(file, [&]() -> std::vector<OptionTable> {
    const auto settings = root.engine->settings();
    return settings ? settings->tables() : std::vector<OptionTable>{{"", {}}};
  });
  if (!own) return own.error();
  for (const auto& table : own.value()) {
    if (!good_name(table.path))
      return Error{fmt::format("its table [navigation.{}] cannot be written", table.path.substr(0, 64)), file,
                   kAskItsMaker};
    if (std::find(taken.begin(), taken.end(), table.path) != taken.end())
      return Error{fmt::format("brings the table [navigation.{}], which is there already", table.path), file,
                   "keep one of the two"};
    taken.push_back(table.path);
  }
  return {};
}

std::size_t PluginHost::index_of(std::string_view plugin) const {
  const auto found =
      std::find_if(plugins_.begin(), plugins_.end(), [&](const auto& p) { return p.name == plugin; });
  LL_EXPECT(found != plugins_.end());
  return static_cast<std::size_t>(found - plugins_.begin());
}

bool PluginHost::has_engine(std::string_view name) const { return find(engines_, name) != nullptr; }
bool PluginHost::has_decoder(std::string_view name) const { return find(decoders_, name) != nullptr; }

EngineTables PluginHost::engine_tables() const {
  EngineTables tables;
  for (std::size_t i = 0; i < roots_.size(); ++i) {
    auto& settings = tables.settings_.emplace_back();
    if (!roots_[i].engine) continue;
    auto made = at_the_door(plugins_[i].file, [&] { return roots_[i].engine->settings(); });
    if (made) settings = std::move(made).value();
    if (!settings) settings = std::make_shared<EngineSettings>();
  }
  return tables;
}

Result<std::unique_ptr<Engine>> PluginHost::make_engine(std::string_view name, const EngineTables& tables,
                                                        const EngineSetup& setup,
                                                        std::shared_ptr<const geo::MagneticModel> magnetic,
                                                        std::chrono::milliseconds patience) const {
  const PluginOffer* offer = find(engines_, name);
  if (!offer) return unknown("engine", name, engines_);
  const std::size_t i = index_of(offer->plugin);
  LL_EXPECT(tables.settings_.size() == roots_.size());
  const auto kept = std::make_shared<Kept>(Kept{roots_[i].engine,
                                                offer->name,
                                                tables.settings_[i],
                                                {setup.sources.begin(), setup.sources.end()},
                                                std::move(magnetic),
                                                setup});
  kept->setup.magnetic = kept->magnetic.get();
  if (plugins_[i].house)
    return made_at_the_door(plugins_[i].file,
                            [&] { return kept->plugin->make(name, *kept->settings, kept->setup); });
  kept->setup.sources = kept->sources;
  return WatchedEngine::start(
      {.engine = offer->name, .plugin = offer->plugin, .id = setup.id, .patience = patience},
      [kept] { return kept->plugin->make(kept->name, *kept->settings, kept->setup); });
}

Result<std::unique_ptr<Engine>> PluginHost::make_ship_track(
    const EngineTables& tables, const EngineSetup& setup,
    std::shared_ptr<const geo::MagneticModel> magnetic) const {
  for (std::size_t i = 0; i < plugins_.size(); ++i) {
    if (!plugins_[i].house) continue;
    EngineSetup own = setup;
    own.id = kShipTrack;
    own.magnetic = magnetic.get();
    return made_at_the_door(plugins_[i].file, [&] {
      return Result(roots_[i].engine->make_ship_track(*tables.settings_[i], own));
    });
  }
  return Error{"the plugin \"navigation\" is missing", "plugins", "install the program again"};
}

Result<std::unique_ptr<Engine>> PluginHost::make_plausibility_watch(
    const EngineTables& tables, const EngineSetup& setup,
    std::shared_ptr<const geo::MagneticModel> magnetic) const {
  for (std::size_t i = 0; i < plugins_.size(); ++i) {
    if (!plugins_[i].house) continue;
    EngineSetup own = setup;
    own.magnetic = magnetic.get();
    return made_at_the_door(plugins_[i].file, [&] {
      return Result(roots_[i].engine->make_plausibility_watch(*tables.settings_[i], own));
    });
  }
  return Error{"the plugin \"navigation\" is missing", "plugins", "install the program again"};
}

std::shared_ptr<SourceSettings> PluginHost::source_settings(std::string_view decoder) const {
  const PluginOffer* offer = find(decoders_, decoder);
  if (!offer) return nullptr;
  const std::size_t i = index_of(offer->plugin);
  auto made = at_the_door(plugins_[i].file, [&] { return roots_[i].decoder->settings(decoder); });
  if (made && made.value()) return std::move(made).value();
  return std::make_shared<SourceSettings>();
}

Result<std::unique_ptr<Decoder>> PluginHost::make_decoder(
    std::string_view name, const DecoderSettings& common,
    std::shared_ptr<const SourceSettings> settings) const {
  const PluginOffer* offer = find(decoders_, name);
  if (!offer) return unknown("decoder", name, decoders_);
  LL_EXPECT(settings != nullptr);
  const std::size_t i = index_of(offer->plugin);
  auto maker = [plugin = roots_[i].decoder, called = offer->name, common, settings] {
    return plugin->make(called, common, *settings);
  };
  auto made = made_at_the_door(plugins_[i].file, maker);
  if (!made) return made.error();
  return std::unique_ptr<Decoder>(
      std::make_unique<GuardedDecoder>(std::move(made).value(), std::move(maker)));
}

}  // namespace leadline
