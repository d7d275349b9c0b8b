#include "plugins/host/plugin_file.h"

#include <fmt/format.h>

#include <QCryptographicHash>
#include <QFile>
#include <QJsonObject>
#include <QPluginLoader>
#include <algorithm>
#include <system_error>

#include "plugins/sdk/decoder_plugin.h"
#include "plugins/sdk/engine_plugin.h"
#include "plugins/sdk/interface_version.h"

namespace leadline {
namespace {

constexpr const char* kRebuild = "build it again with leadline_plugin() against this program's SDK";
constexpr const char* kTakeOut = "take it out of the folder, or copy it there again";

QString qt(const std::filesystem::path& file) { return QFile::decodeName(file.c_str()); }

/// Text of a foreign file, fit to be shown on one line.
std::string shown(const QString& text) {
  std::string plain = text.left(200).toStdString();
  std::replace_if(
      plain.begin(), plain.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; },
      ' ');
  return plain;
}

bool good_name(const QString& name) {
  return !name.isEmpty() && name.size() <= 64 && std::all_of(name.begin(), name.end(), [](QChar c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
  });
}

Result<std::string> sha256_of(const std::filesystem::path& file) {
  std::error_code failed;
  if (!std::filesystem::is_regular_file(file, failed))
    return Error{"is no file that can be read", file.string(), kTakeOut};
  QFile in(qt(file));
  QCryptographicHash hash(QCryptographicHash::Sha256);
  if (!in.open(QIODevice::ReadOnly) || !hash.addData(&in))
    return Error{"cannot be read: " + shown(in.errorString()), file.string(), "check its permissions"};
  return hash.result().toHex().toStdString();
}

}  // namespace

Result<PluginMetadata> read_metadata(const std::filesystem::path& file) {
  const auto refused = [&](std::string what, const char* remedy) {
    return Error{std::move(what), file.string(), remedy};
  };
  auto sha256 = sha256_of(file);
  if (!sha256) return sha256.error();

  const QPluginLoader loader(qt(file));
  const QJsonObject qt_metadata = loader.metaData();
  if (qt_metadata.isEmpty())
    return refused("is not a plugin, or a damaged one (" +
                       shown(loader.errorString().replace(qt(file), qt(file.filename()))) + ")",
                   kTakeOut);
  const QString iid = qt_metadata.value("IID").toString();
  if (iid != LEADLINE_ENGINE_PLUGIN && iid != LEADLINE_DECODER_PLUGIN)
    return refused(fmt::format("is a plugin of another program (\"{}\")", shown(iid)), kTakeOut);

  const QJsonObject metadata = qt_metadata.value("MetaData").toObject();
  const QString name = metadata.value("name").toString();
  const QString kind = metadata.value("kind").toString();
  const int number = metadata.value("interface").toInt(-1);
  const QString hash = metadata.value("interface_hash").toString();
  if (metadata.isEmpty())
    return refused("carries no metadata (name, kind, interface, interface_hash)", kRebuild);
  if (!good_name(name))
    return refused(
        fmt::format("its name \"{}\" is not made of small letters, digits and - (64 at most)", shown(name)),
        kRebuild);
  if (kind != "engine" && kind != "decoder")
    return refused(fmt::format("is of kind \"{}\"; there are engine and decoder", shown(kind)), kRebuild);
  if (number != kInterfaceNumber)
    return refused(
        fmt::format("was built for plugin interface {}, this program has {}", number, kInterfaceNumber),
        kRebuild);
  if (hash.toStdString() != kInterfaceHash)
    return refused(fmt::format("was built with other interface headers (hash {}, this program has {})",
                               shown(hash.left(12)), kInterfaceHash.substr(0, 12)),
                   kRebuild);
  return PluginMetadata{name.toStdString(), kind == "engine" ? PluginKind::engine : PluginKind::decoder,
                        std::move(sha256).value()};
}

Result<QObject*> load_root(const std::filesystem::path& file) {
  QPluginLoader loader(qt(file));
  loader.setLoadHints(QLibrary::ResolveAllSymbolsHint | QLibrary::PreventUnloadHint);
  try {
    if (QObject* root = loader.instance()) return root;
  } catch (...) {
    return Error{"threw an exception while it was loaded", file.string(), "ask its maker"};
  }
  // The loader names the file twice over; said once, the reason is not cut away behind a long path.
  return Error{"cannot be loaded: " + shown(loader.errorString().replace(qt(file), qt(file.filename()))),
               file.string(), kRebuild};
}

}  // namespace leadline
