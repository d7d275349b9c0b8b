#include "sessions/store/run_rows.h"

#include <cmath>

#include "core/messages/navigation.h"
#include "sessions/store/connection.h"
#include "sessions/store/message_rows.h"

namespace leadline::sessions {
namespace {

constexpr const char* kSeverities[] = {"note", "warning", "alarm"};

std::int64_t configuration_row(SQLite::Database& database, const RunInfo& info) {
  SQLite::Statement find(database, "SELECT id FROM configuration WHERE text = ? AND file = ?");
  find.bind(1, info.configuration_text), find.bind(2, info.configuration_file);
  if (find.executeStep()) return find.getColumn(0).getInt64();
  SQLite::Statement add(database, "INSERT INTO configuration (file, text) VALUES (?, ?)");
  add.bind(1, info.configuration_file), add.bind(2, info.configuration_text);
  add.exec();
  return database.getLastInsertRowid();
}

std::int64_t add_source(SQLite::Database& database, RunId run, const RecordedSource& source) {
  const SourceInfo& s = source.info;
  SQLite::Statement add(database,
                        "INSERT INTO source (run, place, name, body, decoder, link, mount_roll_deg, "
                        "mount_pitch_deg, mount_yaw_deg, "
                        "mount_x_m, mount_y_m, mount_z_m, calibration_roll_deg, calibration_pitch_deg, "
                        "calibration_yaw_deg, scale, "
                        "declination_deg, time_offset_ns, gps_time, latency_ns) "
                        "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  add.bind(1, run), add.bind(2, static_cast<std::int64_t>(s.id)), add.bind(3, s.name);
  add.bind(4, name_of(s.body)), add.bind(5, source.decoder), add.bind(6, source.link);
  add.bind(7, s.mount.roll.deg()), add.bind(8, s.mount.pitch.deg()), add.bind(9, s.mount.heading.deg());
  add.bind(10, s.lever.x), add.bind(11, s.lever.y), add.bind(12, s.lever.z);
  add.bind(13, s.calibration.roll.deg()), add.bind(14, s.calibration.pitch.deg());
  add.bind(15, s.calibration.heading.deg()), add.bind(16, s.scale);
  if (s.declination) add.bind(17, s.declination->deg());
  add.bind(18, s.time_offset_ns), add.bind(19, s.gps_time ? 1 : 0), add.bind(20, s.latency_ns);
  add.exec();
  return database.getLastInsertRowid();
}

/// The arrival of a run's last frame that reached the disk.
std::optional<Arrival> last_frame(SQLite::Database& database, RunId run) {
  SQLite::Statement query(
      database, "SELECT arrival_ns FROM raw_frame WHERE id > ? AND id < ? ORDER BY id DESC LIMIT 1");
  query.bind(1, id_of(run, 0)), query.bind(2, id_of(run + 1, 0));
  if (query.executeStep()) return Arrival{query.getColumn(0).getInt64()};
  return std::nullopt;
}

/// What happened to the runs before this one: told once, by the run that comes next.
void mark_gaps(SQLite::Database& database, RunId run, const RunInfo& info) {
  const auto before = runs_in(database);
  for (const Run& earlier : before) {
    if (earlier.id == run || earlier.end != RunEnd::open) continue;
    const auto last = last_frame(database, earlier.id);
    SQLite::Statement mark(
        database,
        "UPDATE run SET ended = 'died', last_arrival_ns = coalesce(?, last_arrival_ns) WHERE id = ?");
    if (last) mark.bind(1, last->ns);
    mark.bind(2, earlier.id);
    mark.exec();
    const std::string when = last ? "last frame at " + iso8601(last->host()) : "no frame was kept";
    add_event(
        database, run,
        {info.started, last, Severity::warning, "gap", "gap: the program ended without closing; " + when});
  }
  if (info.kind != RunKind::record) return;
  for (auto earlier = before.rbegin(); earlier != before.rend(); ++earlier) {
    if (earlier->id == run || earlier->kind != RunKind::record) continue;
    if (earlier->end == RunEnd::clean)
      add_event(database, run,
                {info.started, earlier->last, Severity::note, "gap",
                 "gap: recording goes on" +
                     (earlier->last ? "; last heard at " + iso8601(earlier->last->host()) : std::string())});
    break;
  }
}

template <class T>
std::optional<T> optional_ns(const SQLite::Column& column) {
  return column.isNull() ? std::nullopt : std::optional(T{column.getInt64()});
}

double or_zero(const SQLite::Column& column) { return column.isNull() ? 0.0 : column.getDouble(); }

EulerAngles angles(SQLite::Statement& row, int roll) {
  return {Angle::deg(or_zero(row.getColumn(roll))), Angle::deg(or_zero(row.getColumn(roll + 1))),
          Angle::deg(or_zero(row.getColumn(roll + 2)))};
}

}  // namespace

std::pair<RunId, std::vector<std::int64_t>> add_run(SQLite::Database& database, const RunInfo& info) {
  SQLite::Statement add(
      database,
      "INSERT INTO run (kind, started_ns, stores_frames, configuration, build) VALUES (?, ?, ?, ?, ?)");
  add.bind(1, info.kind == RunKind::record ? "record" : "replay");
  add.bind(2, info.started.ns), add.bind(3, info.store_frames ? 1 : 0);
  add.bind(4, configuration_row(database, info)), add.bind(5, info.build);
  add.exec();
  const RunId run = database.getLastInsertRowid();
  const auto add_engine = [&](std::int64_t place, const std::string& name) {
    SQLite::Statement row(database, "INSERT INTO engine (run, place, name) VALUES (?, ?, ?)");
    row.bind(1, run), row.bind(2, place), row.bind(3, name);
    row.exec();
  };
  for (std::size_t i = 0; i < info.engines.size(); ++i)
    add_engine(static_cast<std::int64_t>(i), info.engines[i]);
  add_engine(kShipTrack, "ship");
  for (const auto& plugin : info.plugins) {
    SQLite::Statement row(database, "INSERT INTO plugin (run, name, path, sha256) VALUES (?, ?, ?, ?)");
    row.bind(1, run), row.bind(2, plugin.name), row.bind(3, plugin.path), row.bind(4, plugin.sha256);
    row.exec();
  }
  std::vector<std::int64_t> sources;
  for (const auto& source : info.sources) sources.push_back(add_source(database, run, source));
  mark_gaps(database, run, info);
  return {run, sources};
}

void add_event(SQLite::Database& database, RunId run, const Event& event) {
  SQLite::Statement add(
      database, "INSERT INTO event (run, at_ns, arrival_ns, severity, kind, text) VALUES (?, ?, ?, ?, ?, ?)");
  add.bind(1, run), add.bind(2, event.at.ns);
  if (event.arrival) add.bind(3, event.arrival->ns);
  add.bind(4, kSeverities[static_cast<std::size_t>(event.severity)]), add.bind(5, event.kind);
  add.bind(6, event.text);
  add.exec();
}

std::vector<Run> runs_in(SQLite::Database& database) {
  std::vector<Run> runs;
  SQLite::Statement query(database,
                          "SELECT id, kind, started_ns, ended_ns, ended, first_arrival_ns, last_arrival_ns, "
                          "stores_frames, configuration, build FROM run ORDER BY id");
  while (query.executeStep()) {
    Run& run = runs.emplace_back();
    run.id = query.getColumn(0).getInt64();
    run.kind = text_of(query.getColumn(1)) == "record" ? RunKind::record : RunKind::replay;
    run.started.ns = query.getColumn(2).getInt64();
    run.ended = optional_ns<Time>(query.getColumn(3));
    const std::string ended = text_of(query.getColumn(4));
    run.end = ended == "clean" ? RunEnd::clean : ended == "died" ? RunEnd::died : RunEnd::open;
    run.first = optional_ns<Arrival>(query.getColumn(5));
    run.last = optional_ns<Arrival>(query.getColumn(6));
    run.stores_frames = query.getColumn(7).getInt64() != 0;
    run.configuration = query.getColumn(8).getInt64();
    run.build = text_of(query.getColumn(9));
    SQLite::Statement engines(database, "SELECT name FROM engine WHERE run = ? AND place < ? ORDER BY place");
    engines.bind(1, run.id), engines.bind(2, static_cast<std::int64_t>(kShipTrack));
    while (engines.executeStep()) run.engines.push_back(text_of(engines.getColumn(0)));
  }
  return runs;
}

std::vector<RecordedSource> sources_in(SQLite::Database& database, RunId run) {
  std::vector<RecordedSource> sources;
  SQLite::Statement query(
      database,
      "SELECT place, name, body, decoder, link, mount_roll_deg, mount_pitch_deg, mount_yaw_deg, mount_x_m, "
      "mount_y_m, mount_z_m, calibration_roll_deg, calibration_pitch_deg, calibration_yaw_deg, scale, "
      "declination_deg, time_offset_ns, gps_time, latency_ns FROM source WHERE run = ? ORDER BY place");
  query.bind(1, run);
  while (query.executeStep()) {
    RecordedSource& source = sources.emplace_back();
    SourceInfo& s = source.info;
    s.id = static_cast<SourceId>(query.getColumn(0).getInt64());
    s.name = text_of(query.getColumn(1));
    const std::string body = text_of(query.getColumn(2));
    s.body = body == "ship" ? Body::ship : body == "target" ? Body::target : Body::vehicle;
    source.decoder = text_of(query.getColumn(3)), source.link = text_of(query.getColumn(4));
    s.mount = angles(query, 5);
    s.lever = {or_zero(query.getColumn(8)), or_zero(query.getColumn(9)), or_zero(query.getColumn(10))};
    s.calibration = angles(query, 11);
    if (!query.getColumn(14).isNull()) s.scale = query.getColumn(14).getDouble();
    if (!query.getColumn(15).isNull()) s.declination = Angle::deg(query.getColumn(15).getDouble());
    s.time_offset_ns = query.getColumn(16).getInt64();
    s.gps_time = query.getColumn(17).getInt64() != 0;
    s.latency_ns = query.getColumn(18).getInt64();
  }
  return sources;
}

std::map<std::int64_t, SourceId> places_in(SQLite::Database& database, RunId run) {
  std::map<std::int64_t, SourceId> places;
  SQLite::Statement query(database, "SELECT id, place FROM source WHERE run = ?");
  query.bind(1, run);
  while (query.executeStep())
    places[query.getColumn(0).getInt64()] = static_cast<SourceId>(query.getColumn(1).getInt64());
  return places;
}

std::vector<Event> events_in(SQLite::Database& database) {
  std::vector<Event> events;
  SQLite::Statement query(database, "SELECT at_ns, arrival_ns, severity, kind, text FROM event ORDER BY id");
  while (query.executeStep()) {
    Event& event = events.emplace_back();
    event.at.ns = query.getColumn(0).getInt64();
    event.arrival = optional_ns<Arrival>(query.getColumn(1));
    const std::string severity = text_of(query.getColumn(2));
    event.severity = severity == "alarm"     ? Severity::alarm
                     : severity == "warning" ? Severity::warning
                                             : Severity::note;
    event.kind = text_of(query.getColumn(3)), event.text = text_of(query.getColumn(4));
  }
  return events;
}

}  // namespace leadline::sessions
