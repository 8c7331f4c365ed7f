// What a database of a study tells, row by row. Trials are TrialRow (study/trial/trial_row.h).
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
  int session = 1;  ///< from 1
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

struct StoredAnswer {
  int session = 1;  ///< from 1
  AnswerRecord record;
};

struct StoredConsent {
  int session = 1;  ///< from 1
  ConsentRecord record;
};

struct StoredEvent {
  int64_t run = 0;
  int session = 1;  ///< from 1
  EventRecord record;
};

struct AuditEntry {
  std::string utc;
  std::string action;
  std::string detailJson;
};

}  // namespace ocelli
