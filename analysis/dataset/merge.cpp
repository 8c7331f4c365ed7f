#include "analysis/dataset/merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "analysis/dataset/withdrawn_subjects.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr const char* kMergeFirst = "the newest copy alone; or `ocelli study merge`, which brings copies together";

[[noreturn]] void refuse(const std::string& what, const std::string& first, const std::string& second,
                         const std::string& next) {
  throw InputError(what, fmt::format("{} and {}", first, second), next);
}

void checkProtocols(const std::vector<DataSource>& sources) {
  for (const DataSource& source : sources) {
    const DataSource& first = sources.front();
    if (source.protocolSha256.empty() != first.protocolSha256.empty()) {
      const DataSource& unknown = source.protocolSha256.empty() ? source : first;
      refuse(
          fmt::format("the tables in {} came without their protocol, so it is not known whether both are of one study",
                      unknown.path),
          first.path, source.path, "--protocol FILE, which gives it; or --other-protocols");
    }
    if (source.protocolSha256 != first.protocolSha256) {
      refuse(fmt::format("these are of different protocols: \"{}\" with SHA-256 {}... and \"{}\" with {}...",
                         first.protocolName, first.protocolSha256.substr(0, 12), source.protocolName,
                         source.protocolSha256.substr(0, 12)),
             first.path, source.path, "analyse them apart; or --other-protocols");
    }
  }
}

bool isSame(const Subject& a, const Subject& b) {
  const bool keysAgree = a.key.empty() || b.key.empty() || a.key == b.key;
  return keysAgree && a.kind == b.kind && a.slot == b.slot && a.createdUtc == b.createdUtc;
}

class Merging {
 public:
  explicit Merging(std::vector<Dataset> parts) : parts_(std::move(parts)) {}

  Dataset all(const DatasetMergeOptions& options) {
    size_t trials = 0;
    removeWithdrawn(parts_);
    for (Dataset& part : parts_) {
      shiftSources(part, static_cast<int>(merged_.sources.size()));
      std::move(part.sources.begin(), part.sources.end(), std::back_inserter(merged_.sources));
      trials += part.trials.size();
    }
    if (!options.allowOtherProtocols) {
      checkProtocols(merged_.sources);
    }
    takeConditions();
    merged_.trials.reserve(trials);
    for (Dataset& part : parts_) {
      add(std::move(part));
    }
    if (repeatedTrials_ > 0) {
      merged_.notes.push_back(fmt::format("{} trials stand in several sources and were taken once.", repeatedTrials_));
    }
    choose(options.simulated);
    return std::move(merged_);
  }

 private:
  static void shiftSources(Dataset& part, int by) {
    const auto shift = [&](auto& rows) {
      for (auto& row : rows) {
        row.source += by;
      }
    };
    shift(part.subjects);
    shift(part.sessions);
    shift(part.consents);
    shift(part.answers);
    shift(part.trials);
    shift(part.otherAttempts);
    shift(part.leftOut);
    shift(part.runs);
  }
  const std::string& pathOf(int source) const { return merged_.sources[static_cast<size_t>(source)].path; }

  void takeConditions();
  void add(Dataset part);
  void addSubjects(Dataset& part);
  void addSessions(Dataset& part);
  void addTrials(Dataset& part);
  void addAnswers(Dataset& part);
  void choose(SimulatedRows rows);

  using SessionKey = std::pair<std::string, int>;

  std::vector<Dataset> parts_;
  Dataset merged_{};
  std::map<std::string, size_t> subjects_{};
  std::map<SessionKey, size_t> sessions_{};
  std::map<std::tuple<std::string, int, int>, size_t> trials_{};
  std::map<std::tuple<std::string, int, std::string, std::string>, size_t> answers_{};
  std::set<SessionKey> repeatedSessions_{};  ///< of the part that is added
  int64_t repeatedTrials_ = 0;
};

/// Labels are those of the first source.
void Merging::takeConditions() {
  merged_.conditions = parts_.front().conditions;
  size_t source = 0;
  for (const Dataset& part : parts_) {
    if (!part.conditions.hasNamesOf(merged_.conditions)) {
      const char* with = merged_.conditions.isPair() && part.conditions.isPair() ? "with" : "and";
      refuse(fmt::format("these compare different view conditions: {}, and {}", merged_.conditions.namesText(with),
                         part.conditions.namesText(with)),
             merged_.sources.front().path, merged_.sources[source].path, "analyse them apart");
    }
    source += part.sources.size();
  }
}

void Merging::addSubjects(Dataset& part) {
  for (Subject& subject : part.subjects) {
    const auto [at, isNew] = subjects_.try_emplace(subject.id, merged_.subjects.size());
    if (isNew) {
      merged_.subjects.push_back(std::move(subject));
    } else if (Subject& known = merged_.subjects[at->second]; !isSame(known, subject)) {
      refuse(fmt::format("subject \"{}\" stands for different people", subject.id), pathOf(known.source),
             pathOf(subject.source), "analyse them apart, or give one of them another id before merging");
    } else if (known.key.empty()) {
      known.key = subject.key;
    }
  }
}

void Merging::addSessions(Dataset& part) {
  repeatedSessions_.clear();
  for (Session& session : part.sessions) {
    const auto [at, isNew] = sessions_.try_emplace({session.subject, session.number}, merged_.sessions.size());
    if (isNew) {
      merged_.sessions.push_back(std::move(session));
      continue;
    }
    repeatedSessions_.insert(at->first);
    Session& known = merged_.sessions[at->second];
    if (known.ending != session.ending || known.completedTrials != session.completedTrials ||
        known.runs != session.runs || known.forced != session.forced) {
      refuse(fmt::format("session {} of subject \"{}\" is different", session.number, session.subject),
             pathOf(known.source), pathOf(session.source), kMergeFirst);
    }
    if (!known.plannedTrials) {
      known.plannedTrials = session.plannedTrials;
    }
  }
}

void Merging::addTrials(Dataset& part) {
  for (Trial& trial : part.trials) {
    const auto [at, isNew] =
        trials_.try_emplace({trial.subject, trial.session, trial.planIndex}, merged_.trials.size());
    if (isNew) {
      merged_.trials.push_back(std::move(trial));
      continue;
    }
    const Trial& known = merged_.trials[at->second];
    if (known.digest != trial.digest) {
      refuse(fmt::format("trial {} of session {} of subject \"{}\" (trial_id {} and {}) is different", trial.planIndex,
                         trial.session, trial.subject, known.trialId, trial.trialId),
             pathOf(known.source), pathOf(trial.source), kMergeFirst);
    }
    ++repeatedTrials_;
    merged_.leftOut.push_back({trial.source, LeftOutRow::Table::kTrial, trial.trialId, trial.subject, trial.session,
                               fmt::format("the same row stands in {}", pathOf(known.source))});
  }
}

void Merging::addAnswers(Dataset& part) {
  for (FormAnswer& answer : part.answers) {
    const auto [at, isNew] =
        answers_.try_emplace({answer.subject, answer.session, answer.form, answer.field}, merged_.answers.size());
    if (isNew) {
      merged_.answers.push_back(std::move(answer));
      continue;
    }
    const FormAnswer& known = merged_.answers[at->second];
    if (known.answer != answer.answer) {
      refuse(fmt::format("subject \"{}\" gave different answers to \"{}\" in session {}", answer.subject, answer.field,
                         answer.session),
             pathOf(known.source), pathOf(answer.source), kMergeFirst);
    }
    merged_.leftOut.push_back({answer.source, LeftOutRow::Table::kAnswer, answer.answerId, answer.subject,
                               answer.session, fmt::format("the same row stands in {}", pathOf(known.source))});
  }
}

void Merging::add(Dataset part) {
  addSubjects(part);
  addSessions(part);
  addTrials(part);
  addAnswers(part);
  // Consent and attempts that do not count: those of sessions that no earlier part holds.
  const auto isNew = [&](const auto& row) { return !repeatedSessions_.contains({row.subject, row.session}); };
  std::copy_if(part.consents.begin(), part.consents.end(), std::back_inserter(merged_.consents), isNew);
  std::copy_if(part.otherAttempts.begin(), part.otherAttempts.end(), std::back_inserter(merged_.otherAttempts), isNew);
  std::copy_if(part.runs.begin(), part.runs.end(), std::back_inserter(merged_.runs), isNew);
  std::move(part.leftOut.begin(), part.leftOut.end(), std::back_inserter(merged_.leftOut));
  std::move(part.notes.begin(), part.notes.end(), std::back_inserter(merged_.notes));
  std::move(part.tableFacts.begin(), part.tableFacts.end(), std::back_inserter(merged_.tableFacts));
  merged_.consentIsKnown = merged_.consentIsKnown && part.consentIsKnown;
  merged_.endingsAreKnown = merged_.endingsAreKnown && part.endingsAreKnown;
  merged_.timeoutsAreKnown = merged_.timeoutsAreKnown && part.timeoutsAreKnown;
}

void Merging::choose(SimulatedRows rows) {
  const auto isSimulated = [](const Subject& subject) { return subject.simulated; };
  const auto simulated = std::count_if(merged_.subjects.begin(), merged_.subjects.end(), isSimulated);
  const auto people = static_cast<std::ptrdiff_t>(merged_.subjects.size()) - simulated;
  const bool dropsSimulated = rows == SimulatedRows::kUnlessThereArePeople && people > 0 && simulated > 0;
  const bool dropsPeople = rows == SimulatedRows::kOnly && people > 0;
  if (rows == SimulatedRows::kOnly && !merged_.subjectsAreKnown()) {
    throw InputError("it is not known whether these subjects are people or simulated", merged_.sources.front().path,
                     "\"subjects\" in the map of columns, which says it");
  }
  if (!dropsSimulated && !dropsPeople) {
    if (simulated > 0) {
      merged_.notes.push_back(people > 0
                                  ? fmt::format("{} of the {} subjects are simulated: no result is one of people.",
                                                simulated, people + simulated)
                                  : std::string("All subjects are simulated: no result is one of people."));
    }
    return;
  }
  const char* why = dropsSimulated ? "of a simulated subject, and there are people"
                                   : "of a person, and simulated subjects were asked for";
  const auto goes = [&](const auto& row) { return row.simulated == dropsSimulated; };
  for (const Trial& trial : merged_.trials) {
    if (goes(trial)) {
      merged_.leftOut.push_back(
          {trial.source, LeftOutRow::Table::kTrial, trial.trialId, trial.subject, trial.session, why});
    }
  }
  for (const FormAnswer& answer : merged_.answers) {
    if (goes(answer)) {
      merged_.leftOut.push_back(
          {answer.source, LeftOutRow::Table::kAnswer, answer.answerId, answer.subject, answer.session, why});
    }
  }
  std::set<std::string> gone;
  for (const Subject& subject : merged_.subjects) {
    if (goes(subject)) {
      gone.insert(subject.id);
    }
  }
  const size_t trials = merged_.trials.size();
  std::erase_if(merged_.trials, goes);
  std::erase_if(merged_.answers, goes);
  std::erase_if(merged_.sessions, goes);
  std::erase_if(merged_.subjects, goes);
  std::erase_if(merged_.otherAttempts, goes);
  std::erase_if(merged_.runs, goes);
  std::erase_if(merged_.consents, [&](const Consent& consent) { return gone.contains(consent.subject); });
  merged_.notes.push_back(fmt::format(
      "{} with {} trials were left out: {}.",
      dropsSimulated ? fmt::format("{} simulated subjects", simulated) : fmt::format("{} people", people),
      trials - merged_.trials.size(), dropsSimulated ? "there are people" : "simulated subjects were asked for"));
  if (dropsPeople) {
    merged_.notes.emplace_back("All subjects are simulated: no result is one of people.");
  }
}

}  // namespace

Dataset merge(std::vector<Dataset> parts, const DatasetMergeOptions& options) {
  if (parts.empty()) {
    throw InputError("there is nothing to analyse", "the command", "the name of a database");
  }
  return Merging(std::move(parts)).all(options);
}

}  // namespace ocelli
