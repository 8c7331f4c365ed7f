#include "study/store/resume.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <set>

#include "oc_core/base/error.h"
#include "study/outline/question_kinds.h"

namespace ocelli {
namespace {

bool isAnswered(const ProtocolForm& form, const std::vector<StoredAnswer>& answers, int session) {
  const std::vector<QuestionItem> items = itemsOf(form.fields);
  return std::all_of(items.begin(), items.end(), [&](const QuestionItem& item) {
    return std::any_of(answers.begin(), answers.end(), [&](const StoredAnswer& answer) {
      return answer.session == session && answer.record.form == form.name && answer.record.field == item.name;
    });
  });
}

/// The practice of a block is over: the criterion was met, or the experimenter let the subject go on.
std::vector<int> blocksPracticed(const StudyDatabase& database, const Protocol& protocol, const std::string& subject,
                                 int session) {
  std::vector<int> practiced;
  for (const StoredEvent& event : database.events(subject)) {
    const EventRecord& record = event.record;
    if (event.session == session && (record.what == "practice_passed" || record.what == "practice_continued")) {
      for (int block = 0; block < static_cast<int>(protocol.blocks.size()); ++block) {
        if (record.detail == std::to_string(block)) {
          practiced.push_back(block);
        }
      }
    }
  }
  return practiced;
}

/// Nothing for what is no time as records have it.
std::optional<std::chrono::sys_seconds> timeOf(const std::string& utc) {
  using namespace std::chrono;
  int y = 0;
  unsigned mo = 0;
  unsigned d = 0;
  int h = 0;
  int mi = 0;
  int s = 0;
  if (std::sscanf(utc.c_str(), "%4d-%2u-%2uT%2d:%2d:%2d", &y, &mo, &d, &h, &mi, &s) != 6) {
    return std::nullopt;
  }
  const year_month_day date{year{y}, month{mo}, day{d}};
  return date.ok() ? std::optional(sys_days{date} + hours{h} + minutes{mi} + seconds{s}) : std::nullopt;
}

/// Nothing where one of the times is not known.
std::optional<int64_t> minutesFromTo(const std::string& earlier, const std::string& later) {
  const auto from = timeOf(earlier);
  const auto to = timeOf(later);
  return from && to ? std::optional<int64_t>(std::chrono::floor<std::chrono::minutes>(*to - *from).count())
                    : std::nullopt;
}

}  // namespace

SessionDone sessionDone(const StudyDatabase& database, const Protocol& protocol, const std::string& subject,
                        int session) {
  SessionDone done;
  const std::optional<StoredSession> stored = database.session(subject, session);
  if (!stored) {
    return done;
  }
  done.attempts.assign(static_cast<size_t>(stored->plannedTrials), 0);
  std::set<int> completed;
  for (const TrialRow& trial : database.trials(subject, session)) {
    const int plan = trial.planIndex;
    if (trial.practice || plan < 0 || plan >= stored->plannedTrials) {
      continue;
    }
    int& attempts = done.attempts[static_cast<size_t>(plan)];
    attempts = std::max(attempts, trial.attempt);
    if (trial.ending == TrialEnding::kCompleted) {
      completed.insert(plan);
      // In the order of the runs: of a trial that was done again the last one counts.
      done.answered[plan] = {trial.blockIndex, trial.view, trial.caseIndex, trial.correct.value_or(false)};
    }
  }
  done.completedTrials.assign(completed.begin(), completed.end());
  done.blocksPracticed = blocksPracticed(database, protocol, subject, session);
  for (const StoredConsent& consent : database.consents(subject)) {
    if (consent.session == session) {
      done.consented = consent.record.agreed;
    }
  }
  const std::vector<StoredAnswer> answers = database.answers(subject);
  for (const ProtocolForm* form : formsOf(protocol)) {
    if (isAnswered(*form, answers, session)) {
      done.forms.push_back(form->name);
    }
  }
  return done;
}

SessionToRun sessionToRun(const StudyDatabase& database, const Protocol& protocol, const std::string& subject,
                          const std::string& nowUtc, bool anyTime) {
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
                                   last.session),
                       subject, "another subject");
    }
    return {last.session, true, last.seed, sessionDone(database, protocol, subject, last.session)};
  }
  const int next = sessions.empty() ? 1 : sessions.back().session + 1;
  if (next > protocol.sessions) {
    throw InputError(fmt::format("this subject has done all {} sessions", protocol.sessions), subject,
                     "another subject");
  }
  if (!sessions.empty() && !anyTime) {
    const std::optional<int64_t> passed = minutesFromTo(sessions.back().endedUtc, nowUtc);
    if (passed && *passed < protocol.minutesBetweenSessions) {
      throw InputError(
          fmt::format("the last session of this subject ended {} minutes ago, and the protocol asks for {} "
                      "between sessions",
                      *passed, protocol.minutesBetweenSessions),
          subject, "come back later");
    }
  }
  return {next, false, protocol.seed, {}};
}

}  // namespace ocelli
