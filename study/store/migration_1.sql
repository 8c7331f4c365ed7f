-- Version 1 to 2: the name of a view condition may be any, as protocols name their own.
DROP VIEW final_trial;
DROP VIEW session_state;
DROP TRIGGER frame_delete;
DROP TRIGGER input_delete;
CREATE TABLE trial_new (
  trial_id             INTEGER PRIMARY KEY,
  run_id               INTEGER NOT NULL,
  subject_id           TEXT NOT NULL,
  session_number       INTEGER NOT NULL,
  trial_number         INTEGER NOT NULL,
  practice             INTEGER NOT NULL CHECK (practice IN (0, 1)),
  plan_index           INTEGER CHECK ((plan_index IS NULL) = (practice = 1)),
  attempt              INTEGER NOT NULL CHECK (attempt >= 1),
  block_index          INTEGER NOT NULL,
  block                TEXT NOT NULL,
  task                 TEXT NOT NULL,
  case_index           INTEGER NOT NULL,
  view                 TEXT NOT NULL CHECK (view <> ''),
  trial_seed           INTEGER NOT NULL,
  ending               TEXT CHECK (ending IN ('completed', 'redone', 'aborted')),
  started_ns           INTEGER,
  ended_ns             INTEGER,
  started_utc          TEXT,
  ended_utc            TEXT,
  case_label           TEXT,
  moving               INTEGER CHECK (moving IN (0, 1)),
  exposure_s           REAL,
  objects              INTEGER,
  duplicate_colors     INTEGER CHECK (duplicate_colors IN (0, 1)),
  longest_s            REAL,
  typical_s            REAL,
  answer               TEXT,
  expected             TEXT,
  correct              INTEGER CHECK (correct IN (0, 1)),
  censored             INTEGER CHECK (censored IN (0, 1)),
  response_s           REAL,
  response_ticks       INTEGER,
  exposure_frames      INTEGER,
  measures_json        TEXT,
  frames               INTEGER,
  dropped_frames       INTEGER,
  median_interval_ns   INTEGER,
  longest_interval_ns  INTEGER,
  timing_verdict       TEXT,
  screen_width_px      INTEGER,
  screen_height_px     INTEGER,
  refresh_hz           REAL,
  simulated            INTEGER NOT NULL,
  UNIQUE (run_id, trial_number),
  UNIQUE (trial_id, simulated),
  FOREIGN KEY (run_id, subject_id, session_number, simulated)
    REFERENCES run (run_id, subject_id, session_number, simulated)
) STRICT;
INSERT INTO trial_new SELECT * FROM trial;
DROP TABLE trial;
ALTER TABLE trial_new RENAME TO trial;
CREATE INDEX trial_of_plan ON trial (subject_id, session_number, plan_index);
CREATE VIEW final_trial AS
SELECT trial.*, subject.kind AS subject_kind, subject.slot, run.station, run.forced
FROM trial JOIN subject USING (subject_id) JOIN run USING (run_id)
WHERE trial.practice = 0 AND trial.ending = 'completed' AND NOT EXISTS (
  SELECT 1 FROM trial AS later
  WHERE later.subject_id = trial.subject_id AND later.session_number = trial.session_number
    AND later.plan_index = trial.plan_index AND later.ending = 'completed' AND later.trial_id > trial.trial_id);
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
CREATE TRIGGER trial_update BEFORE UPDATE ON trial
WHEN OLD.ending IS NOT NULL
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be changed: trial'); END;
CREATE TRIGGER trial_update_plan BEFORE UPDATE OF trial_id, run_id, subject_id, session_number, trial_number, practice,
  plan_index, attempt, block_index, block, task, case_index, view, trial_seed, simulated ON trial
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be changed: trial'); END;
CREATE TRIGGER trial_delete BEFORE DELETE ON trial
WHEN OLD.subject_id IS NOT (SELECT subject_id FROM withdrawal)
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be deleted: trial'); END;
CREATE TRIGGER frame_delete BEFORE DELETE ON frame
WHEN NOT EXISTS (SELECT 1 FROM trial JOIN withdrawal USING (subject_id) WHERE trial.trial_id = OLD.trial_id)
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be deleted: frame'); END;
CREATE TRIGGER input_delete BEFORE DELETE ON input
WHEN NOT EXISTS (SELECT 1 FROM trial JOIN withdrawal USING (subject_id) WHERE trial.trial_id = OLD.trial_id)
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be deleted: input'); END;
