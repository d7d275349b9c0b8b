#include <QObject>

#include "plugins/sdk/engine_plugin.h"

class NoMetadata final : public QObject {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID LEADLINE_ENGINE_PLUGIN)
};

#include "no_metadata.moc"
