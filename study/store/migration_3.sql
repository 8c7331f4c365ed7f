-- Version 3 to 4: where the subject looked.
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
CREATE TRIGGER gaze_update BEFORE UPDATE ON gaze
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be changed: gaze'); END;
CREATE TRIGGER gaze_delete BEFORE DELETE ON gaze
WHEN NOT EXISTS (SELECT 1 FROM trial JOIN withdrawal USING (subject_id) WHERE trial.trial_id = OLD.trial_id)
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be deleted: gaze'); END;
