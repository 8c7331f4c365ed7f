-- A study that version 1 of the tables holds: a simulated observer in six trials of a protocol of this version, made
-- before view conditions had names of their own. application_id and user_version are set by the test.
PRAGMA foreign_keys=OFF;
BEGIN TRANSACTION;
CREATE TABLE study (
  study_id         INTEGER PRIMARY KEY CHECK (study_id = 1),
  protocol_name    TEXT NOT NULL,
  protocol_sha256  TEXT NOT NULL,  -- of protocol_text, hexadecimal
  protocol_text    TEXT NOT NULL,  -- the protocol file, byte by byte
  program_version  TEXT NOT NULL,  -- of the program that made this file
  created_utc      TEXT NOT NULL
) STRICT;
INSERT INTO study VALUES(1,'made-before','8db86a13dbff242d0f1273e99a430c35d12f3043d4d2e725a1b8c12537cfe516',replace('{\n "name": "made-before",\n "title": "Which of two is nearer?",\n "description": "A study that version 1 of the tables holds.",\n "sessions": 1,\n "seed": 1,\n "mazes": {\n  "hall": {\n   "plan": [\n    "+-+-+-+-+-+-+-+-+",\n    "|   |   |   |   |",\n    "+ +-+ +-+ +-+ +-+",\n    "|               |",\n    "+ + +-+ +-+ +-+ +",\n    "| |   |   |   | |",\n    "+ +-+-+-+-+-+-+-+"\n   ],\n   "cell_size": 3,\n   "wall_height": 2.4,\n   "wall_thickness": 0.3\n  }\n },\n "consent": {\n  "title": "Taking part",\n  "paragraphs": [\n   "A sample."\n  ]\n },\n "demographics": {\n  "title": "About you",\n  "introduction": "These answers help to understand the results. None of them tells who you are.",\n  "fields": [\n   {\n    "name": "age_band",\n    "question": "How old are you?",\n    "options": [\n     "18 to 24",\n     "25 to 31",\n     "32 to 38",\n     "39 to 49",\n     "50 or more",\n     "rather not say"\n    ]\n   },\n   {\n    "name": "vision",\n    "question": "How is your vision, as you sit here now?",\n    "options": [\n     "normal",\n     "corrected by glasses or lenses",\n     "colour-blind",\n     "other impairment"\n    ]\n   }\n  ]\n },\n "blocks": [\n  {\n   "name": "nearer",\n   "title": "Which is nearer?",\n   "task": "nearer",\n   "order": "balanced",\n   "views": "both",\n   "maze": "hall",\n   "start": {\n    "row": 1,\n    "column": 0,\n    "heading": "east"\n   },\n   "answer_limit_seconds": 20,\n   "object": {\n    "shape": "sphere",\n    "color": "orange"\n   },\n   "instructions": [\n    {\n     "title": "t",\n     "paragraphs": [\n      "p"\n     ]\n    }\n   ],\n   "cases": [\n    {\n     "label": "2 and 3",\n     "left": {\n      "row": 1,\n      "column": 2,\n      "south": -0.22\n     },\n     "right": {\n      "row": 1,\n      "column": 3,\n      "south": 0.22\n     }\n    },\n    {\n     "label": "4 and 5",\n     "left": {\n      "row": 1,\n      "column": 4,\n      "south": -0.22\n     },\n     "right": {\n      "row": 1,\n      "column": 5,\n      "south": 0.22\n     }\n    },\n    {\n     "label": "3 and 2",\n     "left": {\n      "row": 1,\n      "column": 3,\n      "south": -0.22\n     },\n     "right": {\n      "row": 1,\n      "column": 2,\n      "south": 0.22\n     }\n    }\n   ]\n  }\n ],\n "survey": {\n  "title": "Last questions",\n  "fields": [\n   {\n    "name": "nearer_easier",\n    "question": "In which images was it easier to tell which ball is nearer?",\n    "options": [\n     "1",\n     "2",\n     "3",\n     "4",\n     "5"\n    ],\n    "ends": [\n     "much easier in the plain ones",\n     "much easier in the bent ones"\n    ],\n    "favors": [\n     "ppc",\n     "gc"\n    ]\n   }\n  ]\n }\n}','\n',char(10)),'0.1.0','2026-11-23T15:42:53.575Z');
CREATE TABLE subject (
  subject_id   TEXT PRIMARY KEY,  -- a pseudonym: letters, digits, - and _
  subject_key  TEXT NOT NULL UNIQUE,  -- random; tells two subjects of the same name apart when files are merged
  slot         INTEGER NOT NULL CHECK (slot >= 0),  -- place in the counterbalancing, from 0
  kind         TEXT NOT NULL CHECK (kind IN ('person', 'simulated_generator', 'simulated_observer')),
  simulated    INTEGER NOT NULL CHECK (simulated = (kind <> 'person')),
  created_utc  TEXT NOT NULL,
  UNIQUE (subject_id, simulated)
) STRICT;
INSERT INTO subject VALUES('sim-0001','0d90ed9b836d661b3262c90c42b04416',0,'simulated_observer',1,'2026-11-23T15:42:53.591Z');
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
INSERT INTO session VALUES('sim-0001',1,'{"slot":0,"session":0,"seed":8128655420063278861,"first_view":"ppc","block_order":[0],"trials":[{"index":0,"block":0,"task":"nearer","case":0,"view":"ppc","seed":6229615346458357},{"index":1,"block":0,"task":"nearer","case":1,"view":"gc","seed":3278376611011095},{"index":2,"block":0,"task":"nearer","case":2,"view":"ppc","seed":5267018825444539},{"index":3,"block":0,"task":"nearer","case":0,"view":"gc","seed":6229615346458357},{"index":4,"block":0,"task":"nearer","case":1,"view":"ppc","seed":3278376611011095},{"index":5,"block":0,"task":"nearer","case":2,"view":"gc","seed":5267018825444539}]}',8128655420063278861,6,'2000-01-03T09:00:00.000Z',1);
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
INSERT INTO run VALUES(1,'7236ec628b29c038454526813b63b312','sim-0001',1,1,'2000-01-03T09:00:00.000Z','2000-01-03T09:00:46.800Z','completed','0.1.0','simulation','{"simulated": true, "not_measured": ["screen", "input latency", "frame times"]}','{"simulated": true, "verdict": "simulated_clock"}',0,'{"subject":"simulated_observer","study_seed":3,"subject_seed":8128655420063278861,"renderer":"raster","frame_width":320,"frame_height":200,"refresh_hertz":10.0,"hashes_frames":true,"factors":{"fixation_seconds":0.32490084861438645,"fixation_spread_seconds":0.06,"saccade_seconds":0.035,"useful_field_degrees":13.080962796549457,"noticed_degrees":0.21005997348976807,"doubling_degrees":2.550164905875003,"notice_seconds":0.18669374789913212,"least_floor_degrees":0.3,"item_seconds":0.3196645427732616,"group_seconds":0.05681448862436468,"group_items":4,"group_radius_degrees":5.0,"working_memory_items":4.263261098086788,"place_error_meters":0.6174227020349705,"cross_view_error_meters":3.3824519358428855,"reaction_seconds":0.18673445572613795,"key_spread_seconds":0.032235467537165816,"turns_by_mouse":false,"bits_per_second":3.8827713287354553,"click_seconds":0.15820886849291882,"hold_seconds":0.09,"read_seconds":2.7387229538540017,"decide_seconds":0.6251568277040521,"way_noise":0.06771577742599715,"search_memory_seconds":43.38404915998164,"forget_per_trial":0.13624831417171002,"forget_between_sessions":0.4908000408521326,"turn_lapse":0.05039671975131726,"time_spread":0.15711798584976155,"slip":0.01}}',1);
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
INSERT INTO consent VALUES(1,1,'sim-0001',1,'Taking part','A sample.','e14190f5d8a87907195d8317ee3901d44da52b4deadb857303a0929b7de55216',1,'2000-01-03T09:00:02.500Z',1);
CREATE TABLE answer (
  answer_id       INTEGER PRIMARY KEY,
  run_id          INTEGER NOT NULL,
  subject_id      TEXT NOT NULL,
  session_number  INTEGER NOT NULL,
  form            TEXT NOT NULL,  -- name of the form in the protocol
  field           TEXT NOT NULL,  -- name of the question
  answer          TEXT NOT NULL,  -- the option that was chosen
  answered_utc    TEXT NOT NULL,
  simulated       INTEGER NOT NULL,
  FOREIGN KEY (run_id, subject_id, session_number, simulated)
    REFERENCES run (run_id, subject_id, session_number, simulated)
) STRICT;
INSERT INTO answer VALUES(1,1,'sim-0001',1,'demographics','age_band','18 to 24','2000-01-03T09:00:09.300Z',1);
INSERT INTO answer VALUES(2,1,'sim-0001',1,'demographics','vision','corrected by glasses or lenses','2000-01-03T09:00:09.300Z',1);
INSERT INTO answer VALUES(3,1,'sim-0001',1,'survey','nearer_easier','3','2000-01-03T09:00:46.800Z',1);
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
  view                 TEXT NOT NULL CHECK (view IN ('ppc', 'gc')),  -- planar pinhole camera(s), or graph camera
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
  UNIQUE (run_id, trial_number),
  UNIQUE (trial_id, simulated),
  FOREIGN KEY (run_id, subject_id, session_number, simulated)
    REFERENCES run (run_id, subject_id, session_number, simulated)
) STRICT;
INSERT INTO trial VALUES(1,1,'sim-0001',1,0,0,0,1,0,'nearer','nearer',0,'ppc',6229615346458357,'completed',14000000000,16000000000,'2000-01-03T09:00:14.000Z','2000-01-03T09:00:16.000Z','2 and 3',0,NULL,2,NULL,20.0,3.0,'left','left',1,0,1.9291666666666666962,463,0,'{"left_distance_m":6.036190835169479,"right_distance_m":9.024167540476185}',20,0,100000000,100000000,'simulated_clock',320,200,10.0,1);
INSERT INTO trial VALUES(2,1,'sim-0001',1,1,0,1,1,0,'nearer','nearer',1,'gc',3278376611011095,'completed',18700000000,20700000000,'2000-01-03T09:00:18.700Z','2000-01-03T09:00:20.700Z','4 and 5',0,NULL,2,NULL,20.0,3.0,'left','left',1,0,1.9833333333333333925,476,0,'{"left_distance_m":12.018136286404145,"right_distance_m":15.014512972407196}',20,0,100000000,100000000,'simulated_clock',320,200,10.0,1);
INSERT INTO trial VALUES(3,1,'sim-0001',1,2,0,2,1,0,'nearer','nearer',2,'ppc',5267018825444539,'completed',24000000000,25600000000,'2000-01-03T09:00:24.000Z','2000-01-03T09:00:25.600Z','3 and 2',0,NULL,2,NULL,20.0,3.0,'right','right',1,0,1.5541666666666666962,373,0,'{"left_distance_m":9.024167540476185,"right_distance_m":6.036190835169479}',16,0,100000000,100000000,'simulated_clock',320,200,10.0,1);
INSERT INTO trial VALUES(4,1,'sim-0001',1,3,0,3,1,0,'nearer','nearer',0,'gc',6229615346458357,'completed',29800000000,31600000000,'2000-01-03T09:00:29.800Z','2000-01-03T09:00:31.600Z','2 and 3',0,NULL,2,NULL,20.0,3.0,'left','left',1,0,1.7250000000000000888,414,0,'{"left_distance_m":6.036190835169479,"right_distance_m":9.024167540476185}',18,0,100000000,100000000,'simulated_clock',320,200,10.0,1);
INSERT INTO trial VALUES(5,1,'sim-0001',1,4,0,4,1,0,'nearer','nearer',1,'ppc',3278376611011095,'completed',35100000000,37000000000,'2000-01-03T09:00:35.100Z','2000-01-03T09:00:37.000Z','4 and 5',0,NULL,2,NULL,20.0,3.0,'left','left',1,0,1.8833333333333333037,452,0,'{"left_distance_m":12.018136286404145,"right_distance_m":15.014512972407196}',19,0,100000000,100000000,'simulated_clock',320,200,10.0,1);
INSERT INTO trial VALUES(6,1,'sim-0001',1,5,0,5,1,0,'nearer','nearer',2,'gc',5267018825444539,'completed',40000000000,41700000000,'2000-01-03T09:00:40.000Z','2000-01-03T09:00:41.700Z','3 and 2',0,NULL,2,NULL,20.0,3.0,'right','right',1,0,1.6708333333333333925,401,0,'{"left_distance_m":9.024167540476185,"right_distance_m":6.036190835169479}',17,0,100000000,100000000,'simulated_clock',320,200,10.0,1);
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
INSERT INTO frame VALUES(1,0,0,14000000000,1.5,4.5,1.5707963267948965579,3805957490922243306,1);
INSERT INTO frame VALUES(1,1,24,14100000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(1,2,48,14200000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(1,3,72,14300000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(1,4,96,14400000000,1.5,4.5,1.5707963267948965579,3805957490922243306,1);
INSERT INTO frame VALUES(1,5,120,14500000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(1,6,144,14600000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(1,7,168,14700000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(1,8,192,14800000000,1.5,4.5,1.5707963267948965579,3805957490922243306,1);
INSERT INTO frame VALUES(1,9,216,14900000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(1,10,240,15000000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(1,11,264,15100000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(1,12,288,15200000000,1.5,4.5,1.5707963267948965579,3805957490922243306,1);
INSERT INTO frame VALUES(1,13,312,15300000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(1,14,336,15400000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(1,15,360,15500000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(1,16,384,15600000000,1.5,4.5,1.5707963267948965579,3805957490922243306,1);
INSERT INTO frame VALUES(1,17,408,15700000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(1,18,432,15800000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(1,19,456,15900000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(2,0,0,18700000000,1.5,4.5,1.5707963267948965579,-5534459951241099505,1);
INSERT INTO frame VALUES(2,1,24,18800000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(2,2,48,18900000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(2,3,72,19000000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(2,4,96,19100000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(2,5,120,19200000000,1.5,4.5,1.5707963267948965579,-5534459951241099505,1);
INSERT INTO frame VALUES(2,6,144,19300000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(2,7,168,19400000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(2,8,192,19500000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(2,9,216,19600000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(2,10,240,19700000000,1.5,4.5,1.5707963267948965579,-5534459951241099505,1);
INSERT INTO frame VALUES(2,11,264,19800000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(2,12,288,19900000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(2,13,312,20000000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(2,14,336,20100000000,1.5,4.5,1.5707963267948965579,-5534459951241099505,1);
INSERT INTO frame VALUES(2,15,360,20200000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(2,16,384,20300000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(2,17,408,20400000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(2,18,432,20500000000,1.5,4.5,1.5707963267948965579,-5534459951241099505,1);
INSERT INTO frame VALUES(2,19,456,20600000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(3,0,0,24000000000,1.5,4.5,1.5707963267948965579,-1603682091617747350,1);
INSERT INTO frame VALUES(3,1,24,24100000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(3,2,48,24200000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(3,3,72,24300000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(3,4,96,24400000000,1.5,4.5,1.5707963267948965579,-1603682091617747350,1);
INSERT INTO frame VALUES(3,5,120,24500000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(3,6,144,24600000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(3,7,168,24700000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(3,8,192,24800000000,1.5,4.5,1.5707963267948965579,-1603682091617747350,1);
INSERT INTO frame VALUES(3,9,216,24900000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(3,10,240,25000000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(3,11,264,25100000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(3,12,288,25200000000,1.5,4.5,1.5707963267948965579,-1603682091617747350,1);
INSERT INTO frame VALUES(3,13,312,25300000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(3,14,336,25400000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(3,15,360,25500000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(4,0,0,29800000000,1.5,4.5,1.5707963267948965579,-4102645588783731911,1);
INSERT INTO frame VALUES(4,1,24,29900000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(4,2,48,30000000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(4,3,72,30100000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(4,4,96,30200000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(4,5,120,30300000000,1.5,4.5,1.5707963267948965579,-4102645588783731911,1);
INSERT INTO frame VALUES(4,6,144,30400000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(4,7,168,30500000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(4,8,192,30600000000,1.5,4.5,1.5707963267948965579,-4102645588783731911,1);
INSERT INTO frame VALUES(4,9,216,30700000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(4,10,240,30800000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(4,11,264,30900000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(4,12,288,31000000000,1.5,4.5,1.5707963267948965579,-4102645588783731911,1);
INSERT INTO frame VALUES(4,13,312,31100000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(4,14,336,31200000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(4,15,360,31300000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(4,16,384,31400000000,1.5,4.5,1.5707963267948965579,-4102645588783731911,1);
INSERT INTO frame VALUES(4,17,408,31500000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(5,0,0,35100000000,1.5,4.5,1.5707963267948965579,6954448803215055487,1);
INSERT INTO frame VALUES(5,1,24,35200000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(5,2,48,35300000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(5,3,72,35400000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(5,4,96,35500000000,1.5,4.5,1.5707963267948965579,6954448803215055487,1);
INSERT INTO frame VALUES(5,5,120,35600000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(5,6,144,35700000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(5,7,168,35800000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(5,8,192,35900000000,1.5,4.5,1.5707963267948965579,6954448803215055487,1);
INSERT INTO frame VALUES(5,9,216,36000000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(5,10,240,36100000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(5,11,264,36200000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(5,12,288,36300000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(5,13,312,36400000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(5,14,336,36500000000,1.5,4.5,1.5707963267948965579,6954448803215055487,1);
INSERT INTO frame VALUES(5,15,360,36600000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(5,16,384,36700000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(5,17,408,36800000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(5,18,432,36900000000,1.5,4.5,1.5707963267948965579,6954448803215055487,1);
INSERT INTO frame VALUES(6,0,0,40000000000,1.5,4.5,1.5707963267948965579,5854631558567883593,1);
INSERT INTO frame VALUES(6,1,24,40100000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(6,2,48,40200000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(6,3,72,40300000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(6,4,96,40400000000,1.5,4.5,1.5707963267948965579,5854631558567883593,1);
INSERT INTO frame VALUES(6,5,120,40500000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(6,6,144,40600000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(6,7,168,40700000000,1.5,4.5,1.5707963267948965579,5854631558567883593,1);
INSERT INTO frame VALUES(6,8,192,40800000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(6,9,216,40900000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(6,10,240,41000000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(6,11,264,41100000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(6,12,288,41200000000,1.5,4.5,1.5707963267948965579,5854631558567883593,1);
INSERT INTO frame VALUES(6,13,312,41300000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(6,14,336,41400000000,1.5,4.5,1.5707963267948965579,5854631558567883593,1);
INSERT INTO frame VALUES(6,15,360,41500000000,1.5,4.5,1.5707963267948965579,NULL,1);
INSERT INTO frame VALUES(6,16,384,41600000000,1.5,4.5,1.5707963267948965579,NULL,1);
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
INSERT INTO input VALUES(1,0,3,14014694206,'key','Enter',0,0,NULL,NULL,NULL,1);
INSERT INTO input VALUES(1,1,463,15932559292,'key','Left',1,0,NULL,NULL,NULL,1);
INSERT INTO input VALUES(2,0,15,18763412759,'key','Enter',0,0,NULL,NULL,NULL,1);
INSERT INTO input VALUES(2,1,476,20684532599,'key','Left',1,0,NULL,NULL,NULL,1);
INSERT INTO input VALUES(3,0,16,24066783441,'key','Enter',0,0,NULL,NULL,NULL,1);
INSERT INTO input VALUES(3,1,373,25556692829,'key','Right',1,0,NULL,NULL,NULL,1);
INSERT INTO input VALUES(4,0,25,29905873506,'key','Enter',0,0,NULL,NULL,NULL,1);
INSERT INTO input VALUES(4,1,414,31526054477,'key','Left',1,0,NULL,NULL,NULL,1);
INSERT INTO input VALUES(5,0,5,35122292274,'key','Enter',0,0,NULL,NULL,NULL,1);
INSERT INTO input VALUES(5,1,452,36986951162,'key','Left',1,0,NULL,NULL,NULL,1);
INSERT INTO input VALUES(6,0,10,40042132516,'key','Enter',0,0,NULL,NULL,NULL,1);
INSERT INTO input VALUES(6,1,401,41674967281,'key','Right',1,0,NULL,NULL,NULL,1);
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
INSERT INTO event VALUES(1,1,'sim-0001',1,9300000000,'2000-01-03T09:00:09.300Z','page','t',1);
CREATE TABLE audit (
  audit_id         INTEGER PRIMARY KEY,
  at_utc           TEXT NOT NULL,
  action           TEXT NOT NULL,  -- 'created', 'migrated', 'withdrawn', 'merged', 'exported'
  detail_json      TEXT NOT NULL,
  program_version  TEXT NOT NULL,
  station          TEXT NOT NULL
) STRICT;
INSERT INTO audit VALUES(1,'2026-11-23T15:42:53.575Z','created','{}','0.1.0','station');
CREATE TABLE withdrawal (
  withdrawal_id      INTEGER PRIMARY KEY CHECK (withdrawal_id = 1),
  subject_id         TEXT,  -- whose rows may be deleted now
  leftovers_pending  INTEGER NOT NULL CHECK (leftovers_pending IN (0, 1))  -- deleted, but not yet wiped from the file
) STRICT;
INSERT INTO withdrawal VALUES(1,NULL,0);
CREATE INDEX run_of_session ON run (subject_id, session_number);
CREATE INDEX consent_of_run ON consent (run_id);
CREATE INDEX answer_of_run ON answer (run_id);
CREATE INDEX trial_of_plan ON trial (subject_id, session_number, plan_index);
CREATE INDEX event_of_run ON event (run_id);
CREATE VIEW final_trial AS
SELECT trial.*, subject.kind AS subject_kind, subject.slot, run.station, run.forced
FROM trial JOIN subject USING (subject_id) JOIN run USING (run_id)
WHERE trial.practice = 0 AND trial.ending = 'completed' AND NOT EXISTS (
  SELECT 1 FROM trial AS later
  WHERE later.subject_id = trial.subject_id AND later.session_number = trial.session_number
    AND later.plan_index = trial.plan_index AND later.ending = 'completed' AND later.trial_id > trial.trial_id);
CREATE VIEW final_answer AS
SELECT answer.*, subject.kind AS subject_kind, subject.slot
FROM answer JOIN subject USING (subject_id)
WHERE NOT EXISTS (
  SELECT 1 FROM answer AS later
  WHERE later.subject_id = answer.subject_id AND later.session_number = answer.session_number
    AND later.form = answer.form AND later.field = answer.field AND later.answer_id > answer.answer_id);
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
CREATE TRIGGER event_update BEFORE UPDATE ON event
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be changed: event'); END;
CREATE TRIGGER audit_update BEFORE UPDATE ON audit
WHEN (SELECT subject_id FROM withdrawal) IS NULL  -- names of files may hold the id of who withdraws
BEGIN SELECT RAISE(ABORT, 'recorded data cannot be changed: audit'); END
;
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
COMMIT;
