#include "app/inputs.h"

#include <algorithm>

#include "core/decode/registry.h"
#include "core/links/file_reader.h"
#include "core/links/sniff.h"
#include "core/links/stamped_text_source.h"
#include "core/links/stream_source.h"
#include "core/links/stream_times.h"

namespace leadline::app {
namespace {

using links::FileKind;

InputError cannot(const std::string& path, std::string what, std::string remedy) {
  return {Exit::failed, {std::move(what), path, std::move(remedy)}};
}
InputError misuse(const std::string& path, std::string what, std::string remedy) {
  return {Exit::misused, {std::move(what), path, std::move(remedy)}};
}

std::string source_list(const Configuration& c) {
  std::string names;
  for (const auto& source : c.sources) names += (names.empty() ? "" : ", ") + source.options.name;
  return names;
}

/// `name=path` where name is a configured source; else the whole argument is a path.
struct Argument {
  std::string path;
  std::optional<SourceId> source;
};

std::optional<SourceId> source_named(const Configuration& c, std::string_view name) {
  for (std::size_t i = 0; i < c.sources.size(); ++i)
    if (c.sources[i].options.name == name) return static_cast<SourceId>(i);
  return std::nullopt;
}

/// What one instrument's stream may look like for its decoder; of a plugin's decoder nothing is known.
bool suits(const std::string& decoder, FileKind kind) {
  if (decoder == "trdi-pd0") return kind == FileKind::trdi_pd0;
  if (decoder == "nmea0183") return kind == FileKind::nmea || kind == FileKind::text;
  if (decoder == "iec61162-450") return kind == FileKind::iec61162_450 || kind == FileKind::nmea;
  if (decoder == "table") return kind == FileKind::table || kind == FileKind::text || kind == FileKind::nmea;
  return true;
}

/// One instrument's bytes: a stamped text, or its plain stream with the times found inside.
std::optional<InputError> open_instrument(links::FileReader file, FileKind kind, SourceId id,
                                          const Configuration& c, const PluginHost& plugins,
                                          OpenInput& input) {
  const SourceConfiguration& source = c.sources[id];
  if (kind == FileKind::stamped_text) {
    auto stamped = std::make_unique<links::StampedTextSource>(std::move(file), id);
    input.stamped = stamped.get();
    input.stamped_ids.push_back(id);
    input.source = std::move(stamped);
    return std::nullopt;
  }
  if (!suits(source.options.decoder, kind))
    return cannot(input.path, std::string("holds ") + name_of(kind) + ", not " + source.options.decoder,
                  "give the file of source " + source.options.name + ", or change its decoder");
  links::StreamTimeOptions options;
  options.date = source.options.date.empty() ? std::nullopt : parse_date(source.options.date);
  options.rate_hz = source.options.rate_hz;
  options.source = source.options.name;
  options.file = input.path;
  options.gps_time = source.options.time_scale == "gps";
  options.time_offset_ns = duration(source.options.time_offset_s).count();
  const auto maker = [&](std::optional<Time> date) {
    DecoderSettings settings = decoder_settings(source.options);
    if (date) settings.date = date;
    return decoder_of(source, plugins, settings).value();
  };
  auto stamps = links::stream_times(file, maker, options);
  if (!stamps) return InputError{file.failure() ? Exit::failed : Exit::misused, stamps.error()};
  file.rewind();
  input.source = std::make_unique<links::StreamSource>(std::move(file), id, std::move(stamps).value());
  return std::nullopt;
}

/// A session: every frame of its first kind of run, at the arrivals they were heard at.
std::optional<InputError> open_session(const Configuration& c, OpenInput& input) {
  auto session = sessions::Session::open(input.path, sessions::Access::read);
  if (!session) return InputError{Exit::failed, session.error()};
  std::vector<sessions::NamedSource> names;
  for (std::size_t i = 0; i < c.sources.size(); ++i) {
    names.push_back({c.sources[i].options.name, static_cast<SourceId>(i)});
    input.stamped_ids.push_back(static_cast<SourceId>(i));
  }
  auto source = sessions::SessionSource::open(std::move(session).value(), std::move(names));
  if (!source) return InputError{Exit::failed, source.error()};
  auto kept = std::make_unique<sessions::SessionSource>(std::move(source).value());
  input.session = kept.get();
  input.source = std::move(kept);
  return std::nullopt;
}

/// A network capture: packets are mapped to sources by the ports of their links.
std::optional<InputError> open_capture(const Configuration& c, OpenInput& input) {
  std::vector<links::CapturedSource> sources;
  for (std::size_t i = 0; i < c.sources.size(); ++i) {
    const auto link = links::parse_link(c.sources[i].options.link);
    if (!link || (link.value().kind != links::LinkKind::udp && link.value().kind != links::LinkKind::tcp &&
                  link.value().kind != links::LinkKind::tcp_listen))
      continue;
    sources.push_back({static_cast<SourceId>(i), link.value()});
    input.stamped_ids.push_back(static_cast<SourceId>(i));
  }
  if (sources.empty())
    return misuse(input.path, "is a network capture, and no source has a udp:// or tcp:// link",
                  "give each source of " + c.file + " the link it was heard on");
  auto source = links::CaptureSource::open(input.path, std::move(sources));
  if (!source) return InputError{Exit::failed, source.error()};
  auto kept = std::make_unique<links::CaptureSource>(std::move(source).value());
  input.capture = kept.get();
  input.source = std::move(kept);
  return std::nullopt;
}

std::optional<InputError> open_one(const Argument& argument, const Configuration& c,
                                   const PluginHost& plugins, OpenInput& input, bool& empty) {
  input.path = argument.path;
  auto opened = links::FileReader::open(argument.path);
  if (!opened) return InputError{Exit::failed, opened.error()};
  links::FileReader file = std::move(opened).value();
  const FileKind kind = links::sniff(file.peek(links::kSniffBytes), file.size());
  empty = kind == FileKind::empty;
  if (empty) return std::nullopt;
  if (kind == FileKind::session) return open_session(c, input);
  if (kind == FileKind::pcap || kind == FileKind::pcapng) return open_capture(c, input);
  if (kind == FileKind::tlog) {
    std::vector<links::SourceName> names;
    for (std::size_t i = 0; i < c.sources.size(); ++i) {
      names.push_back({c.sources[i].options.name, static_cast<SourceId>(i)});
      input.stamped_ids.push_back(static_cast<SourceId>(i));
    }
    auto tlog = std::make_unique<links::TlogSource>(std::move(file), std::move(names));
    input.tlog = tlog.get();
    input.stamped = tlog.get();
    input.source = std::move(tlog);
    return std::nullopt;
  }
  std::optional<SourceId> id = argument.source;
  if (!id && c.sources.size() == 1) id = SourceId{0};
  if (!id) {
    if (kind == FileKind::unknown || kind == FileKind::sqlite)
      return cannot(argument.path, std::string("is no log: ") + name_of(kind), "try `leadline info`");
    return misuse(argument.path, std::string("holds ") + name_of(kind) + " of one instrument; which?",
                  "write source=" + argument.path + " with one of " + source_list(c));
  }
  return open_instrument(std::move(file), kind, *id, c, plugins, input);
}

}  // namespace

Inputs open_inputs(const std::vector<std::string>& arguments, const Configuration& c,
                   const PluginHost& plugins) {
  Inputs inputs;
  for (const auto& text : arguments) {
    Argument argument{text, std::nullopt};
    if (const auto equals = text.find('='); equals != std::string::npos) {
      argument.source = source_named(c, std::string_view(text).substr(0, equals));
      if (argument.source) {
        argument.path = text.substr(equals + 1);
      } else if (text.find('/') > equals) {
        inputs.errors.push_back(misuse(text, "no [[source]] is called \"" + text.substr(0, equals) + "\"",
                                       c.file + " has " + source_list(c)));
        continue;
      }
    }
    OpenInput input;
    bool empty = false;
    if (auto error = open_one(argument, c, plugins, input, empty))
      inputs.errors.push_back(std::move(*error));
    else if (empty)
      inputs.empty.push_back(argument.path);
    else
      inputs.open.push_back(std::move(input));
  }
  return inputs;
}

std::optional<std::string> session_among(const std::vector<std::string>& arguments) {
  for (const auto& path : arguments) {
    auto file = links::FileReader::open(path);
    if (file && links::sniff(file.value().peek(links::kSniffBytes), file.value().size()) == FileKind::session)
      return path;
  }
  return std::nullopt;
}

}  // namespace leadline::app
