#include <QObject>

class Foreign final : public QObject {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID "org.example.ImageFormat")
};

#include "foreign.moc"
