// Which session of which subject is to run: looked for before anything is made or opened.
#pragma once

#include <optional>
#include <string>

#include "study/screen/study_run.h"
#include "study/store/resume.h"
#include "study/store/study_database.h"

namespace ocelli {

struct SessionPlan {
  StoredSubject subject;  ///< of a new one: not known yet
  bool isNewSubject = false;
  SessionToRun session;
};

/// `database` is null where there is none yet. Throws InputError for what is no id, an id that is taken, a session that
/// is not the next one, and a simulated subject.
SessionPlan planNewSession(const StudyDatabase* database, const Protocol& protocol, const StudyRunOptions& options);

/// Throws InputError likewise, and where this program would put the trials into another order than the one that is
/// stored.
SessionPlan planResumedSession(const StudyDatabase& database, const Protocol& protocol, const StudyRunOptions& options);

/// What is different from the screen of the subject's first trial: "1920x1200 at 60 Hz before, 1280x800 at 60 Hz now".
/// `tolerance` is that of rates (TimingLimits).
std::optional<std::string> screenChange(const StudyDatabase& database, const std::string& subject,
                                        const TrialScreen& now, double tolerance);

}  // namespace ocelli
