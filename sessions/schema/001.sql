-- Schema 1 of a Leadline session: one SQLite file that holds everything that happened.
--
-- What other tools may rely on (product page): source, frame, fix, solution, mode, alarm, event, calibration,
-- waypoint, target, configuration, run. Everything else may change with the schema number (user_version).
--
-- One order of everything: a message's id is run << 36 | seq, seq being its number on the bus of that run (from 1).
-- Ids grow with arrival, so a moment is found by bisection over the primary key and no table needs an index on time.
-- Units are in the names; _ns times are nanoseconds since 1970 UTC; stored angles are radians, exactly as computed,
-- and the views give degrees. NULL: not known, or not a number. wall_ns is NULL where it equals the arrival.

PRAGMA application_id = 0x4C444C4E;
PRAGMA user_version = 1;

-- The file itself; one row.
CREATE TABLE session (
  id INTEGER PRIMARY KEY CHECK (id = 1),
  uid TEXT NOT NULL,                 -- random: which session this is, whatever the file is called
  created_ns INTEGER NOT NULL,
  build TEXT NOT NULL,
  predecessor TEXT,                  -- the session file this one continues
  syncs INTEGER NOT NULL DEFAULT 0   -- counts, so that this page with its uid is in every write-ahead log
) STRICT;

CREATE TABLE configuration (
  id INTEGER PRIMARY KEY,
  file TEXT NOT NULL,
  text TEXT NOT NULL
) STRICT;

-- One start of the program on this file: a recording, or a replay.
CREATE TABLE run (
  id INTEGER PRIMARY KEY,
  kind TEXT NOT NULL CHECK (kind IN ('record', 'replay')),
  started_ns INTEGER NOT NULL,       -- by the host's wall clock
  ended_ns INTEGER,
  ended TEXT NOT NULL DEFAULT 'open' CHECK (ended IN ('open', 'clean', 'died')),
  first_arrival_ns INTEGER,
  last_arrival_ns INTEGER,           -- kept about once a second while open
  stores_frames INTEGER NOT NULL,    -- 0: a replay of frames that this file holds already
  configuration INTEGER NOT NULL REFERENCES configuration (id),
  build TEXT NOT NULL,
  started_utc TEXT GENERATED ALWAYS AS (strftime('%Y-%m-%dT%H:%M:%fZ', started_ns / 1e9, 'unixepoch')) VIRTUAL,
  ended_utc TEXT GENERATED ALWAYS AS (strftime('%Y-%m-%dT%H:%M:%fZ', ended_ns / 1e9, 'unixepoch')) VIRTUAL
) STRICT;

-- The engines of a run in their order; 255 is the ship's own track.
CREATE TABLE engine (
  run INTEGER NOT NULL REFERENCES run (id),
  place INTEGER NOT NULL,
  name TEXT NOT NULL,
  PRIMARY KEY (run, place)
) STRICT, WITHOUT ROWID;

-- Every plugin file that was loaded.
CREATE TABLE plugin (
  id INTEGER PRIMARY KEY,
  run INTEGER NOT NULL REFERENCES run (id),
  name TEXT NOT NULL,
  path TEXT NOT NULL,
  sha256 TEXT NOT NULL
) STRICT;

-- The sources of a run, in the order of its configuration, with what decides what their facts mean.
CREATE TABLE source (
  id INTEGER PRIMARY KEY,
  run INTEGER NOT NULL REFERENCES run (id),
  place INTEGER NOT NULL,
  name TEXT NOT NULL,
  body TEXT NOT NULL,
  decoder TEXT NOT NULL,
  link TEXT NOT NULL,
  mount_roll_deg REAL, mount_pitch_deg REAL, mount_yaw_deg REAL,
  mount_x_m REAL, mount_y_m REAL, mount_z_m REAL,
  calibration_roll_deg REAL, calibration_pitch_deg REAL, calibration_yaw_deg REAL,
  scale REAL,
  declination_deg REAL,
  time_offset_ns INTEGER NOT NULL,
  gps_time INTEGER NOT NULL,
  latency_ns INTEGER NOT NULL,
  UNIQUE (run, place)
) STRICT;

-- Raw bytes as received; source is NULL where they belong to no configured source.
CREATE TABLE raw_frame (
  id INTEGER PRIMARY KEY,
  run INTEGER GENERATED ALWAYS AS (id >> 36) VIRTUAL REFERENCES run (id),
  source INTEGER REFERENCES source (id),
  arrival_ns INTEGER NOT NULL,
  wall_ns INTEGER,
  bytes BLOB NOT NULL,
  sender TEXT                        -- of a datagram: address and port; a replay tells senders apart as the run did
) STRICT;

-- Facts, refusals and what engines say: one table a kind of message, with the same first columns. frame is the
-- raw_frame it was made from (NULL in a run that stores no frames); heard_after_ns + valid_ns is the arrival.

CREATE TABLE rejected (
  id INTEGER PRIMARY KEY,
  run INTEGER GENERATED ALWAYS AS (id >> 36) VIRTUAL REFERENCES run (id),
  frame INTEGER,
  source INTEGER REFERENCES source (id),
  valid_ns INTEGER NOT NULL,
  heard_after_ns INTEGER NOT NULL,
  reason TEXT NOT NULL,
  offset_bytes INTEGER NOT NULL,
  length_bytes INTEGER NOT NULL
) STRICT;

CREATE TABLE health (
  id INTEGER PRIMARY KEY,
  run INTEGER GENERATED ALWAYS AS (id >> 36) VIRTUAL REFERENCES run (id),
  frame INTEGER,
  source INTEGER REFERENCES source (id),
  valid_ns INTEGER NOT NULL,
  heard_after_ns INTEGER NOT NULL,
  level TEXT NOT NULL,
  text TEXT NOT NULL
) STRICT;

CREATE TABLE clock_reading (
  id INTEGER PRIMARY KEY,
  run INTEGER GENERATED ALWAYS AS (id >> 36) VIRTUAL REFERENCES run (id),
  frame INTEGER,
  source INTEGER REFERENCES source (id),
  valid_ns INTEGER NOT NULL,
  heard_after_ns INTEGER NOT NULL,
  telegram TEXT NOT NULL,
  device_ns INTEGER NOT NULL,
  reference_ns INTEGER
) STRICT;

CREATE TABLE gnss_fix (
  id INTEGER PRIMARY KEY,
  run INTEGER GENERATED ALWAYS AS (id >> 36) VIRTUAL REFERENCES run (id),
  frame INTEGER,
  source INTEGER REFERENCES source (id),
  valid_ns INTEGER NOT NULL,
  heard_after_ns INTEGER NOT NULL,
  lat_rad REAL,
  lon_rad REAL,
  ellipsoid_height_m REAL,
  quality TEXT NOT NULL,
  satellites INTEGER,
  hdop REAL,
  sd_north_m REAL,
  sd_east_m REAL,
  sd_down_m REAL
) STRICT;

CREATE TABLE course (
  id INTEGER PRIMARY KEY,
  run INTEGER GENERATED ALWAYS AS (id >> 36) VIRTUAL REFERENCES run (id),
  frame INTEGER,
  source INTEGER REFERENCES source (id),
  valid_ns INTEGER NOT NULL,
  heard_after_ns INTEGER NOT NULL,
  speed_mps REAL,
  course_rad REAL,
  vel_down_mps REAL,
  sd_mps REAL
) STRICT;

CREATE TABLE heading (
  id INTEGER PRIMARY KEY,
  run INTEGER GENERATED ALWAYS AS (id >> 36) VIRTUAL REFERENCES run (id),
  frame INTEGER,
  source INTEGER REFERENCES source (id),
  valid_ns INTEGER NOT NULL,
  heard_after_ns INTEGER NOT NULL,
  heading_rad REAL,
  reference TEXT NOT NULL,
  variation_rad REAL,
  sd_rad REAL
) STRICT;

CREATE TABLE attitude (
  id INTEGER PRIMARY KEY,
  run INTEGER GENERATED ALWAYS AS (id >> 36) VIRTUAL REFERENCES run (id),
  frame INTEGER,
  source INTEGER REFERENCES source (id),
  valid_ns INTEGER NOT NULL,
  heard_after_ns INTEGER NOT NULL,
  roll_rad REAL,
  pitch_rad REAL,
  heave_up_m REAL,
  sd_roll_rad REAL,
  sd_pitch_rad REAL
) STRICT;

CREATE TABLE rates (
  id INTEGER PRIMARY KEY,
  run INTEGER GENERATED ALWAYS AS (id >> 36) VIRTUAL REFERENCES run (id),
  frame INTEGER,
  source INTEGER REFERENCES source (id),
  valid_ns INTEGER NOT NULL,
  heard_after_ns INTEGER NOT NULL,
  rate_z_rps REAL
) STRICT;

-- increments 0: rad/s and m/s2; 1: rad and m/s over the interval that ends at valid_ns.
CREATE TABLE imu_sample (
  id INTEGER PRIMARY KEY,
  run INTEGER GENERATED ALWAYS AS (id >> 36) VIRTUAL REFERENCES run (id),
  frame INTEGER,
  source INTEGER REFERENCES source (id),
  valid_ns INTEGER NOT NULL,
  heard_after_ns INTEGER NOT NULL,
  increments INTEGER NOT NULL,
  gyro_x REAL,
  gyro_y REAL,
  gyro_z REAL,
  accel_x REAL,
  accel_y REAL,
  accel_z REAL
) STRICT;

CREATE TABLE dvl_velocity (
  id INTEGER PRIMARY KEY,
  run INTEGER GENERATED ALWAYS AS (id >> 36) VIRTUAL REFERENCES run (id),
  frame INTEGER,
  source INTEGER REFERENCES source (id),
  valid_ns INTEGER NOT NULL,
  heard_after_ns INTEGER NOT NULL,
  reference TEXT NOT NULL,
  axes TEXT NOT NULL,
  tilt_applied INTEGER NOT NULL,
  x_mps REAL,
  y_mps REAL,
  z_mps REAL,
  valid INTEGER NOT NULL,
  sd_mps REAL,
  error_mps REAL,
  applied_heading_rad REAL,
  applied_roll_rad REAL,
  applied_pitch_rad REAL,
  applied_reference TEXT
) STRICT;

CREATE TABLE beam_ranges (
  id INTEGER PRIMARY KEY,
  run INTEGER GENERATED ALWAYS AS (id >> 36) VIRTUAL REFERENCES run (id),
  frame INTEGER,
  source INTEGER REFERENCES source (id),
  valid_ns INTEGER NOT NULL,
  heard_after_ns INTEGER NOT NULL,
  range_1_m REAL,
  range_2_m REAL,
  range_3_m REAL,
  range_4_m REAL,
  beam_angle_rad REAL
) STRICT;

CREATE TABLE altitude_above_bottom (
  id INTEGER PRIMARY KEY,
  run INTEGER GENERATED ALWAYS AS (id >> 36) VIRTUAL REFERENCES run (id),
  frame INTEGER,
  source INTEGER REFERENCES source (id),
  valid_ns INTEGER NOT NULL,
  heard_after_ns INTEGER NOT NULL,
  above_bottom_m REAL
) STRICT;

CREATE TABLE depth_measured (
  id INTEGER PRIMARY KEY,
  run INTEGER GENERATED ALWAYS AS (id >> 36) VIRTUAL REFERENCES run (id),
  frame INTEGER,
  source INTEGER REFERENCES source (id),
  valid_ns INTEGER NOT NULL,
  heard_after_ns INTEGER NOT NULL,
  depth_m REAL,
  sd_m REAL
) STRICT;

CREATE TABLE bottom_depth (
  id INTEGER PRIMARY KEY,
  run INTEGER GENERATED ALWAYS AS (id >> 36) VIRTUAL REFERENCES run (id),
  frame INTEGER,
  source INTEGER REFERENCES source (id),
  valid_ns INTEGER NOT NULL,
  heard_after_ns INTEGER NOT NULL,
  depth_m REAL,
  below TEXT NOT NULL
) STRICT;

CREATE TABLE pressure (
  id INTEGER PRIMARY KEY,
  run INTEGER GENERATED ALWAYS AS (id >> 36) VIRTUAL REFERENCES run (id),
  frame INTEGER,
  source INTEGER REFERENCES source (id),
  valid_ns INTEGER NOT NULL,
  heard_after_ns INTEGER NOT NULL,
  gauge_pa REAL
) STRICT;

CREATE TABLE sound_speed (
  id INTEGER PRIMARY KEY,
  run INTEGER GENERATED ALWAYS AS (id >> 36) VIRTUAL REFERENCES run (id),
  frame INTEGER,
  source INTEGER REFERENCES source (id),
  valid_ns INTEGER NOT NULL,
  heard_after_ns INTEGER NOT NULL,
  speed_mps REAL
) STRICT;

CREATE TABLE usbl_relative (
  id INTEGER PRIMARY KEY,
  run INTEGER GENERATED ALWAYS AS (id >> 36) VIRTUAL REFERENCES run (id),
  frame INTEGER,
  source INTEGER REFERENCES source (id),
  valid_ns INTEGER NOT NULL,
  heard_after_ns INTEGER NOT NULL,
  transponder TEXT NOT NULL,
  axes TEXT NOT NULL,
  x_m REAL,
  y_m REAL,
  down_m REAL,
  sd_m REAL
) STRICT;

CREATE TABLE usbl_geographic (
  id INTEGER PRIMARY KEY,
  run INTEGER GENERATED ALWAYS AS (id >> 36) VIRTUAL REFERENCES run (id),
  frame INTEGER,
  source INTEGER REFERENCES source (id),
  valid_ns INTEGER NOT NULL,
  heard_after_ns INTEGER NOT NULL,
  transponder TEXT NOT NULL,
  lat_rad REAL,
  lon_rad REAL,
  depth_m REAL,
  sd_m REAL
) STRICT;

CREATE TABLE usbl_grid (
  id INTEGER PRIMARY KEY,
  run INTEGER GENERATED ALWAYS AS (id >> 36) VIRTUAL REFERENCES run (id),
  frame INTEGER,
  source INTEGER REFERENCES source (id),
  valid_ns INTEGER NOT NULL,
  heard_after_ns INTEGER NOT NULL,
  transponder TEXT NOT NULL,
  easting_m REAL,
  northing_m REAL,
  depth_m REAL,
  sd_m REAL
) STRICT;

-- sd_north_m and sd_east_m are the roots of the variances: not every SQLite has sqrt().
CREATE TABLE engine_solution (
  id INTEGER PRIMARY KEY,
  run INTEGER GENERATED ALWAYS AS (id >> 36) VIRTUAL REFERENCES run (id),
  frame INTEGER,
  source INTEGER REFERENCES source (id),
  valid_ns INTEGER NOT NULL,
  heard_after_ns INTEGER NOT NULL,
  engine INTEGER NOT NULL,
  lat_rad REAL,
  lon_rad REAL,
  depth_m REAL,
  roll_rad REAL,
  pitch_rad REAL,
  heading_rad REAL,
  vel_north_mps REAL,
  vel_east_mps REAL,
  vel_down_mps REAL,
  var_north_m2 REAL,
  cov_north_east_m2 REAL,
  var_east_m2 REAL,
  sd_north_m REAL,
  sd_east_m REAL,
  sd_down_m REAL,
  sd_heading_rad REAL,
  heading_bias_rad REAL,
  mode TEXT,
  position_source TEXT
) STRICT;

CREATE TABLE fix_verdict (
  id INTEGER PRIMARY KEY,
  run INTEGER GENERATED ALWAYS AS (id >> 36) VIRTUAL REFERENCES run (id),
  frame INTEGER,
  source INTEGER REFERENCES source (id),
  valid_ns INTEGER NOT NULL,
  heard_after_ns INTEGER NOT NULL,
  engine INTEGER NOT NULL,
  lat_rad REAL,
  lon_rad REAL,
  depth_m REAL,
  residual_m REAL,
  dr_residual_m REAL,
  gate_m REAL,
  accepted INTEGER
) STRICT;

CREATE TABLE mode_change (
  id INTEGER PRIMARY KEY,
  run INTEGER GENERATED ALWAYS AS (id >> 36) VIRTUAL REFERENCES run (id),
  frame INTEGER,
  source INTEGER REFERENCES source (id),
  valid_ns INTEGER NOT NULL,
  heard_after_ns INTEGER NOT NULL,
  engine INTEGER NOT NULL,
  mode_before TEXT NOT NULL,
  mode TEXT NOT NULL,
  reason TEXT NOT NULL
) STRICT;

-- What the operator and the program did. at_ns is the host's wall clock.

CREATE TABLE event (
  id INTEGER PRIMARY KEY,
  run INTEGER NOT NULL REFERENCES run (id),
  at_ns INTEGER NOT NULL,
  arrival_ns INTEGER,                -- the latest arrival then
  severity TEXT NOT NULL CHECK (severity IN ('note', 'warning', 'alarm')),
  kind TEXT NOT NULL,                -- 'gap', 'note', ...
  text TEXT NOT NULL,
  unix_s REAL GENERATED ALWAYS AS (at_ns / 1e9) VIRTUAL,
  utc TEXT GENERATED ALWAYS AS (strftime('%Y-%m-%dT%H:%M:%fZ', at_ns / 1e9, 'unixepoch')) VIRTUAL
) STRICT;

CREATE TABLE alarm_raised (
  id INTEGER PRIMARY KEY,
  run INTEGER GENERATED ALWAYS AS (id >> 36) VIRTUAL REFERENCES run (id),
  frame INTEGER,
  source INTEGER REFERENCES source (id),
  valid_ns INTEGER NOT NULL,
  heard_after_ns INTEGER NOT NULL,
  priority TEXT NOT NULL,            -- as in IEC 62923-1: emergency, alarm, warning, caution
  reason TEXT NOT NULL,              -- 'exception', 'blocked', 'not finite', ...
  text TEXT NOT NULL
) STRICT;

-- Every calibration that was made, with its quality; at most one a source is in force.
CREATE TABLE calibration (
  id INTEGER PRIMARY KEY,
  run INTEGER REFERENCES run (id),
  at_ns INTEGER NOT NULL,
  source TEXT NOT NULL,
  method TEXT NOT NULL,
  yaw_deg REAL, roll_deg REAL, pitch_deg REAL,
  scale REAL,
  sd_yaw_deg REAL, sd_scale REAL,
  verdict TEXT CHECK (verdict IN ('green', 'orange', 'red')),
  before_rms_m REAL, after_rms_m REAL,
  report_json TEXT,                  -- as `calibrate --json` writes it
  in_force INTEGER NOT NULL DEFAULT 0 CHECK (in_force IN (0, 1)),
  unix_s REAL GENERATED ALWAYS AS (at_ns / 1e9) VIRTUAL,
  utc TEXT GENERATED ALWAYS AS (strftime('%Y-%m-%dT%H:%M:%fZ', at_ns / 1e9, 'unixepoch')) VIRTUAL
) STRICT;
CREATE UNIQUE INDEX calibration_in_force ON calibration (source) WHERE in_force = 1;

-- Waypoints and targets with their history: a change or removal is a new row; the latest of a number holds.
CREATE TABLE waypoint (
  id INTEGER PRIMARY KEY,
  run INTEGER REFERENCES run (id),
  at_ns INTEGER NOT NULL,
  plan TEXT NOT NULL,
  number INTEGER NOT NULL,
  change TEXT NOT NULL CHECK (change IN ('set', 'removed', 'reached', 'skipped')),
  name TEXT NOT NULL DEFAULT '',
  lat_deg REAL, lon_deg REAL,
  depth_m REAL,
  above_bottom_m REAL,
  speed_mps REAL,
  radius_m REAL,
  unix_s REAL GENERATED ALWAYS AS (at_ns / 1e9) VIRTUAL,
  utc TEXT GENERATED ALWAYS AS (strftime('%Y-%m-%dT%H:%M:%fZ', at_ns / 1e9, 'unixepoch')) VIRTUAL
) STRICT;

CREATE TABLE target (
  id INTEGER PRIMARY KEY,
  run INTEGER REFERENCES run (id),
  at_ns INTEGER NOT NULL,
  number INTEGER NOT NULL,
  change TEXT NOT NULL CHECK (change IN ('set', 'removed')),
  name TEXT NOT NULL DEFAULT '',
  kind TEXT NOT NULL DEFAULT '',
  lat_deg REAL, lon_deg REAL,
  depth_m REAL,
  sd_m REAL,
  note TEXT NOT NULL DEFAULT '',
  unix_s REAL GENERATED ALWAYS AS (at_ns / 1e9) VIRTUAL,
  utc TEXT GENERATED ALWAYS AS (strftime('%Y-%m-%dT%H:%M:%fZ', at_ns / 1e9, 'unixepoch')) VIRTUAL
) STRICT;

-- Map layers and mosaics that were shown or made.
CREATE TABLE map_layer (
  id INTEGER PRIMARY KEY,
  run INTEGER REFERENCES run (id),
  at_ns INTEGER NOT NULL,
  kind TEXT NOT NULL,
  name TEXT NOT NULL,
  path TEXT NOT NULL,
  sha256 TEXT,
  unix_s REAL GENERATED ALWAYS AS (at_ns / 1e9) VIRTUAL,
  utc TEXT GENERATED ALWAYS AS (strftime('%Y-%m-%dT%H:%M:%fZ', at_ns / 1e9, 'unixepoch')) VIRTUAL
) STRICT;

-- Views for other tools: names for numbers, degrees for radians.

CREATE VIEW frame AS
SELECT f.id, f.run, f.id & 0xFFFFFFFFF AS seq, f.arrival_ns / 1e9 AS unix_s,
  strftime('%Y-%m-%dT%H:%M:%fZ', f.arrival_ns / 1e9, 'unixepoch') AS utc,
  s.name AS source, f.arrival_ns, coalesce(f.wall_ns, f.arrival_ns) AS wall_ns, length(f.bytes) AS length_bytes, f.bytes
FROM raw_frame f LEFT JOIN source s ON s.id = f.source;

-- The columns of DIR/<engine>.csv behind run and engine.
CREATE VIEW solution AS
SELECT r.run, e.name AS engine, r.valid_ns / 1e9 AS unix_s,
  strftime('%Y-%m-%dT%H:%M:%fZ', r.valid_ns / 1e9, 'unixepoch') AS utc,
  r.lat_rad * 57.29577951308232 AS lat_deg, r.lon_rad * 57.29577951308232 AS lon_deg, r.depth_m,
  r.roll_rad * 57.29577951308232 AS roll_deg, r.pitch_rad * 57.29577951308232 AS pitch_deg,
  r.heading_rad * 57.29577951308232 + CASE WHEN r.heading_rad < 0 THEN 360 WHEN r.heading_rad >= 6.283185307179586 THEN -360 ELSE 0 END
    AS heading_deg,
  r.vel_north_mps, r.vel_east_mps, r.vel_down_mps, r.sd_north_m, r.sd_east_m, r.sd_down_m,
  r.sd_heading_rad * 57.29577951308232 AS sd_heading_deg, r.heading_bias_rad * 57.29577951308232 AS heading_bias_deg,
  r.mode, r.position_source
FROM engine_solution r LEFT JOIN engine e ON e.run = r.run AND e.place = r.engine;

-- The columns of DIR/fixes.csv behind run and engine, for every engine.
CREATE VIEW fix AS
SELECT v.run, e.name AS engine, v.valid_ns / 1e9 AS unix_s,
  strftime('%Y-%m-%dT%H:%M:%fZ', v.valid_ns / 1e9, 'unixepoch') AS utc,
  s.name AS source, s.body, v.lat_rad * 57.29577951308232 AS lat_deg, v.lon_rad * 57.29577951308232 AS lon_deg,
  v.depth_m, v.residual_m, v.gate_m, v.accepted, v.dr_residual_m
FROM fix_verdict v LEFT JOIN engine e ON e.run = v.run AND e.place = v.engine LEFT JOIN source s ON s.id = v.source;

CREATE VIEW alarm AS
SELECT a.run, a.valid_ns / 1e9 AS unix_s,
  strftime('%Y-%m-%dT%H:%M:%fZ', a.valid_ns / 1e9, 'unixepoch') AS utc,
  a.priority, 'raised' AS state, s.name AS source, a.reason, a.text
FROM alarm_raised a LEFT JOIN source s ON s.id = a.source;

CREATE VIEW mode AS
SELECT m.run, e.name AS engine, m.valid_ns / 1e9 AS unix_s,
  strftime('%Y-%m-%dT%H:%M:%fZ', m.valid_ns / 1e9, 'unixepoch') AS utc,
  m.mode, m.mode_before, m.reason
FROM mode_change m LEFT JOIN engine e ON e.run = m.run AND e.place = m.engine;
