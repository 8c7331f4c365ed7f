-- Version 2 to 3: exposures end by the clock, and their length on the screen is stored.
ALTER TABLE trial ADD COLUMN exposure_rule TEXT CHECK (exposure_rule IN ('clock', 'frames'));
ALTER TABLE trial ADD COLUMN exposure_shown_s REAL;
