#include "sessions/store/message_rows.h"

#include <string>
#include <utility>

#include "sessions/store/message_columns.h"

namespace leadline::sessions {
namespace {

class Binder {
 public:
  Binder(SQLite::Statement& statement, int first) : statement_(statement), index_(first) {}
  template <class T>
  void operator()(const char*, const T& value) {
    put(value);
    ++index_;
  }

 private:
  void put(double value) { statement_.bind(index_, value); }  // SQLite keeps a NaN as NULL
  void put(Angle value) { put(value.rad()); }
  void put(Depth value) { put(value.m); }
  void put(EllipsoidHeight value) { put(value.m); }
  template <std::size_t N>
  void put(const Text<N>& value) {
    text_.assign(value.view());
    statement_.bind(index_, text_);
  }
  template <class T>
  void put(const std::optional<T>& value) {
    if (value) put(*value);  // else NULL: the bindings were cleared
  }
  template <class T>
  std::enable_if_t<std::is_integral_v<T>> put(T value) {
    statement_.bind(index_, static_cast<std::int64_t>(value));
  }
  template <class T>
  std::enable_if_t<std::is_enum_v<T>> put(T value) {
    const std::string_view word = Words<T>::kWords[static_cast<std::size_t>(value)];
    if (!word.empty()) statement_.bindNoCopy(index_, word.data());  // a literal
  }

  SQLite::Statement& statement_;
  int index_;
  std::string text_;
};

constexpr std::size_t kRawFrame = 0;
static_assert(std::is_same_v<std::variant_alternative_t<kRawFrame, Message>, RawFrame>);

/// Reads one page of messages of kind M.
template <class M>
std::vector<Envelope> page_of(SQLite::Database& database, std::int64_t after, std::int64_t end, int most,
                              const std::map<std::int64_t, SourceId>& sources, bool& failed) {
  std::vector<Envelope> page;
  if constexpr (table_of<M> != nullptr) {
    SQLite::Statement query(database, "SELECT " + joined(columns_of<M>()) + " FROM " + table_of<M> +
                                          " WHERE id > ? AND id < ? ORDER BY id LIMIT ?");
    query.bind(1, after), query.bind(2, end), query.bind(3, most);
    while (query.executeStep()) {
      Envelope& envelope = page.emplace_back();
      failed = !read_head(query, sources, envelope) || failed;
      M message{};
      ColumnReader reader(query, 5);
      fields(reader, message);
      failed = failed || reader.failed;
      envelope.message = message;
    }
  }
  return page;
}

template <std::size_t... I>
std::vector<Envelope> page_by_kind(std::index_sequence<I...>, SQLite::Database& database, std::size_t kind,
                                   std::int64_t after, std::int64_t end, int most,
                                   const std::map<std::int64_t, SourceId>& sources, bool& failed) {
  std::vector<Envelope> page;
  ((I == kind ? void(page = page_of<std::variant_alternative_t<I, Message>>(database, after, end, most,
                                                                            sources, failed))
              : void()),
   ...);
  return page;
}

}  // namespace

SQLite::Statement& MessageWriter::statement(std::size_t kind, const std::string& table,
                                            const std::vector<std::string>& columns) {
  auto& prepared = statements_[kind];
  if (!prepared) {
    std::string marks = "?";
    for (std::size_t i = 1; i < columns.size(); ++i) marks += ", ?";
    prepared = std::make_unique<SQLite::Statement>(
        database_, "INSERT INTO " + table + " (" + joined(columns) + ") VALUES (" + marks + ")");
  }
  prepared->tryReset();
  prepared->clearBindings();
  return *prepared;
}

void MessageWriter::reset() {
  for (auto& prepared : statements_)
    if (prepared) prepared->tryReset();
}

void MessageWriter::bind_source(SQLite::Statement& statement, int index, SourceId place) const {
  if (place < sources_.size()) statement.bind(index, sources_[place]);
}

void MessageWriter::put(const Envelope& envelope) {
  if (const auto* raw = std::get_if<RawFrame>(&envelope.message)) {
    if (!stores_frames_) return;
    static const std::vector<std::string> kColumns = {"id",      "source", "arrival_ns",
                                                      "wall_ns", "bytes",  "sender"};
    SQLite::Statement& insert = statement(kRawFrame, "raw_frame", kColumns);
    insert.bind(1, id_of(run_, envelope.seq));
    bind_source(insert, 2, envelope.source);
    insert.bind(3, envelope.arrival.ns);
    if (envelope.wall_utc != envelope.arrival.host()) insert.bind(4, envelope.wall_utc.ns);
    // An empty frame has no address, and NULL bytes are no blob.
    insert.bindNoCopy(5, raw->bytes.empty() ? "" : static_cast<const void*>(raw->bytes.data()),
                      static_cast<int>(raw->bytes.size()));
    if (!raw->sender.empty()) insert.bind(6, std::string(raw->sender.view()));
    insert.exec();
    return;
  }
  std::visit(
      [&](const auto& message) {
        using M = std::decay_t<decltype(message)>;
        if constexpr (table_of<M> != nullptr) {
          SQLite::Statement& insert = statement(envelope.message.index(), table_of<M>, columns_of<M>());
          insert.bind(1, id_of(run_, envelope.seq));
          if (envelope.raw != 0 && stores_frames_) insert.bind(2, id_of(run_, envelope.raw));
          bind_source(insert, 3, envelope.source);
          insert.bind(4, envelope.valid.ns);
          insert.bind(5, static_cast<std::int64_t>(static_cast<std::uint64_t>(envelope.arrival.ns) -
                                                   static_cast<std::uint64_t>(envelope.valid.ns)));
          M shown = message;  // fields() shows members that a reader may set
          Binder binder(insert, 6);
          fields(binder, shown);
          insert.exec();
        }
      },
      envelope.message);
}

std::vector<Envelope> message_page(SQLite::Database& database, std::size_t kind, std::int64_t after,
                                   std::int64_t end, int most,
                                   const std::map<std::int64_t, SourceId>& sources, bool& failed) {
  return page_by_kind(std::make_index_sequence<std::variant_size_v<Message>>(), database, kind, after, end,
                      most, sources, failed);
}

}  // namespace leadline::sessions
