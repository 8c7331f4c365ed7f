#include "analysis/dataset/exclusions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <string_view>
#include <tuple>

#include "analysis/dataset/protocol_facts.h"
#include "oc_core/base/csv.h"
#include "oc_core/base/error.h"
#include "study/trial/trial_check.h"

namespace ocelli {
namespace {

template <class Word, size_t kCount>
std::string problemOfChoice(const std::string& given, const std::array<Word, kCount>& words) {
  return wordNamed(given, words)
             ? ""
             : fmt::format("has the value \"{}\", but it must be one of: {}", given, namesOf(words));
}

/// Empty for what has no such word.
template <class Word>
std::string nameOrNothing(const std::optional<Word>& word) {
  return word ? nameOf(*word) : "";
}

bool matches(const ExclusionRule& rule, const std::string& text) {
  return (rule.test == ExclusionTest::kIs) == (text == rule.text);
}

bool matches(const ExclusionRule& rule, double number) {
  return rule.test == ExclusionTest::kAtLeast ? number >= rule.number : number <= rule.number;
}

constexpr const char* kForcedSession = "forced_session";

bool excludesForced(const std::vector<ExclusionRule>& rules) {
  return std::any_of(rules.begin(), rules.end(), [](const ExclusionRule& rule) { return rule.what == kForcedSession; });
}

/// The first of them, and how many more there are.
std::string listed(const std::vector<std::string>& names, const std::string& where) {
  constexpr size_t kMaxNamed = 5;
  std::string text = fmt::format(
      "{}",
      fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(std::min(names.size(), kMaxNamed)), "; "));
  if (names.size() > kMaxNamed) {
    text += fmt::format("; and {} more{}", names.size() - kMaxNamed, where.empty() ? "" : fmt::format(" ({})", where));
  }
  return text;
}

/// What rules about subjects ask for.
struct SubjectTotals {
  std::vector<std::string> endings;
  int completed = 0;
  int64_t trials = 0;
  int64_t timeouts = 0;
  int64_t frames = 0;
  int64_t dropped = 0;
  struct Practiced {
    std::string view;
    bool right = false;
  };
  std::map<int, std::vector<Practiced>> practice;  ///< by block, in their order
};

class Excluder {
 public:
  Excluder(Dataset data, const AnalysisPlan& plan) {
    result_.plan = plan;
    result_.dataSha256 = dataHash(data);
    result_.data = std::move(data);
  }

  AnalysisData all() {
    readProtocol();
    gatherTotals();
    countBefore();
    markContradictions();
    const std::vector<ExclusionRule> rules = allRules();
    for (const ExclusionRule& rule : rules) {
      apply(rule);
    }
    warnOfForcedSessions(rules);
    remove();
    countAfter();
    return std::move(result_);
  }

 private:
  void readProtocol();
  void gatherTotals();
  void countBefore();
  void markContradictions();
  std::vector<ExclusionRule> allRules() const;
  void warnOfForcedSessions(const std::vector<ExclusionRule>& rules);
  void apply(const ExclusionRule& rule);
  void excludeSubject(const std::string& subject, const ExclusionRule& rule);
  void remove();
  void countAfter();
  bool isMet(const ExclusionRule& rule, const std::string& subject, const SubjectTotals& totals) const;
  bool missesPractice(const SubjectTotals& totals) const;

  AnalysisData result_{};
  ProtocolFacts facts_{};
  bool hasProtocol_ = false;
  std::map<std::string, SubjectTotals> totals_{};
  std::map<std::pair<std::string, std::string>, std::vector<std::string>> answers_{};  ///< by subject and field
  std::map<std::string, std::string> subjectWhy_{};
  std::map<std::pair<std::string, int>, std::string> sessionWhy_{};
  std::vector<std::string> trialWhy_{};
};

void Excluder::readProtocol() {
  const auto& sources = result_.data.sources;
  const AnalysisPlan& plan = result_.plan;
  for (const DataSource& source : sources) {
    if (!plan.protocolSha256.empty() && !source.protocolSha256.empty() &&
        plan.protocolSha256 != source.protocolSha256) {
      throw InputError(fmt::format("plan \"{}\" is for the protocol with SHA-256 {}..., and this study's is {}...",
                                   plan.name, plan.protocolSha256.substr(0, 12), source.protocolSha256.substr(0, 12)),
                       source.path, "the plan that was registered for this study");
    }
    if (!hasProtocol_ && !source.protocolText.empty()) {
      facts_ = protocolFacts(source.protocolText, fmt::format("{}, protocol", source.path));
      hasProtocol_ = true;
    }
  }
  if (!hasProtocol_ && plan.usesProtocolExclusions) {
    result_.data.notes.emplace_back("The protocol is not known, so its exclusion rules were not applied.");
  }
}

void Excluder::gatherTotals() {
  Dataset& data = result_.data;
  trialWhy_.resize(data.trials.size());
  for (const Subject& subject : data.subjects) {
    totals_[subject.id];
  }
  for (const Session& session : data.sessions) {
    SubjectTotals& totals = totals_[session.subject];
    totals.endings.push_back(nameOrNothing(session.ending));
    totals.completed += session.ending == SessionEnding::kCompleted ? 1 : 0;
  }
  for (const Trial& trial : data.trials) {
    SubjectTotals& totals = totals_[trial.subject];
    ++totals.trials;
    totals.timeouts += trial.censored.value_or(false) ? 1 : 0;
    totals.frames += trial.frames;
    totals.dropped += trial.droppedFrames;
  }
  for (const OtherAttempt& attempt : data.otherAttempts) {
    if (attempt.why == OtherAttempt::Why::kPractice) {
      totals_[attempt.subject].practice[attempt.blockIndex].push_back({attempt.view, attempt.correct.value_or(false)});
    }
  }
  for (const FormAnswer& answer : data.answers) {
    answers_[{answer.subject, answer.field}].push_back(answer.answer);
  }
}

void Excluder::countBefore() {
  const Dataset& data = result_.data;
  SubjectFlow& flow = result_.flow;
  flow.enrolled = static_cast<int>(data.subjects.size());
  flow.trials = static_cast<int64_t>(data.trials.size());
  if (!data.consentIsKnown) {
    flow.consentNote = "tables do not hold consent";
  } else if (data.consents.empty()) {
    flow.consentNote = "no consent is recorded";
  } else {
    std::map<std::string, bool> agreed;  // the last answer
    for (const Consent& consent : data.consents) {
      agreed[consent.subject] = consent.agreed;
    }
    flow.consented =
        static_cast<int>(std::count_if(agreed.begin(), agreed.end(), [](const auto& a) { return a.second; }));
  }
  for (const auto& [id, totals] : totals_) {
    flow.began += totals.trials > 0 ? 1 : 0;
    if (flow.completedSessions.size() < static_cast<size_t>(totals.completed)) {
      flow.completedSessions.resize(static_cast<size_t>(totals.completed), 0);
    }
    for (size_t k = 0; k < static_cast<size_t>(totals.completed); ++k) {
      ++flow.completedSessions[k];
    }
  }
}

void Excluder::markContradictions() {
  const Dataset& data = result_.data;
  std::vector<std::string> named;
  for (size_t i = 0; i < data.trials.size(); ++i) {
    const Trial& trial = data.trials[i];
    const auto block = std::find_if(facts_.blocks.begin(), facts_.blocks.end(),
                                    [&](const ProtocolBlockFacts& each) { return each.name == trial.block; });
    trialWhy_[i] = contradictionOf(trial, block == facts_.blocks.end() ? std::nullopt : block->limitSeconds);
    if (!trialWhy_[i].empty()) {
      named.push_back(fmt::format("trial {} of {} in {}: {}", trial.trialId, trial.subject,
                                  data.sources[static_cast<size_t>(trial.source)].path, trialWhy_[i]));
    }
  }
  if (!named.empty()) {
    result_.warnings.push_back(fmt::format("Trials that contradict themselves are left out, {} in all: {}.",
                                           named.size(), listed(named, "tables/exclusions.csv has them all")));
  }
}

std::vector<ExclusionRule> Excluder::allRules() const {
  const AnalysisPlan& plan = result_.plan;
  std::vector<ExclusionRule> rules = plan.usesProtocolExclusions ? facts_.exclusions : std::vector<ExclusionRule>();
  rules.insert(rules.end(), plan.exclusions.begin(), plan.exclusions.end());
  if (plan.excludesForcedSessions && !excludesForced(rules)) {
    ExclusionRule rule;
    rule.what = kForcedSession;
    rule.reason = "forced past a failed check of the screen's timing";
    rules.push_back(std::move(rule));
  }
  return rules;
}

void Excluder::warnOfForcedSessions(const std::vector<ExclusionRule>& rules) {
  std::vector<std::string> named;
  for (const Session& session : result_.data.sessions) {
    if (session.forced) {
      named.push_back(fmt::format("session {} of {}", session.number, session.subject));
    }
  }
  if (!named.empty()) {
    result_.warnings.push_back(fmt::format(
        "Sessions were forced past a failed check of the screen's timing, {} in all; {}: {}.", named.size(),
        excludesForced(rules) ? "they are left out" : "they are analysed, as the plan says", listed(named, "")));
  }
}

bool Excluder::missesPractice(const SubjectTotals& totals) const {
  for (const auto& [block, answers] : totals.practice) {
    const auto practice = static_cast<size_t>(block) < facts_.blocks.size()
                              ? facts_.blocks[static_cast<size_t>(block)].practice
                              : std::nullopt;
    if (!practice) {
      continue;
    }
    // Where each view is practised by itself, each has to meet the criterion.
    std::map<std::string, int> longest;
    std::map<std::string, int> inRow;
    for (const SubjectTotals::Practiced& answer : answers) {
      const std::string& round = practice->eachView ? answer.view : "";
      inRow[round] = answer.right ? inRow[round] + 1 : 0;
      longest[round] = std::max(longest[round], inRow[round]);
    }
    const auto misses = [&](const auto& round) { return round.second < practice->minCorrect; };
    if (std::any_of(longest.begin(), longest.end(), misses)) {
      return true;
    }
  }
  return false;
}

bool Excluder::isMet(const ExclusionRule& rule, const std::string& subject, const SubjectTotals& totals) const {
  const auto share = [](int64_t part, int64_t whole) {
    return whole > 0 ? std::optional(static_cast<double>(part) / static_cast<double>(whole)) : std::nullopt;
  };
  const auto shareMatches = [&](std::optional<double> value) { return value && matches(rule, *value); };
  if (rule.what == "subject") {
    return matches(rule, subject);
  }
  if (rule.what == "ending") {
    return std::any_of(totals.endings.begin(), totals.endings.end(),
                       [&](const std::string& ending) { return matches(rule, ending); });
  }
  if (rule.what == "sessions_completed") {
    return matches(rule, static_cast<double>(totals.completed));
  }
  if (rule.what == "timeout_share") {
    return shareMatches(share(totals.timeouts, totals.trials));
  }
  if (rule.what == "dropped_share") {
    return shareMatches(share(totals.dropped, totals.frames));
  }
  if (rule.what == "practice_criterion") {
    return missesPractice(totals);
  }
  const auto given = answers_.find({subject, rule.what.substr(kFormPrefix.size())});
  return given != answers_.end() && std::any_of(given->second.begin(), given->second.end(),
                                                [&](const std::string& answer) { return matches(rule, answer); });
}

void Excluder::excludeSubject(const std::string& subject, const ExclusionRule& rule) {
  if (!subjectWhy_.try_emplace(subject, fmt::format("{} ({})", rule.reason, describe(rule))).second) {
    return;
  }
  result_.excluded.push_back({subject, std::nullopt, describe(rule), rule.reason});
  auto& excluded = result_.flow.excluded;
  const auto found =
      std::find_if(excluded.begin(), excluded.end(), [&](const auto& e) { return e.first == rule.reason; });
  if (found == excluded.end()) {
    excluded.emplace_back(rule.reason, 1);
  } else {
    ++found->second;
  }
}

void Excluder::apply(const ExclusionRule& rule) {
  const Dataset& data = result_.data;
  const std::optional<ExclusionKind> kind = exclusionKindOf(rule.what);
  if (rule.what == "subject" && rule.test == ExclusionTest::kIs && data.findSubject(rule.text) == nullptr) {
    const bool wasLeftOut = std::any_of(data.leftOut.begin(), data.leftOut.end(),
                                        [&](const LeftOutRow& row) { return row.subject == rule.text; });
    if (!wasLeftOut) {
      throw InputError(fmt::format("no source holds subject \"{}\", whom the plan excludes", rule.text),
                       fmt::format("plan \"{}\"", result_.plan.name),
                       "the plan of this study, or all of its databases");
    }
  }
  if (rule.what == "practice_criterion" && !hasProtocol_) {
    throw InputError("the plan excludes by the criterion of practice, which stands in the protocol",
                     data.sources.empty() ? "no source" : data.sources.front().path,
                     "the database; or --protocol FILE, for exported tables");
  }
  switch (kind->level) {
    case ExclusionLevel::kSubject:
      for (const auto& [subject, totals] : totals_) {
        if (isMet(rule, subject, totals)) {
          excludeSubject(subject, rule);
        }
      }
      return;
    case ExclusionLevel::kSession:
      for (const Session& session : data.sessions) {
        const bool met = rule.what == kForcedSession ? session.forced : session.ending != SessionEnding::kCompleted;
        const std::string why = fmt::format("{} ({})", rule.reason, describe(rule));
        if (met && sessionWhy_.try_emplace({session.subject, session.number}, why).second) {
          result_.excluded.push_back({session.subject, session.number, describe(rule), rule.reason});
        }
      }
      return;
    case ExclusionLevel::kTrial:
      for (size_t i = 0; i < data.trials.size(); ++i) {
        const Trial& trial = data.trials[i];
        const double frames = static_cast<double>(trial.frames);
        const bool met = rule.what == "timing_verdict"
                             ? matches(rule, nameOrNothing(trial.timingVerdict))
                             : trial.frames > 0 && matches(rule, static_cast<double>(trial.droppedFrames) / frames);
        if (met && trialWhy_[i].empty()) {
          trialWhy_[i] = fmt::format("{} ({})", rule.reason, describe(rule));
        }
      }
      return;
  }
}

void Excluder::remove() {
  Dataset& data = result_.data;
  std::map<std::pair<std::string, int>, int64_t> trialsOfSession;
  std::map<std::string, int64_t> trialsOfSubject;
  std::vector<Trial> kept;
  kept.reserve(data.trials.size());
  for (size_t i = 0; i < data.trials.size(); ++i) {
    Trial& trial = data.trials[i];
    const auto ofSubject = subjectWhy_.find(trial.subject);
    const auto ofSession = sessionWhy_.find({trial.subject, trial.session});
    std::string why;
    if (ofSubject != subjectWhy_.end()) {
      why = ofSubject->second;
      ++trialsOfSubject[trial.subject];
    } else if (ofSession != sessionWhy_.end()) {
      why = ofSession->second;
      ++trialsOfSession[ofSession->first];
    } else {
      why = trialWhy_[i];
    }
    if (why.empty()) {
      kept.push_back(std::move(trial));
    } else {
      data.leftOut.push_back(
          {trial.source, LeftOutRow::Table::kTrial, trial.trialId, trial.subject, trial.session, std::move(why)});
    }
  }
  data.trials = std::move(kept);
  std::erase_if(data.answers, [&](const FormAnswer& answer) {
    const auto why = subjectWhy_.find(answer.subject);
    if (why != subjectWhy_.end()) {
      data.leftOut.push_back(
          {answer.source, LeftOutRow::Table::kAnswer, answer.answerId, answer.subject, answer.session, why->second});
    }
    return why != subjectWhy_.end();
  });
  for (ExcludedSubject& excluded : result_.excluded) {
    excluded.trials =
        excluded.session ? trialsOfSession[{excluded.subject, *excluded.session}] : trialsOfSubject[excluded.subject];
  }
}

void Excluder::countAfter() {
  SubjectFlow& flow = result_.flow;
  std::set<std::string> left;
  for (const Trial& trial : result_.data.trials) {
    left.insert(trial.subject);
  }
  flow.analysed = static_cast<int>(left.size());
  flow.analysedTrials = static_cast<int64_t>(result_.data.trials.size());
  flow.excludedTrials = flow.trials - flow.analysedTrials;
  flow.analysedWithSessions.assign(flow.completedSessions.size(), 0);
  for (const std::string& subject : left) {
    for (size_t k = 0; k < static_cast<size_t>(totals_[subject].completed); ++k) {
      ++flow.analysedWithSessions[k];
    }
  }
}

}  // namespace

AnalysisData applyPlan(Dataset data, const AnalysisPlan& plan) {
  return Excluder(std::move(data), plan).all();
}

int completedSessions(const Dataset& data, const std::string& subject) {
  return static_cast<int>(std::count_if(data.sessions.begin(), data.sessions.end(), [&](const Session& session) {
    return session.subject == subject && session.ending == SessionEnding::kCompleted;
  }));
}

std::map<std::string, int> completedSessions(const Dataset& data) {
  std::map<std::string, int> completed;
  for (const Session& session : data.sessions) {
    completed[session.subject] += session.ending == SessionEnding::kCompleted ? 1 : 0;
  }
  return completed;
}

std::string describe(const ExclusionRule& rule) {
  switch (rule.test) {
    case ExclusionTest::kAlways:
      return rule.what;
    case ExclusionTest::kIs:
      return fmt::format("{} is {}", rule.what, rule.text);
    case ExclusionTest::kIsNot:
      return fmt::format("{} is not {}", rule.what, rule.text);
    case ExclusionTest::kAtLeast:
      return fmt::format("{} is at least {:g}", rule.what, rule.number);
    case ExclusionTest::kAtMost:
      return fmt::format("{} is at most {:g}", rule.what, rule.number);
  }
  return "";
}

std::string problemOfRule(const ExclusionRule& rule, const std::string& test, bool hasValue, bool valueIsText) {
  const std::optional<ExclusionKind> kind = exclusionKindOf(rule.what);
  if (!kind) {
    std::string allowed;
    for (const ExclusionKind& each : kExclusionKinds) {
      allowed += fmt::format("{}, ", each.what);
    }
    return fmt::format("is \"{}\", but must be one of: {}form:FIELD", rule.what, allowed);
  }
  const std::optional<ExclusionTest> found = exclusionTestOf(test);
  const bool isText = found == ExclusionTest::kIs || found == ExclusionTest::kIsNot;
  const bool isNumber = found && comparesNumbers(*found);
  switch (kind->value) {
    case ExclusionValue::kNone:
      return found == ExclusionTest::kAlways && !hasValue
                 ? ""
                 : fmt::format("is \"{}\", which takes no \"test\" and no \"value\"", rule.what);
    case ExclusionValue::kText:
      if (!isText || !hasValue || !valueIsText) {
        return fmt::format("is \"{}\", which needs the \"test\" is or is_not and a text as \"value\"", rule.what);
      }
      return kind->what == "ending"           ? problemOfChoice(rule.text, kSessionEndings)
             : kind->what == "timing_verdict" ? problemOfChoice(rule.text, kTimingVerdicts)
                                              : "";
    case ExclusionValue::kNumber:
    case ExclusionValue::kShare:
      if (!isNumber || !hasValue || valueIsText || (kind->value == ExclusionValue::kShare && rule.number > 1)) {
        return fmt::format("is \"{}\", which needs the \"test\" at_least or at_most and a number{} as \"value\"",
                           rule.what, kind->value == ExclusionValue::kShare ? " from 0 to 1" : "");
      }
      return "";
  }
  return "";
}

std::string exclusionLogCsv(const Dataset& data) {
  std::string text = "source,table,row,subject,session,why\r\n";
  const auto path = [&](int source) { return data.sources[static_cast<size_t>(source)].path; };
  const auto add = [&](int source, const char* table, int64_t row, const std::string& subject, int session,
                       const std::string& why) {
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{}\r\n", csvText(path(source)), table, row,
                   csvText(subject), session, csvText(why));
  };
  for (const LeftOutRow& row : data.leftOut) {
    add(row.source, row.table == LeftOutRow::Table::kTrial ? "final_trial" : "final_answer", row.id, row.subject,
        row.session, row.why);
  }
  for (const OtherAttempt& attempt : data.otherAttempts) {
    add(attempt.source, "trial", attempt.trialId, attempt.subject, attempt.session, describe(attempt.why));
  }
  return text;
}

}  // namespace ocelli
