#include "study/subject/data_generator.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "oc_core/base/json_fields.h"
#include "oc_core/base/sha256.h"
#include "study/subject/form_taste.h"
#include "study/subject/generator_truth.h"
#include "study/subject/simulate_session.h"

namespace ocelli {
namespace {

constexpr double kLargest = 20;  // of any effect: more makes every answer the same
constexpr double kAnswerSeconds = 2;
constexpr double kPauseSeconds = 2;  // between trials

/// Calls `visit(field, effect)` for each.
template <class Effects, class Visit>
void forEachFind(Effects& find, const Visit& visit) {
  visit("log_seconds", find.logSeconds);
  visit("graph", find.graph);
  visit("moving", find.moving);
  visit("session", find.session);
  visit("subject_sd", find.subjectSd);
  visit("subject_graph_sd", find.subjectGraphSd);
  visit("item_sd", find.itemSd);
  visit("item_view_sd", find.itemViewSd);
  visit("residual_sd", find.residualSd);
}
template <class Effects, class Visit>
void forEachCount(Effects& count, const Visit& visit) {
  visit("right", count.right);
  visit("graph", count.graph);
  visit("duplicates", count.duplicates);
  visit("doubled_exposure", count.doubledExposure);
  visit("session", count.session);
  visit("subject_sd", count.subjectSd);
  visit("item_sd", count.itemSd);
  visit("item_view_sd", count.itemViewSd);
}
template <class Effects, class Visit>
void forEachPath(Effects& path, const Visit& visit) {
  visit("right", path.right);
  visit("graph", path.graph);
  visit("session", path.session);
  visit("subject_sd", path.subjectSd);
  visit("item_sd", path.itemSd);
  visit("item_view_sd", path.itemViewSd);
}

uint64_t hashOf(const std::string& text) {
  uint64_t hash = 0;
  const std::string hex = sha256(text).substr(0, 16);
  std::from_chars(hex.data(), hex.data() + hex.size(), hash, 16);
  return hash;
}

/// Draws outcomes of one subject in one session.
class RandomDraws {
 public:
  RandomDraws(const Protocol& protocol, const GeneratedSession& session)
      : protocol_(protocol), session_(session), effects_(session.effects) {
    Random random(seedOf(session.subjectSeed, 1));  // what stays with the subject
    findSubject_ = normal(random, 0, effects_.find.subjectSd);
    findSubjectGraph_ = normal(random, 0, effects_.find.subjectGraphSd);
    countSubject_ = normal(random, 0, effects_.count.subjectSd);
    pathSubject_ = normal(random, 0, effects_.path.subjectSd);
  }

  TrialOutcome outcomeOf(const TrialPlan& plan, const CaseInfo& info, const std::string& expected, Random& random) {
    TrialOutcome outcome;
    outcome.expected = expected;
    double seconds = kAnswerSeconds * std::exp(normal(random, 0, 0.3));
    if (plan.task == "find") {
      seconds = std::exp(findMean(plan, info) + normal(random, 0, effects_.find.residualSd));
      outcome.censored = seconds >= info.longestSeconds;
      outcome.correct = !outcome.censored;
      outcome.answer = outcome.correct ? expected : "";
      seconds = std::min(seconds, info.longestSeconds);
    } else {
      const double logit = plan.task == "count" ? countLogit(plan, info) : pathLogit(plan, info);
      outcome.correct = happens(random, 1 / (1 + std::exp(-logit)));
      outcome.answer = outcome.correct ? expected : wrongAnswer(plan, expected, random);
      seconds = std::min(seconds, std::max(info.longestSeconds - info.exposureSeconds.value_or(0), 0.1));
    }
    outcome.responseTicks = std::max<int64_t>(1, std::llround(seconds * static_cast<double>(kTicksPerSecond)));
    return outcome;
  }

 private:
  /// What an item adds in a view.
  double itemOf(const TrialPlan& plan, const CaseInfo& info, double itemSd, double itemViewSd) const {
    const std::string& block = protocol_.blocks[static_cast<size_t>(plan.block)].name;
    Random random(
        seedOf(session_.studySeed, hashOf(fmt::format("{}\n{}\n{}", block, info.label, session_.schedule.session))));
    const double item = normal(random, 0, itemSd);
    const double itemView = normal(random, 0, itemViewSd);
    return item + (plan.view == StudyView::kGraph ? 0.5 : -0.5) * itemView;
  }
  double fixedPartOf(const TrialPlan& plan, const CaseInfo& info) const {
    return fixedPart(effects_, {plan.task, plan.view, info, session_.schedule.session});
  }
  double findMean(const TrialPlan& plan, const CaseInfo& info) const {
    return fixedPartOf(plan, info) + (plan.view == StudyView::kGraph ? findSubjectGraph_ : 0) + findSubject_ +
           itemOf(plan, info, effects_.find.itemSd, effects_.find.itemViewSd);
  }
  double countLogit(const TrialPlan& plan, const CaseInfo& info) const {
    return fixedPartOf(plan, info) + countSubject_ +
           itemOf(plan, info, effects_.count.itemSd, effects_.count.itemViewSd);
  }
  double pathLogit(const TrialPlan& plan, const CaseInfo& info) const {
    return fixedPartOf(plan, info) + pathSubject_ + itemOf(plan, info, effects_.path.itemSd, effects_.path.itemViewSd);
  }
  static std::string wrongAnswer(const TrialPlan& plan, const std::string& expected, Random& random) {
    if (plan.task != "count") {
      return "other";
    }
    int number = 0;
    std::from_chars(expected.data(), expected.data() + expected.size(), number);
    return std::to_string(number + (happens(random, 0.5) ? 1 : -1));
  }

  const Protocol& protocol_;
  const GeneratedSession& session_;
  const GeneratorEffects& effects_;
  double findSubject_ = 0;
  double findSubjectGraph_ = 0;
  double countSubject_ = 0;
  double pathSubject_ = 0;
};

void answerForm(const Protocol& protocol, const ProtocolForm& form, const std::string& utc, Random& random,
                SessionSink& sink) {
  for (size_t i = 0; i < form.fields.size(); ++i) {
    const int option = optionOf(protocol, form, static_cast<int>(i), {}, random);
    sink.answer({form.name, form.fields[i].name, form.fields[i].options[static_cast<size_t>(option)], utc});
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

GeneratorEffects readGeneratorEffects(const std::filesystem::path& file) {
  return readAs("docs/simulated_subjects.md", [&] {
    const nlohmann::json json = readJsonFile(file);
    JsonFields fields(json, file.string());
    GeneratorEffects effects;
    const auto read = [&](const char* name, const auto& forEach, auto& group) {
      if (fields.has(name)) {
        JsonFields inner(fields.value(name), fmt::format("{}, \"{}\"", fields.where(), name));
        forEach(group, [&](const std::string& field, double& effect) {
          effect = inner.number(field, field.ends_with("_sd") ? 0 : -kLargest, kLargest, effect);
        });
        inner.rejectUnknown();
      }
    };
    read(
        "find", [](auto& group, const auto& visit) { forEachFind(group, visit); }, effects.find);
    read(
        "count", [](auto& group, const auto& visit) { forEachCount(group, visit); }, effects.count);
    read(
        "path", [](auto& group, const auto& visit) { forEachPath(group, visit); }, effects.path);
    fields.rejectUnknown();
    return effects;
  });
}

std::string jsonText(const GeneratorEffects& effects) {
  nlohmann::ordered_json json;
  forEachFind(effects.find, [&](const char* field, double effect) { json["find"][field] = effect; });
  forEachCount(effects.count, [&](const char* field, double effect) { json["count"][field] = effect; });
  forEachPath(effects.path, [&](const char* field, double effect) { json["path"][field] = effect; });
  return json.dump();
}

void generateSession(const Protocol& protocol, const GeneratedSession& session, SessionSink& sink) {
  const int number = session.schedule.session;
  Random random(seedOf(session.subjectSeed, 100 + static_cast<uint64_t>(number)));
  RandomDraws renderer(protocol, session);
  int64_t now = 0;
  const auto utc = [&] { return simulatedUtc(number, now); };
  if (number == 0 && protocol.consent) {
    const std::string text = joined(protocol.consent->paragraphs);
    sink.consent({protocol.consent->title, text, sha256(text), true, utc()});
  }
  if (number == 0 && protocol.demographics) {
    answerForm(protocol, *protocol.demographics, utc(), random, sink);
  }
  int begun = 0;
  for (const TrialPlan& plan : session.schedule.trials) {
    const TaskBlock& task = *protocol.blocks[static_cast<size_t>(plan.block)].task;
    TrialRecord record;
    record.plan = plan;
    record.info = task.caseInfo(plan.caseIndex);
    record.startedNanoseconds = now;
    record.startedUtc = utc();
    record.outcome = renderer.outcomeOf(plan, record.info, session.tellsAnswers ? task.answerOf(plan) : "", random);
    if (!session.tellsAnswers) {
      record.outcome.answer.clear();
    }
    record.timing.verdict = "simulated_clock";
    now += nanosecondsOf(static_cast<double>(record.outcome.responseTicks) / static_cast<double>(kTicksPerSecond) +
                         record.info.exposureSeconds.value_or(0));
    record.endedNanoseconds = now;
    record.endedUtc = utc();
    sink.trialBegins(begun, plan, 1);
    sink.trialEnds(begun++, record);
    now += nanosecondsOf(kPauseSeconds);
  }
  if (protocol.survey && (!protocol.surveyAfterLastSessionOnly || number + 1 == protocol.sessions)) {
    answerForm(protocol, *protocol.survey, utc(), random, sink);
  }
  sink.sessionEnds(SessionEnding::kCompleted, utc());
}

}  // namespace ocelli
