-- The database of a study: one SQLite file (version 3.37 or newer), made and written by `ocelli study`.
--
-- What holds everywhere:
--   simulated   0: a person. 1: a simulated subject; subject.kind says which. It stands in every row that tells of a
--               subject, and foreign keys make all rows of a subject agree.
--   *_ns        nanoseconds of a clock that never jumps, from 0 at the start of the run that the row belongs to.
--   *_utc       ISO 8601 with milliseconds, such as 2026-01-31T09:30:00.000Z, by the computer's clock: for people, as it
--               may jump.
--   *_number    counts from 1.   *_index    counts from 0, in the protocol's own lists.
--   *_json      text that is JSON.
--   0 and 1     stand for no and yes.
--   NULL        does not apply, or is not known (yet); never "no".
-- Rows that were recorded stay as they are: triggers refuse to change or delete them. Only the end of a run or trial is
-- filled in, once. Only a withdrawal deletes, and then all of a subject.
PRAGMA application_id = 1331914092;  -- "Ocel"
PRAGMA user_version = 4;

-- What is studied. One row.
CREATE TABLE study (
  study_id         INTEGER PRIMARY KEY CHECK (study_id = 1),
  protocol_name    TEXT NOT NULL,
  protocol_sha256  TEXT NOT NULL,  -- of protocol_text, hexadecimal
  protocol_text    TEXT NOT NULL,  -- the protocol file, byte by byte
  program_version  TEXT NOT NULL,  -- of the program that made this file
  created_utc      TEXT NOT NULL
) STRICT;

CREATE TABLE subject (
  subject_id   TEXT PRIMARY KEY,  -- a pseudonym: letters, digits, - and _
  subject_key  TEXT NOT NULL UNIQUE,  -- random; tells two subjects of the same name apart when files are merged
  slot         INTEGER NOT NULL CHECK (slot >= 0),  -- place in the counterbalancing, from 0
  kind         TEXT NOT NULL CHECK (kind IN ('person', 'simulated_generator', 'simulated_observer')),
  simulated    INTEGER NOT NULL CHECK (simulated = (kind <> 'person')),
  created_utc  TEXT NOT NULL,
  UNIQUE (subject_id, simulated)
) STRICT;

-- A session that a subject began, which may take several runs.
CREATE TABLE session (
  subject_id      TEXT NOT NULL,
  session_number  INTEGER NOT NULL CHECK (session_number >= 1),
  schedule_json   TEXT NOT NULL,  -- which trials come in which order
  seed            INTEGER NOT NULL,  -- of the schedule; 64 bits that SQLite shows with a sign
  planned_trials  INTEGER NOT NULL,  -- in the schedule, without practice
  started_utc     TEXT NOT NULL,
  simulated       INTEGER NOT NULL,
  PRIMARY KEY (subject_id, session_number),
  UNIQUE (subject_id, session_number, simulated),
  FOREIGN KEY (subject_id, simulated) REFERENCES subject (subject_id, simulated)
) STRICT;

-- One start of the program for a session: the first, or one that resumes it.
CREATE TABLE run (
  run_id             INTEGER PRIMARY KEY,
  run_key            TEXT NOT NULL UNIQUE,  -- random; the same wherever the run is merged to
  subject_id         TEXT NOT NULL,
  session_number     INTEGER NOT NULL,
  run_number         INTEGER NOT NULL CHECK (run_number >= 1),  -- of the session
  started_utc        TEXT NOT NULL,
  ended_utc          TEXT,  -- NULL: it still runs, or the program was killed
  ending             TEXT CHECK (ending IN ('completed', 'unwell', 'aborted', 'declined', 'failed')),
  program_version    TEXT NOT NULL,
  station            TEXT NOT NULL,  -- name of the computer
  environment_json   TEXT NOT NULL,  -- system, graphics, screen, clocks, how input is time-stamped, what is not measured
  timing_check_json  TEXT NOT NULL,  -- what the start-up check measured, and its verdict
  forced             INTEGER NOT NULL CHECK (forced IN (0, 1)),  -- started although that check refused
  simulation_json    TEXT,  -- parameters of a simulated subject
  simulated          INTEGER NOT NULL,
  CHECK ((ended_utc IS NULL) = (ending IS NULL)),
  UNIQUE (run_id, subject_id, session_number, simulated),
  FOREIGN KEY (subject_id, session_number, simulated) REFERENCES session (subject_id, session_number, simulated)
) STRICT;
CREATE INDEX run_of_session ON run (subject_id, session_number);

CREATE TABLE consent (
  consent_id      INTEGER PRIMARY KEY,
  run_id          INTEGER NOT NULL,
  subject_id      TEXT NOT NULL,
  session_number  INTEGER NOT NULL,
  title           TEXT NOT NULL,
  text            TEXT NOT NULL,  -- as it was shown
  text_sha256     TEXT NOT NULL,
  agreed          INTEGER NOT NULL CHECK (agreed IN (0, 1)),
  answered_utc    TEXT NOT NULL,
  simulated       INTEGER NOT NULL,
  FOREIGN KEY (run_id, subject_id, session_number, simulated)
    REFERENCES run (run_id, subject_id, session_number, simulated)
) STRICT;
CREATE INDEX consent_of_run ON consent (run_id);

-- Answers to the questions of forms: demographics, survey, questionnaires. A row of a matrix is a question.
CREATE TABLE answer (
  answer_id       INTEGER PRIMARY KEY,
  run_id          INTEGER NOT NULL,
  subject_id      TEXT NOT NULL,
  session_number  INTEGER NOT NULL,
  form            TEXT NOT NULL,  -- name of the form in the protocol
  field           TEXT NOT NULL,  -- name of the question
  answer          TEXT NOT NULL,  -- the option that was chosen, or its value; a number; a text; a JSON array of options;
                                  -- '' where the question was left open
  answered_utc    TEXT NOT NULL,
  simulated       INTEGER NOT NULL,
  FOREIGN KEY (run_id, subject_id, session_number, simulated)
    REFERENCES run (run_id, subject_id, session_number, simulated)
) STRICT;
CREATE INDEX answer_of_run ON answer (run_id);

-- An attempt at a trial. A row appears when the trial begins; the columns from "ending" on are filled in when it ends.
CREATE TABLE trial (
  trial_id             INTEGER PRIMARY KEY,  -- later attempts have larger ones
  run_id               INTEGER NOT NULL,
  subject_id           TEXT NOT NULL,
  session_number       INTEGER NOT NULL,
  trial_number         INTEGER NOT NULL,  -- among those that the run began, practice included
  -- The plan.
  practice             INTEGER NOT NULL CHECK (practice IN (0, 1)),
  plan_index           INTEGER CHECK ((plan_index IS NULL) = (practice = 1)),  -- in the schedule of the session
  attempt              INTEGER NOT NULL CHECK (attempt >= 1),  -- at the same plan
  block_index          INTEGER NOT NULL,  -- in the protocol
  block                TEXT NOT NULL,  -- name of the block
  task                 TEXT NOT NULL,  -- 'find', 'count', 'path', ...
  case_index           INTEGER NOT NULL,  -- in the block's cases, or its practice cases
  view                 TEXT NOT NULL CHECK (view <> ''),  -- name of the view condition in the protocol; without names there:
                                                        -- 'ppc', planar pinhole camera(s), or 'gc', graph camera
  trial_seed           INTEGER NOT NULL,  -- of what is random in it; 64 bits that SQLite shows with a sign
  -- How it ended. 'completed': it counts, unless a later attempt was completed too. 'redone', 'aborted': by the
  -- experimenter, or as the subject was unwell. NULL: it still runs, or the program was killed.
  ending               TEXT CHECK (ending IN ('completed', 'redone', 'aborted')),
  started_ns           INTEGER,
  ended_ns             INTEGER,
  started_utc          TEXT,
  ended_utc            TEXT,
  -- The case.
  case_label           TEXT,
  moving               INTEGER CHECK (moving IN (0, 1)),  -- whether the objects move
  exposure_s           REAL,  -- planned seconds for which the scene is shown; NULL where the subject ends it
  objects              INTEGER,  -- how many there are, where that is the question
  duplicate_colors     INTEGER CHECK (duplicate_colors IN (0, 1)),  -- whether some objects share a colour
  longest_s            REAL,  -- seconds until the trial ends by itself, answering included
  typical_s            REAL,  -- seconds that the schedule reckons with
  -- What the subject did. Of trials that were completed.
  answer               TEXT,  -- '' where there was none
  expected             TEXT,  -- what would have been right
  correct              INTEGER CHECK (correct IN (0, 1)),
  censored             INTEGER CHECK (censored IN (0, 1)),  -- time ran out: the response would have come after response_s
  response_s           REAL,  -- seconds to the answer, or to the end of the time, in steps of 1/240 s; with an exposure:
                              -- from its end
  response_ticks       INTEGER,  -- the same in these steps
  exposure_frames      INTEGER,  -- frames that showed the scene, of tasks with an exposure
  measures_json        TEXT,  -- an object of numbers: what else the task tells, units in the names
  -- The timing of its frames.
  frames               INTEGER,
  dropped_frames       INTEGER,  -- intervals longer than the protocol's late_factor times that of the screen
  median_interval_ns   INTEGER,
  longest_interval_ns  INTEGER,
  timing_verdict       TEXT,  -- 'good', 'dropped_frames', 'early_frames': they did not wait for the screen,
                              -- 'unstable_refresh', 'simulated_clock'
  screen_width_px      INTEGER,
  screen_height_px     INTEGER,
  refresh_hz           REAL,
  simulated            INTEGER NOT NULL,
  exposure_rule        TEXT CHECK (exposure_rule IN ('clock', 'frames')),  -- what ended the exposure; NULL where there is
                                                                           -- none, and in rows of versions 1 and 2:
                                                                           -- frames were counted
  exposure_shown_s     REAL,  -- from the first frame with the scene to the first without it, in steps of 1/240 s
  UNIQUE (run_id, trial_number),
  UNIQUE (trial_id, simulated),
  FOREIGN KEY (run_id, subject_id, session_number, simulated)
    REFERENCES run (run_id, subject_id, session_number, simulated)
) STRICT;
CREATE INDEX trial_of_plan ON trial (subject_id, session_number, plan_index);

-- What was on the screen, frame by frame.
CREATE TABLE frame (
  trial_id    INTEGER NOT NULL,
  frame       INTEGER NOT NULL,  -- of the trial, from 0
  tick        INTEGER NOT NULL,  -- of the trial, that the picture shows: steps of 1/240 s
  shown_ns    INTEGER NOT NULL,  -- when it was on the screen; the run's environment_json says how that is known
  x_m         REAL NOT NULL,  -- where the subject stands in the maze: metres to the east
  z_m         REAL NOT NULL,  -- metres to the south
  heading_rad REAL NOT NULL,  -- clockwise from north, seen from above
  pixel_hash  INTEGER,  -- of the trial's picture, where it was read; 64 bits that SQLite shows with a sign
  simulated   INTEGER NOT NULL,
  PRIMARY KEY (trial_id, frame),
  FOREIGN KEY (trial_id, simulated) REFERENCES trial (trial_id, simulated)
) STRICT, WITHOUT ROWID;

-- What the subject did to keyboard and mouse during trials.
CREATE TABLE input (
  trial_id     INTEGER NOT NULL,
  input_index  INTEGER NOT NULL,  -- of the trial, in the order in which they came
  tick         INTEGER NOT NULL,  -- of the trial, at which it took it: steps of 1/240 s
  came_ns      INTEGER NOT NULL,
  kind         TEXT NOT NULL CHECK (kind IN
    ('key', 'text', 'pointer_move', 'pointer_button', 'scroll', 'resize', 'drop', 'close')),
  what         TEXT,  -- the key by its place on a US keyboard, or 'left', 'right', 'middle' button
  pressed      INTEGER CHECK (pressed IN (0, 1)),  -- of keys and buttons; repeats of a held key are presses
  modifiers    INTEGER,  -- of keys and buttons: 1 shift + 2 control + 4 alt
  x            REAL,  -- pointer_move: screen coordinates from the left; scroll: steps to the right
  y            REAL,  -- pointer_move: screen coordinates from the top; scroll: steps up
  more_json    TEXT,  -- of the other kinds
  simulated    INTEGER NOT NULL,
  PRIMARY KEY (trial_id, input_index),
  FOREIGN KEY (trial_id, simulated) REFERENCES trial (trial_id, simulated)
) STRICT, WITHOUT ROWID;

-- Where the subject looked during trials, as an eye tracker says (docs/gaze.md).
CREATE TABLE gaze (
  trial_id     INTEGER NOT NULL,
  gaze_index   INTEGER NOT NULL,  -- of the trial, in the order in which samples came
  came_ns      INTEGER NOT NULL,  -- when the sample came
  device_time  REAL NOT NULL,  -- by the tracker's clock, in its unit
  valid        INTEGER NOT NULL CHECK (valid IN (0, 1)),  -- whether the tracker saw where the subject looks
  x_px         REAL,  -- pixels from the left edge of the screen; NULL where valid is 0
  y_px         REAL,  -- pixels from its upper edge
  pupil        REAL,  -- in the tracker's unit
  simulated    INTEGER NOT NULL,
  CHECK ((x_px IS NOT NULL) = valid AND (y_px IS NOT NULL) = valid),
  PRIMARY KEY (trial_id, gaze_index),
  FOREIGN KEY (trial_id, simulated) REFERENCES trial (trial_id, simulated)
) STRICT, WITHOUT ROWID;

-- Anything else that happened: 'pause', 'resume', 'note', 'redo', 'abort', 'break', 'page', 'clock_jump', ...
CREATE TABLE event (
  event_id        INTEGER PRIMARY KEY,
  run_id          INTEGER NOT NULL,
  subject_id      TEXT NOT NULL,
  session_number  INTEGER NOT NULL,
  at_ns           INTEGER NOT NULL,
  at_utc          TEXT NOT NULL,
  what            TEXT NOT NULL,
  detail          TEXT NOT NULL,
  simulated       INTEGER NOT NULL,
  FOREIGN KEY (run_id, subject_id, session_number, simulated)
    REFERENCES run (run_id, subject_id, session_number, simulated)
) STRICT;
CREATE INDEX event_of_run ON event (run_id);

-- What was done to this file. It names no subject, so that it can outlive a withdrawal. Of who withdrew it keeps
-- sha256(salt || subject_key), which names nobody, as the key was random: merging leaves them out.
CREATE TABLE audit (
  audit_id         INTEGER PRIMARY KEY,
  at_utc           TEXT NOT NULL,
  action           TEXT NOT NULL,  -- 'created', 'migrated', 'withdrawn', 'merged', 'exported'
  detail_json      TEXT NOT NULL,
  program_version  TEXT NOT NULL,
  station          TEXT NOT NULL
) STRICT;

-- A withdrawal that is under way. One row.
CREATE TABLE withdrawal (
  withdrawal_id      INTEGER PRIMARY KEY CHECK (withdrawal_id = 1),
  subject_id         TEXT,  -- whose rows may be deleted now
  leftovers_pending  INTEGER NOT NULL CHECK (leftovers_pending IN (0, 1))  -- deleted, but not yet wiped from the file
) STRICT;
INSERT INTO withdrawal VALUES (1, NULL, 0);

-- The trials that count: the last completed attempt of each plan, without practice.
CREATE VIEW final_trial AS
SELECT trial.*, subject.kind AS subject_kind, subject.slot, run.station, run.forced
FROM trial JOIN subject USING (subject_id) JOIN run USING (run_id)
WHERE trial.practice = 0 AND trial.ending = 'completed' AND NOT EXISTS (
  SELECT 1 FROM trial AS later
  WHERE later.subject_id = trial.subject_id AND later.session_number = trial.session_number
    AND later.plan_index = trial.plan_index AND later.ending = 'completed' AND later.trial_id > trial.trial_id);

-- The answers that count: the last to each question in each session.
CREATE VIEW final_answer AS
SELECT answer.*, subject.kind AS subject_kind, subject.slot
FROM answer JOIN subject USING (subject_id)
WHERE NOT EXISTS (
  SELECT 1 FROM answer AS later
  WHERE later.subject_id = answer.subject_id AND later.session_number = answer.session_number
    AND later.form = answer.form AND later.field = answer.field AND later.answer_id > answer.answer_id);

-- How each session stands: the ending of its last run (NULL: it runs, or was killed), and the plans that are completed.
CREATE VIEW session_state AS
SELECT session.subject_id, session.session_number, session.simulated, session.started_utc, session.planned_trials,
  (SELECT count(DISTINCT plan_index) FROM trial WHERE trial.subject_id = session.subject_id
    AND trial.session_number = session.session_number AND trial.ending = 'completed') AS completed_trials,
  (SELECT count(*) FROM run WHERE run.subject_id = session.subject_id
    AND run.session_number = session.session_number) AS runs,
  (SELECT ending FROM run WHERE run.subject_id = session.subject_id AND run.session_number = session.session_number
    ORDER BY run_number DESC LIMIT 1) AS ending,
  (SELECT ended_utc FROM run WHERE run.subject_id = session.subject_id AND run.session_number = session.session_number
    ORDER BY run_number DESC LIMIT 1) AS ended_utc
FROM session;

-- Recorded rows are not changed.
CREATE TRIGGER study_update BEFORE UPDATE ON study
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be changed: study'); END;
CREATE TRIGGER subject_update BEFORE UPDATE ON subject
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be changed: subject'); END;
CREATE TRIGGER session_update BEFORE UPDATE ON session
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be changed: session'); END;
CREATE TRIGGER run_update BEFORE UPDATE ON run
WHEN OLD.ending IS NOT NULL
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be changed: run'); END;
CREATE TRIGGER run_update_start BEFORE UPDATE OF run_id, run_key, subject_id, session_number, run_number, started_utc,
  program_version, station, environment_json, timing_check_json, forced, simulation_json, simulated ON run
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be changed: run'); END;
CREATE TRIGGER consent_update BEFORE UPDATE ON consent
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be changed: consent'); END;
CREATE TRIGGER answer_update BEFORE UPDATE ON answer
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be changed: answer'); END;
CREATE TRIGGER trial_update BEFORE UPDATE ON trial
WHEN OLD.ending IS NOT NULL
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be changed: trial'); END;
CREATE TRIGGER trial_update_plan BEFORE UPDATE OF trial_id, run_id, subject_id, session_number, trial_number, practice,
  plan_index, attempt, block_index, block, task, case_index, view, trial_seed, simulated ON trial
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be changed: trial'); END;
CREATE TRIGGER frame_update BEFORE UPDATE ON frame
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be changed: frame'); END;
CREATE TRIGGER input_update BEFORE UPDATE ON input
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be changed: input'); END;
CREATE TRIGGER gaze_update BEFORE UPDATE ON gaze
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be changed: gaze'); END;
CREATE TRIGGER event_update BEFORE UPDATE ON event
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be changed: event'); END;
CREATE TRIGGER audit_update BEFORE UPDATE ON audit
WHEN (SELECT subject_id FROM withdrawal) IS NULL  -- names of files may hold the id of who withdraws
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be changed: audit'); END;

-- Rows are deleted by a withdrawal alone: of that subject, and rows before those that they belong to.
CREATE TRIGGER study_delete BEFORE DELETE ON study
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be deleted: study'); END;
CREATE TRIGGER audit_delete BEFORE DELETE ON audit
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be deleted: audit'); END;
CREATE TRIGGER withdrawal_delete BEFORE DELETE ON withdrawal
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be deleted: withdrawal'); END;
CREATE TRIGGER subject_delete BEFORE DELETE ON subject
WHEN OLD.subject_id IS NOT (SELECT subject_id FROM withdrawal)
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be deleted: subject'); END;
CREATE TRIGGER session_delete BEFORE DELETE ON session
WHEN OLD.subject_id IS NOT (SELECT subject_id FROM withdrawal)
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be deleted: session'); END;
CREATE TRIGGER run_delete BEFORE DELETE ON run
WHEN OLD.subject_id IS NOT (SELECT subject_id FROM withdrawal)
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be deleted: run'); END;
CREATE TRIGGER consent_delete BEFORE DELETE ON consent
WHEN OLD.subject_id IS NOT (SELECT subject_id FROM withdrawal)
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be deleted: consent'); END;
CREATE TRIGGER answer_delete BEFORE DELETE ON answer
WHEN OLD.subject_id IS NOT (SELECT subject_id FROM withdrawal)
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be deleted: answer'); END;
CREATE TRIGGER trial_delete BEFORE DELETE ON trial
WHEN OLD.subject_id IS NOT (SELECT subject_id FROM withdrawal)
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be deleted: trial'); END;
CREATE TRIGGER event_delete BEFORE DELETE ON event
WHEN OLD.subject_id IS NOT (SELECT subject_id FROM withdrawal)
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be deleted: event'); END;
CREATE TRIGGER frame_delete BEFORE DELETE ON frame
WHEN NOT EXISTS (SELECT 1 FROM trial JOIN withdrawal USING (subject_id) WHERE trial.trial_id = OLD.trial_id)
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be deleted: frame'); END;
CREATE TRIGGER input_delete BEFORE DELETE ON input
WHEN NOT EXISTS (SELECT 1 FROM trial JOIN withdrawal USING (subject_id) WHERE trial.trial_id = OLD.trial_id)
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be deleted: input'); END;
CREATE TRIGGER gaze_delete BEFORE DELETE ON gaze
WHEN NOT EXISTS (SELECT 1 FROM trial JOIN withdrawal USING (subject_id) WHERE trial.trial_id = OLD.trial_id)
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be deleted: gaze'); END;
