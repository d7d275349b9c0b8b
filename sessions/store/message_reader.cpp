#include "sessions/store/message_reader.h"

#include <algorithm>
#include <string>
#include <utility>

#include "sessions/store/message_columns.h"
#include "sessions/store/run_rows.h"

namespace leadline::sessions {
namespace {

constexpr std::uint64_t kEndSeq = (std::uint64_t{1} << kSeqBits) - 1;
constexpr std::size_t kRawFrame = 0;
static_assert(std::is_same_v<std::variant_alternative_t<kRawFrame, Message>, RawFrame>);

constexpr const char* kHeadColumns = "id, frame, source, valid_ns, heard_after_ns";

/// What is to be known of a kind while the program runs.
struct Kind {
  const char* table = nullptr;  // null: not kept
  bool engine = false;          // has a column of that name
  const std::vector<std::string>& (*columns)() = nullptr;
  void (*read)(SQLite::Statement&, Message&, bool&) = nullptr;
  void (*empty)(Message&) = nullptr;
};

template <class M>
void read_message(SQLite::Statement& row, Message& message, bool& failed) {
  ColumnReader reader(row, 5);
  fields(reader, message.emplace<M>());
  failed = failed || reader.failed;
}

template <class M>
void make_empty(Message& message) {
  if (!std::holds_alternative<M>(message)) message.emplace<M>();
}

template <class M>
Kind kind_of() {
  Kind kind;
  kind.empty = &make_empty<M>;
  if constexpr (table_of<M> != nullptr) {
    kind.table = table_of<M>;
    kind.columns = &columns_of<M>;
    kind.read = &read_message<M>;
    kind.engine =
        std::is_same_v<M, Solution> || std::is_same_v<M, FixVerdict> || std::is_same_v<M, ModeChange>;
  }
  return kind;
}

template <std::size_t... I>
std::array<Kind, sizeof...(I)> all_kinds(std::index_sequence<I...>) {
  return {kind_of<std::variant_alternative_t<I, Message>>()...};
}

const Kind& kind_at(std::size_t index) {
  static const auto kinds = all_kinds(std::make_index_sequence<MessageReader::kKinds>());
  return kinds[index];
}

bool kept(std::size_t kind) { return kind == kRawFrame || kind_at(kind).table != nullptr; }

/// A statement holds the file until it is reset, whatever happens in between.
class Held {
 public:
  void add(SQLite::Statement& statement) { statements_[count_++] = &statement; }
  Held() = default;
  ~Held() {
    for (std::size_t i = 0; i < count_; ++i) statements_[i]->tryReset();
  }
  Held(const Held&) = delete;
  Held& operator=(const Held&) = delete;

 private:
  std::array<SQLite::Statement*, MessageReader::kKinds> statements_{};
  std::size_t count_ = 0;
};

}  // namespace

MessageReader::MessageReader(SQLite::Database& database, RunId run)
    : database_(database), run_(run), places_(places_in(database, run)) {}

std::int64_t MessageReader::id(std::uint64_t seq) const { return id_of(run_, std::min(seq, kEndSeq)); }

SQLite::Statement& MessageReader::statement(What what, std::size_t kind) {
  if (kind == kRawFrame && what == What::whole) what = What::head;
  auto& prepared = prepared_[static_cast<std::size_t>(what)][kind];
  if (prepared) {
    prepared->tryReset();
    return *prepared;
  }
  const std::string columns = kind == kRawFrame    ? "id, NULL, source, arrival_ns, 0"
                              : what == What::head ? kHeadColumns
                                                   : joined(kind_at(kind).columns());
  std::string text = "SELECT " + columns + " FROM " +
                     (kind == kRawFrame ? "raw_frame" : kind_at(kind).table) + " WHERE id >= ?1 AND id < ?2";
  if (what == What::last) {
    text += " AND (?4 IS NULL OR source = ?4)";
    if (kind_at(kind).engine) text += " AND (?5 IS NULL OR engine = ?5)";
    text += " ORDER BY id DESC LIMIT ?3";
  } else {
    text += " ORDER BY id";
  }
  prepared = std::make_unique<SQLite::Statement>(database_, text);
  return *prepared;
}

void MessageReader::take_row(What what, std::size_t kind, SQLite::Statement& row, Envelope& envelope) {
  if (!read_head(row, places_, envelope)) failed_ = true;
  if (kind == kRawFrame || what == What::head)
    kind_at(kind).empty(envelope.message);
  else
    kind_at(kind).read(row, envelope.message, failed_);
}

std::optional<std::uint64_t> MessageReader::read(const Reading& reading, int most,
                                                 const std::function<bool(const Envelope&)>& take) {
  struct Waiting {
    std::uint64_t seq;
    std::size_t kind;
    What what;
    SQLite::Statement* row;
  };
  std::array<Waiting, kKinds> waiting;
  std::size_t count = 0;
  Held held;
  if (reading.first_seq >= reading.end_seq) return std::nullopt;
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    const bool whole = reading.whole.test(kind);
    if (!kept(kind) || (!whole && !reading.heads.test(kind))) continue;
    const What what = whole ? What::whole : What::head;
    SQLite::Statement& row = statement(what, kind);
    held.add(row);
    row.bind(1, id(reading.first_seq)), row.bind(2, id(reading.end_seq));
    if (!row.executeStep()) continue;
    take_row(what, kind, row, next_[kind]);
    waiting[count++] = {next_[kind].seq, kind, what, &row};
  }
  for (int given = 0; count > 0 && !failed_; ++given) {
    const auto first = std::min_element(waiting.begin(), waiting.begin() + count,
                                        [](const Waiting& a, const Waiting& b) { return a.seq < b.seq; });
    if (given == most) return first->seq;
    if (!take(next_[first->kind])) return std::nullopt;
    if (first->row->executeStep()) {
      take_row(first->what, first->kind, *first->row, next_[first->kind]);
      first->seq = next_[first->kind].seq;
    } else {
      *first = waiting[--count];
    }
  }
  return std::nullopt;
}

void MessageReader::read_last(std::size_t kind, std::uint64_t floor, std::uint64_t end, std::size_t most,
                              const Speaker& speaker, std::vector<Envelope>& found) {
  if (!kept(kind) || floor >= end || found.size() >= most) return;
  SQLite::Statement& row = statement(What::last, kind);
  Held held;
  held.add(row);
  row.clearBindings();
  row.bind(1, id(floor)), row.bind(2, id(end)), row.bind(3, static_cast<int>(most - found.size()));
  if (speaker.source) {
    const auto place = std::find_if(places_.begin(), places_.end(),
                                    [&](const auto& p) { return p.second == *speaker.source; });
    if (place == places_.end()) return;
    row.bind(4, place->first);
  }
  if (speaker.engine && kind_at(kind).engine) row.bind(5, static_cast<int>(*speaker.engine));
  while (row.executeStep()) take_row(What::last, kind, row, found.emplace_back());
}

std::optional<MessageReader::Found> MessageReader::first_from(std::uint64_t from,
                                                              std::optional<std::size_t> kind) {
  Reading reading;
  reading.first_seq = from;
  reading.whole.reset();
  if (kind)
    reading.heads.set(*kind);
  else
    reading.heads.set();
  std::optional<Found> found;
  read(reading, 1, [&](const Envelope& envelope) {
    found = {envelope.seq, envelope.arrival};
    return false;
  });
  return found;
}

std::optional<std::uint64_t> MessageReader::newest_before(std::size_t kind, std::uint64_t end) {
  std::vector<Envelope> found;
  read_last(kind, 0, end, 1, {}, found);
  if (found.empty()) return std::nullopt;
  return found.front().seq;
}

}  // namespace leadline::sessions
