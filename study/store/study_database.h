// The database of a study: one SQLite file that holds the protocol and everything that subjects did
// (protocols/trials.schema.sql, docs/study_data.md). TrialStore (trial_store.h) writes what happens in a session.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "study/protocol/schedule.h"
#include "study/store/stored_rows.h"
#include "study/trial/trial_row.h"

namespace ocelli {

struct DatabaseOptions {
  /// Space that the disk must have before sessions may run: a session takes about 30 MB, and its log as much again.
  uint64_t minFreeBytes = 256u << 20;
};

class StudyDatabase {
 public:
  /// For sessions of `protocol`: makes the file where there is none, holds its lock (database_lock.h) and tries a
  /// write. Throws InputError where the file is of another protocol, of a newer version or no database; WorkError where
  /// another program runs sessions on it, where it cannot be written, or where the disk is nearly full.
  static StudyDatabase openForSessions(const std::filesystem::path& path, const Protocol& protocol,
                                       const DatabaseOptions& options = {});
  /// To read an existing one, which other programs may write to meanwhile.
  static StudyDatabase openForReading(const std::filesystem::path& path);
  ~StudyDatabase();
  StudyDatabase(StudyDatabase&&) noexcept;
  StudyDatabase& operator=(StudyDatabase&&) = delete;

  const std::filesystem::path& path() const;
  StoredStudy study() const;

  /// A new subject, who gets the first slot from `firstSlot` on that no other subject has, people and simulated ones
  /// apart: whoever withdrew is replaced. Throws InputError for an id that is taken or is none.
  StoredSubject addSubject(const std::string& id, SubjectKind kind, int firstSlot = 0);

  std::vector<StoredSubject> subjects() const;
  std::optional<StoredSubject> subject(const std::string& id) const;
  std::vector<StoredSession> sessions() const;
  std::vector<StoredSession> sessions(const std::string& subject) const;
  std::optional<StoredSession> session(const std::string& subject, int session) const;
  std::vector<StoredRun> runs(const std::string& subject, int session) const;
  /// In the order in which they began, practice and attempts that do not count included.
  std::vector<TrialRow> trials() const;
  std::vector<TrialRow> trials(const std::string& subject) const;
  std::vector<TrialRow> trials(const std::string& subject, int session) const;
  /// Throws InputError where there is no such trial.
  TrialRow trial(int64_t id) const;
  std::vector<FrameRecord> frames(int64_t trial) const;
  std::vector<InputRecord> inputs(int64_t trial) const;
  std::vector<GazeRecord> gaze(int64_t trial) const;
  std::vector<StoredAnswer> answers(const std::string& subject) const;
  std::vector<StoredConsent> consents(const std::string& subject) const;
  std::vector<StoredEvent> events(const std::string& subject) const;
  std::vector<AuditEntry> audit() const;

 private:
  struct State;
  explicit StudyDatabase(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Whether that can be the id of a subject: 1 to 64 letters (ASCII), digits, - and _, the first a letter or digit.
bool isSubjectId(const std::string& id);

}  // namespace ocelli
