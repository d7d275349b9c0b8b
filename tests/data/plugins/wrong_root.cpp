#include <QObject>

#include "plugins/sdk/engine_plugin.h"

class WrongRoot final : public QObject {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID LEADLINE_ENGINE_PLUGIN FILE "leadline_plugin.json")
};

#include "wrong_root.moc"
