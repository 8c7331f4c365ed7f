#include "study/subject/data_generator.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <numbers>

#include "oc_core/base/check.h"
#include "oc_core/base/number_text.h"
#include "oc_core/base/sha256.h"
#include "study/protocol/leveled_block.h"
#include "study/protocol/staircase_trials.h"
#include "study/subject/form_taste.h"
#include "study/subject/simulate_session.h"
#include "study/tasks/task_registry.h"

namespace ocelli {
namespace {

constexpr double kAnswerSeconds = 2;
constexpr double kPauseSeconds = 2;  // between trials

uint64_t hashOf(const std::string& text) {
  uint64_t hash = 0;
  const std::string hex = sha256(text).substr(0, 16);
  std::from_chars(hex.data(), hex.data() + hex.size(), hash, 16);
  return hash;
}

double numberOf(const std::string& expected) {
  const std::optional<double> number = numberFromText<double>(expected);
  OC_CHECK(number, "what is expected of an estimate is a number");
  return *number;
}

/// Draws outcomes of one subject in one session.
class RandomDraws {
 public:
  RandomDraws(const Protocol& protocol, const GeneratedSession& session)
      : protocol_(protocol), session_(session), effects_(session.effects) {
    Random random(seedOf(session.subjectSeed, 1));  // what stays with the subject
    for (const TaskKind& kind : taskKinds()) {
      SubjectEffects& subject = subject_[kind.name];
      subject.mean = normal(random, 0, effects_.at(kind.name, kSubjectSd));
      if (kind.generator.indexOf(kSubjectGraphSd)) {
        subject.graph = normal(random, 0, effects_.at(kind.name, kSubjectGraphSd));
      }
      if (!isPair()) {
        Random ofConditions(seedOf(session.subjectSeed, hashOf(kind.name + "\nconditions")));
        subject.conditions = drawConditions(ofConditions, effects_.valueOr0(kind.name, kSubjectGraphSd));
      }
    }
  }

  TrialOutcome outcomeOf(const TrialPlan& plan, const CaseInfo& info, const std::string& expected, Random& random) {
    TrialOutcome outcome;
    outcome.expected = expected;
    const TaskKind& kind = taskKind(plan.task, protocol_.name);
    double seconds = kAnswerSeconds * std::exp(normal(random, 0, 0.3));
    switch (kind.outcome) {
      case OutcomeKind::kTime:
        seconds = std::exp(meanOf(plan, info) + normal(random, 0, effects_.valueOr0(plan.task, kResidualSd)));
        outcome.censored = seconds >= info.longestSeconds;
        outcome.correct = !outcome.censored;
        outcome.answer = outcome.correct ? expected : "";
        seconds = std::min(seconds, info.longestSeconds);
        break;
      case OutcomeKind::kAnswer:
        outcome.correct = happens(random, 1 / (1 + std::exp(-meanOf(plan, info))));
        outcome.answer = outcome.correct ? expected : kind.generator.wrongAnswer(expected, random);
        seconds = std::min(seconds, std::max(info.longestSeconds - info.exposureSeconds.value_or(0), 0.1));
        break;
      case OutcomeKind::kEstimate: {
        const double error = meanOf(plan, info) + normal(random, 0, effects_.valueOr0(plan.task, kResidualSd));
        const EstimatedValue value = estimateWithError(*kind.generator.unit, numberOf(expected), error);
        outcome.answer = estimateText(value.estimate);
        outcome.correct = std::abs(value.signedError()) <= kind.generator.rightWithin;
        outcome.measures = measuresOf(value);
        seconds = std::min(seconds, std::max(info.longestSeconds - info.exposureSeconds.value_or(0), 0.1));
        break;
      }
    }
    outcome.responseTicks = std::max<int64_t>(1, std::llround(seconds * static_cast<double>(kTicksPerSecond)));
    return outcome;
  }

 private:
  /// What one subject adds to the mean of a task.
  struct SubjectEffects {
    double mean = 0;
    double graph = 0;                  ///< of a pair: in the other condition
    std::vector<double> conditions{};  ///< of other numbers of conditions: in each
  };

  bool isPair() const { return protocol_.conditions.names.isPair(); }
  /// One number a condition, such that two of them differ by `deviation`.
  std::vector<double> drawConditions(Random& random, double deviation) const {
    std::vector<double> drawn(protocol_.conditions.names.size());
    for (double& each : drawn) {
      each = normal(random, 0, deviation / std::numbers::sqrt2);
    }
    return drawn;
  }

  /// What an item adds in a view.
  double itemOf(const TrialPlan& plan, const CaseInfo& info) const {
    const std::string& block = protocol_.blocks[static_cast<size_t>(plan.block)].name;
    Random random(seedOf(session_.studySeed,
                         hashOf(fmt::format("{}\n{}\n{}", block, info.label, session_.schedule.session - 1))));
    const double item = normal(random, 0, effects_.at(plan.task, kItemSd));
    if (!isPair()) {
      return item + drawConditions(random, effects_.at(plan.task, kItemViewSd)).at(indexOfCondition(plan.view));
    }
    const double itemView = normal(random, 0, effects_.at(plan.task, kItemViewSd));
    return item + (plan.view == TrialView::kOther ? 0.5 : -0.5) * itemView;
  }
  /// Mean log seconds, logit of a right answer, or mean error.
  double meanOf(const TrialPlan& plan, const CaseInfo& info) const {
    const SubjectEffects& subject = subject_.at(plan.task);
    const double ofView = !isPair()                        ? subject.conditions.at(indexOfCondition(plan.view))
                          : plan.view == TrialView::kOther ? subject.graph
                                                           : 0;
    return fixedPart(effects_, {plan.task, plan.view, info, session_.schedule.session, protocol_.nameOf(plan.view)}) +
           ofView + subject.mean + itemOf(plan, info);
  }

  const Protocol& protocol_;
  const GeneratedSession& session_;
  const GeneratorEffects& effects_;
  std::map<std::string, SubjectEffects> subject_{};
};

void answerForm(const Protocol& protocol, const ProtocolForm& form, const std::string& utc, Random& random,
                SessionSink& sink) {
  for (const QuestionItem& item : itemsOf(form.fields)) {
    const FormField& field = form.fields[static_cast<size_t>(item.field)];
    const QuestionEntry entry = entryOf(protocol, form, item, {}, random);
    sink.answer({form.name, item.name, questionKind(field.kind).stored(field, entry).value_or(""), utc});
  }
}

void answerForms(const Protocol& protocol, const std::vector<ProtocolForm>& forms, const std::string& utc,
                 Random& random, SessionSink& sink) {
  for (const ProtocolForm& form : forms) {
    answerForm(protocol, form, utc, random, sink);
  }
}

std::string joined(const std::vector<std::string>& paragraphs) {
  std::string text;
  for (const std::string& paragraph : paragraphs) {
    text += text.empty() ? "" : "\n\n";
    text += paragraph;
  }
  return text;
}

}  // namespace

void generateSession(const Protocol& protocol, const GeneratedSession& session, SessionSink& sink) {
  const int number = session.schedule.session;
  Random random(seedOf(session.subjectSeed, 100 + static_cast<uint64_t>(number - 1)));
  RandomDraws draws(protocol, session);
  int64_t now = 0;
  const auto utc = [&] { return simulatedUtc(number, now); };
  if (number == 1 && protocol.consent) {
    const std::string text = joined(protocol.consent->paragraphs);
    sink.consent({protocol.consent->title, text, sha256(text), true, utc()});
  }
  if (number == 1 && protocol.demographics) {
    answerForm(protocol, *protocol.demographics, utc(), random, sink);
  }
  answerForms(protocol, protocol.before, utc(), random, sink);
  int begun = 0;
  AnsweredCases answered;
  const std::vector<TrialPlan>& plans = session.schedule.trials;
  for (size_t i = 0; i < plans.size(); ++i) {
    const TrialPlan plan = shownPlan(protocol, plans[i], answered);
    const ProtocolBlock& block = protocol.blocks[static_cast<size_t>(plan.block)];
    const TaskBlock& task = *block.task;
    TrialRecord record;
    record.plan = plan;
    record.info = task.caseInfo(plan.caseIndex);
    record.startedNanoseconds = now;
    record.startedUtc = utc();
    // Of estimates the truth is what errors are drawn around.
    const bool needsTruth = taskKind(plan.task, protocol.name).outcome == OutcomeKind::kEstimate;
    record.outcome =
        draws.outcomeOf(plan, record.info, session.tellsAnswers || needsTruth ? task.answerOf(plan) : "", random);
    if (!session.tellsAnswers) {
      record.outcome.answer.clear();
      record.outcome.expected.clear();
    }
    if (record.info.level) {
      record.outcome.measures[kLevelMeasure] = *record.info.level;
    }
    answered[plan.index] = {plan.block, plan.view, plan.caseIndex, record.outcome.correct};
    record.timing.verdict = TimingVerdict::kSimulatedClock;
    now += nanosecondsOf(static_cast<double>(record.outcome.responseTicks) / static_cast<double>(kTicksPerSecond) +
                         record.info.exposureSeconds.value_or(0));
    record.endedNanoseconds = now;
    record.endedUtc = utc();
    sink.trialBegins(begun, plan, 1);
    sink.trialEnds(begun++, record);
    now += nanosecondsOf(kPauseSeconds);
    if (i + 1 == plans.size() || plans[i + 1].block != plan.block) {
      answerForms(protocol, block.after, utc(), random, sink);
    }
  }
  answerForms(protocol, protocol.after, utc(), random, sink);
  if (protocol.survey && (!protocol.surveyAfterLastSessionOnly || number == protocol.sessions)) {
    answerForm(protocol, *protocol.survey, utc(), random, sink);
  }
  sink.sessionEnds(SessionEnding::kCompleted, utc());
}

}  // namespace ocelli
