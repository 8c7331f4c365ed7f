#include "tests/analysis_dataset/sample_study.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "oc_core/base/sha256.h"

namespace ocelli::test {
namespace {

/// Of studies whose protocol names its view conditions, without the rule that names two.
std::string schemaFor(const std::string& protocol) {
  std::ostringstream text;
  text << std::ifstream(OCELLI_SOURCE_DIR "/protocols/trials.schema.sql").rdbuf();
  std::string schema = std::move(text).str();
  const std::string rule = "CHECK (view IN ('ppc', 'gc'))";
  const size_t at = schema.find(rule);
  if (protocol.find("\"conditions\"") != std::string::npos && at != std::string::npos) {
    schema.erase(at, rule.size());
  }
  return schema;
}

int simulatedOf(SQLite::Database& database, const std::string& subject) {
  SQLite::Statement row(database, "SELECT simulated FROM subject WHERE subject_id = ?");
  row.bind(1, subject);
  row.executeStep();
  return row.getColumn(0).getInt();
}

/// Binds a value, or NULL where there is none.
template <class Value>
void bindOptional(SQLite::Statement& statement, int at, const std::optional<Value>& value) {
  if (!value) {
    statement.bind(at);
  } else if constexpr (std::is_same_v<Value, bool>) {
    statement.bind(at, *value ? 1 : 0);
  } else {
    statement.bind(at, *value);
  }
}

}  // namespace

const char* const kSampleProtocol = R"({
  "name": "rosen2010-sample", "title": "A sample", "sessions": 2,
  "mazes": {"small": {"plan": ["+-+-+-+", "|     |", "+ +-+ +", "|   | |", "+ +-+-+"], "cell_size": 2, "wall_thickness": 0.2}},
  "consent": {"title": "Taking part", "paragraphs": ["You may stop."]},
  "blocks": [
    {"name": "find stationary", "title": "Find", "task": "find", "maze": "small", "limit_seconds": 60,
     "fov_horizontal_degrees": 90, "practice": {"least_correct": 2}, "practice_cases": [{"row": 0, "column": 0}],
     "cases": [{"label": "location 1", "row": 0, "column": 2}, {"label": "location 2", "row": 1, "column": 2}]},
    {"name": "count stationary", "title": "Count", "task": "count", "maze": "small", "views": "one",
     "cases": [{"objects": 4, "exposure_seconds": 5, "duplicate_colors": false}]}
  ],
  "exclusions": [{"what": "ending", "test": "is", "value": "unwell", "reason": "motion sickness"},
                 {"what": "form:vision", "test": "is", "value": "colour-blind", "reason": "impaired vision"}]
})";

SampleFolder::SampleFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "ocelli-analysis-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) {
    throw std::runtime_error("cannot make a folder for a test");
  }
  path_ = pattern;
}

SampleFolder::~SampleFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

SampleStudy::SampleStudy(const std::string& path, const std::string& protocol)
    : database_(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE) {
  database_.exec("PRAGMA journal_mode = WAL; PRAGMA synchronous = OFF; PRAGMA foreign_keys = ON");
  database_.exec(schemaFor(protocol));
  SQLite::Statement insert(
      database_, "INSERT INTO study VALUES (1, 'rosen2010-sample', ?, ?, '0.1.0', '2026-01-01T00:00:00.000Z')");
  insert.bind(1, sha256(protocol));
  insert.bind(2, protocol);
  insert.exec();
}

void SampleStudy::addSubject(const std::string& id, const std::string& kind, const std::string& key) {
  const int slot = database_.execAndGet("SELECT count(*) FROM subject").getInt();
  SQLite::Statement insert(database_, "INSERT INTO subject VALUES (?, ?, ?, ?, ?, '2026-01-02T00:00:00.000Z')");
  insert.bind(1, id);
  insert.bind(2, key.empty() ? fmt::format("key of {}", id) : key);
  insert.bind(3, slot);
  insert.bind(4, kind);
  insert.bind(5, kind == "person" ? 0 : 1);
  insert.exec();
}

void SampleStudy::addSession(const std::string& subject, int session, const std::string& ending, bool forced) {
  const int simulated = simulatedOf(database_, subject);
  SQLite::Statement insert(database_, "INSERT INTO session VALUES (?, ?, '{}', 7, 3, '2026-01-02T00:00:00.000Z', ?)");
  insert.bind(1, subject);
  insert.bind(2, session);
  insert.bind(3, simulated);
  insert.exec();
  SQLite::Statement run(database_,
                        "INSERT INTO run (run_key, subject_id, session_number, run_number, started_utc, ended_utc, "
                        "ending, program_version, station, environment_json, timing_check_json, forced, simulated) "
                        "VALUES (?, ?, ?, 1, '2026-01-02T00:00:00.000Z', ?, ?, '0.1.0', 'here', '{}', '{}', ?, ?)");
  run.bind(1, fmt::format("{} {}", subject, session));
  run.bind(2, subject);
  run.bind(3, session);
  if (!ending.empty()) {
    run.bind(4, "2026-01-02T01:00:00.000Z");
    run.bind(5, ending);
  }
  run.bind(6, forced ? 1 : 0);
  run.bind(7, simulated);
  run.exec();
}

void SampleStudy::addConsent(const std::string& subject, bool agreed) {
  SQLite::Statement insert(database_,
                           "INSERT INTO consent (run_id, subject_id, session_number, title, text, text_sha256, agreed, "
                           "answered_utc, simulated) SELECT run_id, subject_id, session_number, '', '', '', ?, '', "
                           "simulated FROM run WHERE subject_id = ? AND session_number = 1");
  insert.bind(1, agreed ? 1 : 0);
  insert.bind(2, subject);
  insert.exec();
}

void SampleStudy::addAnswer(const std::string& subject, const std::string& form, const std::string& field,
                            const std::string& answer, int session) {
  SQLite::Statement insert(database_,
                           "INSERT INTO answer (run_id, subject_id, session_number, form, field, answer, answered_utc, "
                           "simulated) SELECT run_id, subject_id, session_number, ?, ?, ?, '', simulated FROM run "
                           "WHERE subject_id = ? AND session_number = ?");
  insert.bind(1, form);
  insert.bind(2, field);
  insert.bind(3, answer);
  insert.bind(4, subject);
  insert.bind(5, session);
  insert.exec();
}

int64_t SampleStudy::addTrial(const SampleTrial& trial) {
  SQLite::Statement insert(
      database_,
      "INSERT INTO trial (run_id, subject_id, session_number, trial_number, practice, plan_index, attempt, "
      "block_index, "
      "block, task, case_index, view, trial_seed, simulated, ending, case_label, moving, exposure_s, objects, "
      "duplicate_colors, longest_s, answer, expected, correct, censored, response_s, response_ticks, measures_json, "
      "frames, dropped_frames, timing_verdict, started_ns, ended_ns, started_utc, ended_utc) "
      "SELECT run_id, subject_id, session_number, ?, ?, ?, ?, ?, ?, ?, ?, ?, 11, simulated, ?, ?, ?, ?, ?, ?, 60, ?, "
      "?, ?, "
      "?, ?, ?, ?, ?, ?, ?, 0, 1, '2026-01-02T00:10:00.000Z', '2026-01-02T00:11:00.000Z' "
      "FROM run WHERE subject_id = ? AND session_number = ?");
  int at = 0;
  insert.bind(++at, static_cast<int>(trials_));
  insert.bind(++at, trial.plan ? 0 : 1);
  bindOptional(insert, ++at, trial.plan);
  insert.bind(++at, trial.attempt);
  insert.bind(++at, trial.blockIndex);
  insert.bind(++at, trial.block);
  insert.bind(++at, trial.task);
  insert.bind(++at, trial.caseIndex);
  insert.bind(++at, trial.view);
  bindOptional(insert, ++at, trial.ending.empty() ? std::nullopt : std::optional(trial.ending));
  insert.bind(++at, trial.caseLabel);
  bindOptional(insert, ++at, trial.moving);
  bindOptional(insert, ++at, trial.exposure);
  bindOptional(insert, ++at, trial.objects);
  bindOptional(insert, ++at, trial.duplicates);
  insert.bind(++at, trial.answer);
  insert.bind(++at, trial.expected);
  insert.bind(++at, trial.correct ? 1 : 0);
  insert.bind(++at, trial.censored ? 1 : 0);
  insert.bind(++at, trial.response);
  insert.bind(++at, static_cast<int64_t>(trial.response * 240 + 0.5));
  insert.bind(++at, trial.measures);
  insert.bind(++at, trial.frames);
  insert.bind(++at, trial.dropped);
  insert.bind(++at, trial.verdict);
  insert.bind(++at, trial.subject);
  insert.bind(++at, trial.session);
  if (insert.exec() != 1) {
    throw std::runtime_error("a trial of a session that the sample does not have");
  }
  return ++trials_;
}

void SampleStudy::addFrame(int64_t trial, int frame, double x, double z, double heading) {
  SQLite::Statement insert(database_,
                           "INSERT INTO frame SELECT trial_id, ?, ?, ?, ?, ?, ?, NULL, simulated FROM trial "
                           "WHERE trial_id = ?");
  insert.bind(1, frame);
  insert.bind(2, 4 * frame);
  insert.bind(3, frame * int64_t{16'666'667});
  insert.bind(4, x);
  insert.bind(5, z);
  insert.bind(6, heading);
  insert.bind(7, trial);
  insert.exec();
}

void fillSmallStudy(SampleStudy& study) {
  for (const char* subject : {"S01", "S02"}) {
    study.addSubject(subject);
    for (const int session : {1, 2}) {
      study.addSession(subject, session);
      SampleTrial trial;
      trial.subject = subject;
      trial.session = session;
      trial.response = 10 + session;
      if (session == 1 && std::string(subject) == "S02") {
        trial.censored = true;
        trial.correct = false;
        trial.answer = "";
        trial.response = 60;
      }
      study.addTrial(trial);
      trial = {};
      trial.subject = subject;
      trial.session = session;
      trial.plan = 1;
      trial.view = "gc";
      trial.response = 5 + session;
      trial.measures = R"({"path_length_m": 12.5, "wrong_clicks": 0})";
      study.addTrial(trial);
      trial.plan = 2;
      trial.task = "count";
      trial.blockIndex = 1;
      trial.block = "count stationary";
      trial.caseLabel = "case 1";
      trial.exposure = 5;
      trial.objects = 4;
      trial.duplicates = false;
      trial.answer = std::to_string(*trial.objects);
      trial.expected = trial.answer;
      trial.measures = R"({"count_error": 0})";
      study.addTrial(trial);
    }
    study.addConsent(subject, true);
    study.addAnswer(subject, "demographics", "vision", "normal");
    study.addAnswer(subject, "survey", "easier_find", subject[2] == '1' ? "5" : "4", 2);
  }
}

}  // namespace ocelli::test
