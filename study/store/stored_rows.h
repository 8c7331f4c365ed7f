// What a database of a study tells, row by row. Sessions count from 0 here, as in protocols; in the file from 1.
#pragma once

#include <optional>
#include <string>

#include "study/session/records.h"

namespace ocelli {

struct StoredStudy {
  std::string protocolName;
  std::string protocolSha256;
  std::string protocolText;
  std::string programVersion;
  std::string createdUtc;
};

struct StoredSubject {
  std::string id;
  SubjectKind kind = SubjectKind::kPerson;
  int slot = 0;
  std::string createdUtc;
};

struct StoredSession {
  std::string subject;
  int session = 0;  ///< from 0
  std::string scheduleJson;
  uint64_t seed = 1;
  std::string startedUtc;
  int plannedTrials = 0;
  int completedTrials = 0;
  int runs = 0;
  /// Of the last run; nothing where that was killed, or still runs.
  std::optional<SessionEnding> ending{};
  std::string endedUtc{};
};

struct StoredRun {
  int64_t id = 0;
  RunRecord record;
  std::optional<SessionEnding> ending{};
  std::string endedUtc{};
};

struct StoredTrial {
  int64_t id = 0;
  int64_t run = 0;
  int number = 0;  ///< among those that the run began
  std::string subject;
  int session = 0;  ///< from 0
  SubjectKind kind = SubjectKind::kPerson;
  std::string block;
  /// It ended; otherwise the program was killed, or it still runs, and of `record` only plan and attempt are known.
  bool ended = false;
  TrialRecord record;
};

struct StoredAnswer {
  int session = 0;  ///< from 0
  AnswerRecord record;
};

struct StoredConsent {
  int session = 0;  ///< from 0
  ConsentRecord record;
};

struct StoredEvent {
  int64_t run = 0;
  int session = 0;  ///< from 0
  EventRecord record;
};

struct AuditEntry {
  std::string utc;
  std::string action;
  std::string detailJson;
};

}  // namespace ocelli
