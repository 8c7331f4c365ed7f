#include "analysis/dataset/database.h"

#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>

#include "analysis/dataset/protocol_facts.h"
#include "analysis/dataset/row_digest.h"
#include "oc_core/base/error.h"
#include "study/trial/stored_row.h"
#include "study/trial/trials_file.h"

namespace ocelli {
namespace {

class DatabaseReading {
 public:
  explicit DatabaseReading(const std::string& path) : path_(path), database_(openTrials(path)) {}

  Dataset all() {
    return whileReading(path_, [&] {
      // One moment for all tables, whatever is written meanwhile.
      SQLite::Transaction transaction(database_);
      checkIntegrity(database_, path_);
      readStudy();
      readSubjects();
      readSessions();
      readRuns();
      readConsents();
      readAnswers();
      readTrials();
      readOtherAttempts();
      return std::move(data_);
    });
  }

 private:
  template <class Read>
  void forEachRow(const char* query, const Read& read) {
    SQLite::Statement statement(database_, query);
    while (statement.executeStep()) {
      StoredRow row(statement, path_);
      read(row);
    }
  }
  void readStudy();
  std::vector<Withdrawal> readWithdrawals();
  void readSubjects();
  void readSessions();
  void readRuns();
  void readConsents();
  void readAnswers();
  void readTrials();
  void readOtherAttempts();

  std::filesystem::path path_;
  SQLite::Database database_;
  Dataset data_{};
};

void DatabaseReading::readStudy() {
  DataSource source;
  source.path = path_.string();
  forEachRow("SELECT protocol_name, protocol_sha256, protocol_text, program_version FROM study", [&](StoredRow& row) {
    source.protocolName = row.text();
    source.protocolSha256 = row.text();
    source.protocolText = row.text();
    source.programVersion = row.text();
  });
  if (source.protocolSha256.empty()) {
    throw InputError("this database holds no study yet", path_.string(),
                     "again when a session has begun, which stores the protocol");
  }
  if (sha256(source.protocolText) != source.protocolSha256) {
    throw InputError(
        "the protocol in this database does not have the SHA-256 that stands beside it: someone changed it",
        path_.string(), "the database as the study wrote it");
  }
  source.withdrawals = readWithdrawals();
  data_.conditions = protocolFacts(source.protocolText, fmt::format("{}, protocol", path_.string())).conditions;
  data_.sources.push_back(std::move(source));
}

std::vector<Withdrawal> DatabaseReading::readWithdrawals() {
  std::vector<Withdrawal> withdrawals;
  forEachRow(kWithdrawalQuery, [&](StoredRow& row) {
    if (const std::optional<Withdrawal> withdrawal = withdrawalOf(row.text())) {
      withdrawals.push_back(*withdrawal);
    }
  });
  return withdrawals;
}

void DatabaseReading::readSubjects() {
  forEachRow("SELECT subject_id, subject_key, kind, simulated, slot, created_utc FROM subject ORDER BY subject_id",
             [&](StoredRow& row) {
               Subject subject;
               subject.id = row.name();
               subject.key = row.text();
               subject.kind = row.word(kSubjectKinds);
               subject.simulated = row.flag();
               subject.slot = row.smallInteger();
               subject.createdUtc = row.text();
               data_.subjects.push_back(std::move(subject));
             });
}

void DatabaseReading::readSessions() {
  forEachRow(
      "SELECT subject_id, session_number, simulated, planned_trials, completed_trials, runs, ending, "
      "(SELECT max(forced) FROM run WHERE run.subject_id = session_state.subject_id "
      "AND run.session_number = session_state.session_number) "
      "FROM session_state ORDER BY subject_id, session_number",
      [&](StoredRow& row) {
        Session session;
        session.subject = row.name();
        session.number = row.smallInteger();
        session.simulated = row.flag();
        session.plannedTrials = row.smallInteger();
        session.completedTrials = row.smallInteger();
        session.runs = row.smallInteger();
        session.ending = row.optionalWord(kSessionEndings);
        session.forced = row.optionalFlag().value_or(false);
        data_.sessions.push_back(std::move(session));
      });
}

void DatabaseReading::readRuns() {
  forEachRow(
      "SELECT subject_id, session_number, run_number, station, forced, simulated, environment_json, timing_check_json "
      "FROM run ORDER BY run_id",
      [&](StoredRow& row) {
        Run run;
        run.subject = row.name();
        run.session = row.smallInteger();
        run.number = row.smallInteger();
        run.station = row.text();
        run.forced = row.flag();
        run.simulated = row.flag();
        run.environment = row.text();
        run.timingCheck = row.text();
        data_.runs.push_back(std::move(run));
      });
}

void DatabaseReading::readConsents() {
  forEachRow("SELECT subject_id, session_number, agreed FROM consent ORDER BY consent_id", [&](StoredRow& row) {
    Consent consent;
    consent.subject = row.name();
    consent.session = row.smallInteger();
    consent.agreed = row.flag();
    data_.consents.push_back(std::move(consent));
  });
}

void DatabaseReading::readAnswers() {
  forEachRow(
      "SELECT answer_id, subject_id, session_number, form, field, answer, simulated FROM final_answer "
      "ORDER BY answer_id",
      [&](StoredRow& row) {
        FormAnswer answer;
        answer.answerId = row.integer();
        answer.subject = row.name();
        answer.session = row.smallInteger();
        answer.form = row.name();
        answer.field = row.name();
        answer.answer = row.text();
        answer.simulated = row.flag();
        data_.answers.push_back(std::move(answer));
      });
}

void DatabaseReading::readTrials() {
  const std::string query = fmt::format("SELECT {} FROM final_trial ORDER BY trial_id",
                                        trialColumns("subject_kind", trialsVersionOf(database_, path_)));
  forEachRow(query.c_str(), [&](StoredRow& row) {
    Trial trial{readTrial(row, data_.conditions)};
    trial.digest = digestOf(trial, data_.conditions.nameOf(trial.view));
    data_.trials.push_back(std::move(trial));
  });
}

void DatabaseReading::readOtherAttempts() {
  forEachRow(
      "SELECT trial_id, subject_id, session_number, block_index, block, simulated, practice, ending, correct, view "
      "FROM trial WHERE practice = 1 OR ending IS NOT 'completed' OR trial_id NOT IN (SELECT trial_id FROM "
      "final_trial) "
      "ORDER BY trial_id",
      [&](StoredRow& row) {
        OtherAttempt attempt;
        attempt.trialId = row.integer();
        attempt.subject = row.name();
        attempt.session = row.smallInteger();
        attempt.blockIndex = row.smallInteger();
        attempt.block = row.name();
        attempt.simulated = row.flag();
        const bool practice = row.flag();
        attempt.why = whyNotCounted(practice, row.optionalWord(kTrialEndings));
        attempt.correct = row.optionalFlag();
        attempt.view = row.text();
        data_.otherAttempts.push_back(std::move(attempt));
      });
}

}  // namespace

Dataset readDatabase(const std::string& path) {
  return DatabaseReading(path).all();
}

}  // namespace ocelli
