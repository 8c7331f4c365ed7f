#include "study/store/resume.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "oc_core/base/error.h"
#include "study/store/utc_time.h"

namespace ocelli {
namespace {

bool isAnswered(const ProtocolForm& form, const std::vector<StoredAnswer>& answers, int session) {
  return std::all_of(form.fields.begin(), form.fields.end(), [&](const FormField& field) {
    return std::any_of(answers.begin(), answers.end(), [&](const StoredAnswer& answer) {
      return answer.session == session && answer.record.form == form.name && answer.record.field == field.name;
    });
  });
}

/// The criterion was met, or the block's own trials have begun, so that the experimenter let the subject go on.
std::vector<int> blocksPracticed(const Protocol& protocol, const std::vector<StoredTrial>& trials) {
  std::map<int, int> correctInARow;
  std::set<int> practiced;
  for (const StoredTrial& trial : trials) {
    const TrialPlan& plan = trial.record.plan;
    if (!plan.practice) {
      practiced.insert(plan.block);
    } else if (trial.ended && trial.record.ending == TrialEnding::kCompleted &&
               plan.block < static_cast<int>(protocol.blocks.size())) {
      int& row = correctInARow[plan.block];
      row = trial.record.outcome.correct ? row + 1 : 0;
      const auto& practice = protocol.blocks[static_cast<size_t>(plan.block)].practice;
      if (practice && row >= practice->leastCorrect) {
        practiced.insert(plan.block);
      }
    }
  }
  return {practiced.begin(), practiced.end()};
}

/// Plans of the session that were completed, without those of blocks that begin anew.
std::vector<int> completedTrials(const StudyDatabase& database, const Protocol& protocol, const std::string& subject,
                                 const StoredSession& session, const std::vector<StoredTrial>& trials) {
  std::set<int> completed;
  for (const StoredTrial& trial : trials) {
    if (!trial.record.plan.practice && trial.ended && trial.record.ending == TrialEnding::kCompleted) {
      completed.insert(trial.record.plan.index);
    }
  }
  if (protocol.resume == ResumePolicy::kRestartBlock) {
    const int slot = database.subject(subject)->slot;
    std::set<int> openBlocks;
    const SessionSchedule schedule = scheduleOf(protocol, slot, session.session, session.seed);
    for (const TrialPlan& plan : schedule.trials) {
      if (!completed.contains(plan.index)) {
        openBlocks.insert(plan.block);
      }
    }
    for (const TrialPlan& plan : schedule.trials) {
      if (openBlocks.contains(plan.block)) {
        completed.erase(plan.index);
      }
    }
  }
  return {completed.begin(), completed.end()};
}

int64_t minutesSince(const std::string& earlier, const std::string& later) {
  const std::optional<int64_t> from = millisecondsOfUtc(earlier);
  const std::optional<int64_t> to = millisecondsOfUtc(later);
  return from && to ? (*to - *from) / 60'000 : std::numeric_limits<int64_t>::max();
}

}  // namespace

SessionDone sessionDone(const StudyDatabase& database, const Protocol& protocol, const std::string& subject,
                        int session) {
  SessionDone done;
  const std::optional<StoredSession> stored = database.session(subject, session);
  if (!stored) {
    return done;
  }
  const std::vector<StoredTrial> trials = database.trials(subject, session);
  done.attempts.assign(static_cast<size_t>(stored->plannedTrials), 0);
  for (const StoredTrial& trial : trials) {
    const int plan = trial.record.plan.index;
    if (plan >= 0 && plan < stored->plannedTrials) {
      // What counts is the highest number so far: numbers must never come twice.
      int& attempts = done.attempts[static_cast<size_t>(plan)];
      attempts = std::max(attempts, trial.record.attempt);
    }
  }
  done.completedTrials = completedTrials(database, protocol, subject, *stored, trials);
  done.blocksPracticed = blocksPracticed(protocol, trials);
  for (const StoredConsent& consent : database.consents(subject)) {
    if (consent.session == session) {
      done.consented = consent.record.agreed;
    }
  }
  const std::vector<StoredAnswer> answers = database.answers(subject);
  for (const std::optional<ProtocolForm>* form : {&protocol.demographics, &protocol.survey}) {
    if (*form && isAnswered(**form, answers, session)) {
      done.forms.push_back((*form)->name);
    }
  }
  return done;
}

SessionToRun sessionToRun(const StudyDatabase& database, const Protocol& protocol, const std::string& subject,
                          uint64_t newSeed, const std::string& nowUtc, bool anyTime) {
  if (!database.subject(subject)) {
    throw InputError("this database has no such subject", subject,
                     "`ocelli study subjects` lists them; `ocelli study run` begins with a new one");
  }
  const std::vector<StoredSession> sessions = database.sessions(subject);
  if (!sessions.empty() && sessions.back().ending != SessionEnding::kCompleted) {
    const StoredSession& last = sessions.back();
    const bool trialsBegan = !database.trials(subject, last.session).empty();
    if (protocol.resume == ResumePolicy::kStop && trialsBegan) {
      throw InputError(fmt::format("session {} of this subject was interrupted, and the protocol says that such "
                                   "sessions are not resumed (\"resume\": \"stop\")",
                                   last.session + 1),
                       subject, "another subject");
    }
    return {last.session, true, last.seed, sessionDone(database, protocol, subject, last.session)};
  }
  const int next = sessions.empty() ? 0 : sessions.back().session + 1;
  if (next >= protocol.sessions) {
    throw InputError(fmt::format("this subject has done all {} sessions", protocol.sessions), subject,
                     "another subject");
  }
  if (!sessions.empty() && !anyTime) {
    const int64_t passed = minutesSince(sessions.back().endedUtc, nowUtc);
    if (passed < protocol.minutesBetweenSessions) {
      throw InputError(
          fmt::format("the last session of this subject ended {} minutes ago, and the protocol asks for {} "
                      "between sessions",
                      passed, protocol.minutesBetweenSessions),
          subject, "come back later");
    }
  }
  return {next, false, newSeed, {}};
}

}  // namespace ocelli
