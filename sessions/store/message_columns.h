#pragma once

// Inside this folder only: a message's columns by name, and its values out of a row.

#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "sessions/store/connection.h"
#include "sessions/store/message_fields.h"
#include "sessions/store/message_rows.h"

namespace leadline::sessions {

struct Names {
  template <class T>
  void operator()(const char* name, T&) {
    names.push_back(name);
  }
  std::vector<std::string> names;
};

template <class M>
const std::vector<std::string>& columns_of() {
  static const std::vector<std::string> columns = [] {
    Names all{{"id", "frame", "source", "valid_ns", "heard_after_ns"}};
    M message{};
    fields(all, message);
    return all.names;
  }();
  return columns;
}

inline std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

class ColumnReader {
 public:
  ColumnReader(SQLite::Statement& row, int first) : row_(row), index_(first) {}
  template <class T>
  void operator()(const char*, T& value) {
    const SQLite::Column column = row_.getColumn(index_++);
    take(column, value);
  }
  bool failed = false;

 private:
  static void take(const SQLite::Column& c, double& value) {
    value = c.isNull() ? std::nan("") : c.getDouble();
  }
  static void take(const SQLite::Column& c, Angle& value) {
    value = Angle::rad(c.isNull() ? std::nan("") : c.getDouble());
  }
  static void take(const SQLite::Column& c, Depth& value) { take(c, value.m); }
  static void take(const SQLite::Column& c, EllipsoidHeight& value) { take(c, value.m); }
  template <std::size_t N>
  static void take(const SQLite::Column& c, Text<N>& value) {
    value = Text<N>(text_of(c));
  }
  template <class T>
  void take(const SQLite::Column& c, std::optional<T>& value) {
    value.reset();
    if (!c.isNull()) take(c, value.emplace());
  }
  template <class T>
  std::enable_if_t<std::is_integral_v<T>> take(const SQLite::Column& c, T& value) {
    value = static_cast<T>(c.getInt64());
  }
  template <class T>
  std::enable_if_t<std::is_enum_v<T>> take(const SQLite::Column& c, T& value) {
    const auto& words = Words<T>::kWords;
    const auto* found = std::find(std::begin(words), std::end(words), std::string_view(text_of(c)));
    failed = failed || found == std::end(words);
    if (found != std::end(words)) value = static_cast<T>(found - std::begin(words));
  }

  SQLite::Statement& row_;
  int index_;
};

/// The first five columns, which every kind has: which message, of whom, when. false: of no source of this
/// run.
[[nodiscard]] inline bool read_head(SQLite::Statement& row, const std::map<std::int64_t, SourceId>& sources,
                                    Envelope& envelope) {
  envelope.seq = seq_of(row.getColumn(0).getInt64());
  const SQLite::Column frame = row.getColumn(1), source = row.getColumn(2);
  envelope.raw = frame.isNull() ? 0 : seq_of(frame.getInt64());
  envelope.source = kNoSource;
  envelope.valid.ns = row.getColumn(3).getInt64();
  envelope.arrival.ns = static_cast<std::int64_t>(static_cast<std::uint64_t>(envelope.valid.ns) +
                                                  static_cast<std::uint64_t>(row.getColumn(4).getInt64()));
  envelope.wall_utc = envelope.arrival.host();
  if (source.isNull()) return true;
  const auto place = sources.find(source.getInt64());
  if (place == sources.end()) return false;
  envelope.source = place->second;
  return true;
}

}  // namespace leadline::sessions
