#pragma once

#include <QByteArray>

namespace leadline::ui {

/// An OpenType file under another family name (name records 1 and 16), its glyphs untouched. family: ASCII,
/// not longer than the name it replaces. Aborts on a file without a name table.
[[nodiscard]] QByteArray renamed_font(QByteArray file, const QByteArray& family);

}  // namespace leadline::ui
