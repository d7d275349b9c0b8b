#include "ui/look/font_file.h"

#include <QtEndian>

#include "core/types/expect.h"

namespace leadline::ui {
namespace {

template <typename T>
T read(const QByteArray& file, int at) {
  LL_EXPECT(at >= 0 && at + static_cast<int>(sizeof(T)) <= file.size());
  return qFromBigEndian<T>(file.constData() + at);
}

int name_table(const QByteArray& file) {
  const int tables = read<quint16>(file, 4);
  for (int i = 0; i < tables; ++i) {
    const int record = 12 + 16 * i;
    if (file.mid(record, 4) == "name") return static_cast<int>(read<quint32>(file, record + 8));
  }
  LL_EXPECT(false && "a font has a name table");
  return 0;
}

}  // namespace

QByteArray renamed_font(QByteArray file, const QByteArray& family) {
  const int table = name_table(file);
  const int records = read<quint16>(file, table + 2), strings = table + read<quint16>(file, table + 4);
  constexpr int kFamily = 1, kTypographicFamily = 16, kMacintosh = 1;
  for (int i = 0; i < records; ++i) {
    const int record = table + 6 + 12 * i;
    const int id = read<quint16>(file, record + 6);
    if (id != kFamily && id != kTypographicFamily) continue;
    const bool one_byte = read<quint16>(file, record) == kMacintosh;
    QByteArray name;
    for (const char c : family) name += one_byte ? QByteArray(1, c) : QByteArray(1, '\0') + QByteArray(1, c);
    LL_EXPECT(name.size() <= read<quint16>(file, record + 8));
    const int at = strings + read<quint16>(file, record + 10);
    LL_EXPECT(at + name.size() <= file.size());
    file.replace(at, name.size(), name);
    qToBigEndian(static_cast<quint16>(name.size()), file.data() + record + 8);
  }
  return file;
}

}  // namespace leadline::ui
