#include "study/screen/session_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oc_core/base/error.h"
#include "study/protocol/schedule.h"
#include "study/session/trial_rows.h"
#include "study/session/utc_time.h"

namespace ocelli {
namespace {

void requirePerson(const StoredSubject& subject, const std::string& where) {
  if (subject.kind != SubjectKind::kPerson) {
    throw InputError(fmt::format("this subject is simulated ({})", nameOf(subject.kind)), where,
                     "take another id for a person; simulated subjects go on by: ocelli study simulate");
  }
}

void requireSameSchedule(const StudyDatabase& database, const Protocol& protocol, const SessionPlan& plan) {
  const SessionSchedule schedule = scheduleOf(protocol, plan.subject.slot, plan.session.session, plan.session.seed);
  const std::optional<StoredSession> stored = database.session(plan.subject.id, plan.session.session);
  if (stored && stored->scheduleJson != jsonText(schedule, protocol.conditions.names)) {
    const std::vector<StoredRun> runs = database.runs(plan.subject.id, plan.session.session);
    throw InputError("this program puts the trials into another order than the one in which the session began",
                     fmt::format("session {} of {}", plan.session.session, plan.subject.id),
                     fmt::format("go on with the version of the program that began it{}",
                                 runs.empty() ? "" : ": " + runs.front().record.programVersion));
  }
}

std::string textOf(const TrialScreen& screen) {
  return fmt::format("{}x{} at {:g} Hz", screen.width, screen.height, screen.refreshHertz);
}

}  // namespace

SessionPlan planNewSession(const StudyDatabase* database, const Protocol& protocol, const StudyRunOptions& options) {
  if (!isSubjectId(options.subject)) {
    throw InputError("that is no id of a subject", "--subject \"" + options.subject + "\"",
                     "use 1 to 64 letters, digits, - and _, the first a letter or digit, and no name of a person");
  }
  const std::string where = "--subject " + options.subject;
  const std::optional<StoredSubject> known = database != nullptr ? database->subject(options.subject) : std::nullopt;
  if (!known) {
    if (options.session.value_or(1) != 1) {
      throw InputError(fmt::format("this subject is new, and cannot begin with session {}", *options.session), where,
                       "leave --session out, or check the id");
    }
    SessionPlan plan;
    plan.isNewSubject = true;
    plan.session.seed = options.seed.value_or(protocol.seed);
    return plan;
  }
  requirePerson(*known, where);
  if (!options.session) {
    throw InputError("this id is taken", where,
                     "choose another one for a new subject; for the next session of this one add --session 2 (or 3, "
                     "...), and for one that was broken off: ocelli study resume");
  }
  SessionPlan plan{*known, false, sessionToRun(*database, protocol, options.subject, utcNow(), options.anyTime)};
  if (plan.session.begunBefore) {
    throw InputError(fmt::format("session {} of this subject was begun and not completed", plan.session.session), where,
                     "go on with it: ocelli study resume");
  }
  if (plan.session.session != *options.session) {
    throw InputError(fmt::format("the next session of this subject is {}", plan.session.session),
                     fmt::format("--session {}", *options.session),
                     fmt::format("give --session {}, or check the id", plan.session.session));
  }
  plan.session.seed = options.seed.value_or(plan.session.seed);
  return plan;
}

SessionPlan planResumedSession(const StudyDatabase& database, const Protocol& protocol,
                               const StudyRunOptions& options) {
  const std::optional<StoredSubject> known = database.subject(options.subject);
  if (!known) {
    throw InputError("there is no such subject in " + database.path().string(), "--subject " + options.subject,
                     "check the id; a new subject begins with: ocelli study run");
  }
  requirePerson(*known, "--subject " + options.subject);
  SessionPlan plan{*known, false, sessionToRun(database, protocol, options.subject, utcNow(), options.anyTime)};
  if (plan.session.begunBefore) {
    requireSameSchedule(database, protocol, plan);
    for (const TrialRow& trial : database.trials(options.subject, plan.session.session)) {
      if (trial.practice) {
        plan.session.done.practiceBegun.push_back(recordOf(trial).plan);
      }
    }
  }
  return plan;
}

std::optional<std::string> screenChange(const StudyDatabase& database, const std::string& subject,
                                        const TrialScreen& now, double tolerance) {
  const std::vector<TrialRow> trials = database.trials(subject);
  const auto first =
      std::find_if(trials.begin(), trials.end(), [](const TrialRow& trial) { return trial.ending.has_value(); });
  if (first == trials.end()) {
    return std::nullopt;
  }
  const TrialScreen before = recordOf(*first).screen;
  const bool same = before.width == now.width && before.height == now.height &&
                    std::abs(before.refreshHertz - now.refreshHertz) <= tolerance * before.refreshHertz;
  return same ? std::nullopt : std::optional(fmt::format("{} before, {} now", textOf(before), textOf(now)));
}

}  // namespace ocelli
