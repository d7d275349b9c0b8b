#include <QObject>

#include "plugins/sdk/engine_plugin.h"

void a_function_that_nobody_has();

class Unresolved final : public QObject {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID LEADLINE_ENGINE_PLUGIN FILE "leadline_plugin.json")
 public:
  Unresolved() { a_function_that_nobody_has(); }
};

#include "unresolved.moc"
