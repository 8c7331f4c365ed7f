// Which session of a subject comes next, and what of it is done already.
#pragma once

#include <optional>
#include <string>

#include "study/session/session_flow.h"
#include "study/store/study_database.h"

namespace ocelli {

struct SessionToRun {
  int session = 1;           ///< from 1
  bool begunBefore = false;  ///< it is resumed
  uint64_t seed = 1;         ///< of its schedule: as stored, or the protocol's own choice where it is new
  SessionDone done;
};

/// What is stored of a session. A form counts as answered once all of its fields are. What the protocol's policy makes
/// of it is up to SessionFlow.
SessionDone sessionDone(const StudyDatabase& database, const Protocol& protocol, const std::string& subject,
                        int session);

/// The session that was begun and not completed, or else the next one. `nowUtc` is for the time between sessions;
/// `anyTime` ignores that. Throws InputError where there is no such
/// subject, where all sessions are done, where it is too early, and where the protocol does not allow to resume.
SessionToRun sessionToRun(const StudyDatabase& database, const Protocol& protocol, const std::string& subject,
                          const std::string& nowUtc, bool anyTime = false);

}  // namespace ocelli
