// What an analysis works on: the trials that count, the answers, sessions and subjects of one study, from one or more
// files. It is read by database.h, csv_export.h and mapped_trials.h, put together by merge.h, and thinned by
// exclusions.h.
//
// Every row keeps where it stands: its file (an index into `sources`) and its number there.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/dataset/trial.h"
#include "study/trial/withdrawal.h"

namespace ocelli {

/// A file, or a folder of tables.
struct DataSource {
  enum class Form : uint8_t { kDatabase, kCsv, kMappedTable };

  std::string path;
  Form form = Form::kDatabase;
  // Of the protocol; empty where tables came without it.
  std::string protocolName{};
  std::string protocolSha256{};  ///< 64 hexadecimal digits
  std::string protocolText{};
  std::string programVersion{};  ///< of the program that made it
  std::vector<Withdrawal> withdrawals{};
  // Of tables of other tools (mapped_trials.h).
  std::string tool{};
  std::string columnMap{};
  std::string columnMapSha256{};  ///< 64 hexadecimal digits
  std::string columnMapText{};    ///< "subject: column participant; ..."
  bool subjectsAreKnown = true;   ///< false: nothing says whether they are people or simulated
};

struct Subject {
  int source = 0;
  std::string id;
  std::string key;  ///< random; empty where tables do not hold it
  SubjectKind kind = SubjectKind::kPerson;
  bool simulated = false;
  int slot = 0;  ///< place in the counterbalancing
  std::string createdUtc;
};

/// A session that a subject began.
struct Session {
  int source = 0;
  std::string subject;
  int number = 1;
  bool simulated = false;
  std::optional<int> plannedTrials{};  ///< not known from tables
  int completedTrials = 0;             ///< plans with an attempt that was completed
  int runs = 0;
  std::optional<SessionEnding> ending{};  ///< of its last run; nothing: it runs, or the program was killed
  bool forced = false;                    ///< some run was started although the check of the screen's timing refused
};

/// One start of the program for a session.
struct Run {
  int source = 0;
  std::string subject;
  int session = 1;
  int number = 1;         ///< of the session
  std::string station{};  ///< name of the computer; empty where tables do not hold it
  bool forced = false;    ///< started although the check of the screen's timing refused
  bool simulated = false;
  std::string environment{};  ///< JSON, of which run_screen.h reads the screen
  std::string timingCheck{};  ///< JSON
};

/// The answer of a subject to whether it takes part.
struct Consent {
  int source = 0;
  std::string subject;
  int session = 1;
  bool agreed = false;
};

/// The answer that counts to a question of a form.
struct FormAnswer {
  int source = 0;
  int64_t answerId = 0;  ///< `answer_id` of databases, `row_id` of tables
  std::string subject;
  int session = 1;
  std::string form;
  std::string field;
  std::string answer;
  bool simulated = false;
};

/// An attempt at a trial that does not count.
struct OtherAttempt {
  enum class Why : uint8_t { kPractice, kRedone, kAborted, kNotEnded, kRepeated };

  int source = 0;
  int64_t trialId = 0;
  std::string subject;
  int session = 1;
  int blockIndex = 0;
  std::string block;
  bool simulated = false;
  Why why = Why::kPractice;
  std::optional<bool> correct{};
  std::string view{};  ///< its name, as it is stored
};

/// "practice", "redone by the experimenter", ...
const char* describe(OtherAttempt::Why why);
/// By the columns of a row that does not count.
OtherAttempt::Why whyNotCounted(bool practice, std::optional<TrialEnding> ending);

/// A row that counts in its file but is not in the data.
struct LeftOutRow {
  enum class Table : uint8_t { kTrial, kAnswer };

  int source = 0;
  Table table = Table::kTrial;
  int64_t id = 0;  ///< `trial_id` or FormAnswer::answerId
  std::string subject;
  int session = 1;
  std::string why;  ///< a whole clause: "the same row stands in a.db"
};

struct Dataset {
  std::vector<DataSource> sources;
  ViewConditions conditions = defaultConditions();
  std::vector<Subject> subjects;  ///< each id once
  std::vector<Session> sessions;
  std::vector<Consent> consents;
  bool consentIsKnown = true;    ///< false where some source is a table, which do not tell
  bool endingsAreKnown = true;   ///< of sessions; false where some source is a table of another tool
  bool timeoutsAreKnown = true;  ///< false where nothing tells which trials a limit cut off
  std::vector<FormAnswer> answers;
  std::vector<Trial> trials;
  std::vector<OtherAttempt> otherAttempts;
  std::vector<LeftOutRow> leftOut;
  std::vector<std::string> notes;  ///< what a reader must be told: whole sentences
  std::vector<Run> runs{};
  std::vector<std::string> tableFacts{};  ///< how tables of other tools were read, and what they cannot tell: sentences

  /// Some row is of a simulated subject: every result must say so.
  bool isSimulated() const;
  /// Every source says whether its subjects are people or simulated.
  bool subjectsAreKnown() const;
  /// Of the subject; nullptr where there is none.
  const Subject* findSubject(const std::string& id) const;
};

/// SHA-256, as 64 hexadecimal digits, of all that counts: trials, answers, how sessions ended and who the subjects are.
/// One value changed in one row gives another; the order of rows and files does not matter, and a CSV export has the
/// same as its database. Not in it: numbers of rows and runs, and what exports do not hold (consent, planned lengths).
std::string dataHash(const Dataset& data);

/// A database, which holds its protocol, is read by readDatabase(), a folder by readCsvExport().
Dataset readSource(const std::string& path, const std::string& protocolFile = "");

}  // namespace ocelli
