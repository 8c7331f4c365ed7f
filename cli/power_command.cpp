// `ocelli power`: how many subjects a study needs, by simulated studies.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/dataset/protocol_facts.h"
#include "analysis/power/contrast_effects.h"
#include "analysis/power/power_simulation.h"
#include "analysis/report/contrast_weights.h"
#include "analysis/report/power_report.h"
#include "analysis/report/report_files.h"
#include "analysis/report/report_parts.h"
#include "analysis/report/report_task.h"
#include "analysis/report/view_test.h"
#include "cli/command.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/base/unfinished_output.h"
#include "study/session/utc_time.h"
#include "study/tasks/task_registry.h"

namespace ocelli {
namespace {

constexpr int kMaxSubjects = 1000;
constexpr int kMaxSimulations = 100'000;

struct PowerChoice {
  std::string protocol;
  std::string plan;
  SupposedEffects supposed{};
  std::string contrast;
  double dropOut = 0;
  bool equivalence = false;
  bool withoutNone = false;
  std::vector<int> subjects{10, 20, 30, 40, 50};
  int simulations = 200;
  double power = 0.8;
  std::optional<double> alpha{};
  uint64_t seed = 1;
  std::string folder;
  bool asJson = false;
};

/// CLI::Range lets "nan" pass.
CLI::Validator between(double least, double most) {
  return CLI::Validator(
      [=](std::string& text) {
        double value = 0;
        const bool isNumber = CLI::detail::lexical_cast(text, value);
        return isNumber && value >= least && value <= most
                   ? std::string()
                   : fmt::format("\"{}\" is no number from {:g} to {:g}", text, least, most);
      },
      fmt::format("{:g} to {:g}", least, most));
}

std::string placeName(const NeededSubjects& needed) {
  switch (needed.place) {
    case NeededSubjects::Place::kAtMost:
      return "at_most";
    case NeededSubjects::Place::kAbout:
      return "about";
    case NeededSubjects::Place::kMoreThan:
      return "more_than";
  }
  return "";
}

nlohmann::ordered_json jsonOf(const NeededSubjects& needed) {
  return {{"is", placeName(needed)}, {"subjects", needed.subjects}};
}

nlohmann::ordered_json jsonOf(const PowerStudy& study, const PowerCurve& curve) {
  const bool isPower = curve.question == PowerCurve::Question::kPower;
  nlohmann::ordered_json json = {{"truth", curve.truth},
                                 {"test", curve.test == PowerCurve::Test::kView ? "view" : "equivalence"},
                                 {"share_is", isPower ? "power" : "type_1_error"},
                                 {"true_value", curve.trueValue}};
  json["sizes"] = nlohmann::ordered_json::array();
  for (const PowerSize& size : curve.sizes) {
    const Estimate share = clopperPearsonShare(size.found);
    json["sizes"].push_back({{"subjects", size.subjects},
                             {"subjects_analysed", size.analysed},
                             {"studies", size.found.trials},
                             {"found", size.found.successes},
                             {"share", share.value},
                             {"lower", share.lower},
                             {"upper", share.upper},
                             {"mean_estimate", size.estimate},
                             {"not_estimable", size.notEstimable},
                             {"warned", size.warned}});
  }
  if (isPower) {
    const SubjectsForPower needed = subjectsForPower(pointsOf(curve), study.power);
    json["subjects_for_power"] = {
        {"estimate", jsonOf(needed.estimate)}, {"fewest", jsonOf(needed.fewest)}, {"most", jsonOf(needed.most)}};
  }
  return json;
}

std::string jsonText(const PowerStudy& study) {
  nlohmann::ordered_json json = {{"simulated", true},
                                 {"protocol", study.protocolName},
                                 {"protocol_sha256", study.protocolSha256},
                                 {"task", study.task},
                                 {"plan_sha256", study.plan.sha256},
                                 {"model", study.model},
                                 {"power", study.power},
                                 {"alpha", study.alpha},
                                 {"simulations", study.simulations},
                                 {"drop_out", study.dropOut},
                                 {"seed", study.seed},
                                 {"supposed", study.supposed}};
  if (!study.contrast.empty()) {
    json["contrast"] = study.contrast;
  }
  json["curves"] = nlohmann::ordered_json::array();
  for (const PowerCurve& curve : study.curves) {
    json["curves"].push_back(jsonOf(study, curve));
  }
  json["cautions"] = cautionsOf(study);
  return textOfJson(json, 2) + "\n";
}

std::string tableText(const PowerStudy& study) {
  std::string text = fmt::format("simulated studies by {}, task {}: model {}, alpha {:g}, {} studies a number\n",
                                 study.protocolName, study.task, study.model, study.alpha, study.simulations);
  for (const std::string& line : study.supposed) {
    text += fmt::format("  {}\n", line);
  }
  const OutcomeKind outcome = taskKind(study.task, "--task").outcome;
  for (const PowerCurve& curve : study.curves) {
    const bool isPower = curve.question == PowerCurve::Question::kPower;
    const char* estimate = curve.test != PowerCurve::Test::kView              ? "difference"
                           : outcome == OutcomeKind::kTime                    ? "time ratio"
                           : outcome == OutcomeKind::kAnswer                  ? "odds ratio"
                           : study.unit != nullptr && study.unit->isDirection ? "degrees"
                                                                              : "ratio";
    text += fmt::format("\n{}\n{:>8}  {:>8}  {:>8}  {:>15}  {:>10}  {:>9}  {:>8}\n", nameOf(curve), "subjects",
                        "analysed", isPower ? "power" : "errors", "95 % interval", estimate, "no result", "warnings");
    for (const PowerSize& size : curve.sizes) {
      const Estimate share = clopperPearsonShare(size.found);
      text += fmt::format("{:>8}  {:>8.1f}  {:>6.1f} %  {:>15}  {:>10}  {:>9}  {:>8}\n", size.subjects, size.analysed,
                          100 * share.value, fmt::format("{:.1f} to {:.1f} %", 100 * share.lower, 100 * share.upper),
                          numberText(size.estimate), size.notEstimable, size.warned);
    }
    text += fmt::format("{}\n", answerOf(study, curve));
  }
  for (const std::string& caution : cautionsOf(study)) {
    text += fmt::format("\ncaution: {}\n", caution);
  }
  return text;
}

/// What can be told before the work.
void check(const PowerChoice& choice, double alpha) {
  if (!std::is_sorted(choice.subjects.begin(), choice.subjects.end()) ||
      std::adjacent_find(choice.subjects.begin(), choice.subjects.end()) != choice.subjects.end()) {
    throw InputError("these numbers of subjects do not rise", "--subjects", "--subjects 10,20,30");
  }
  if (choice.subjects.front() < 2) {
    throw InputError("a study of one subject tells nothing about others", "--subjects", "two or more");
  }
  if (choice.power <= alpha) {
    throw InputError(fmt::format("chance alone reaches a power of {:g} where alpha is {:g}", choice.power, alpha),
                     "--power", "--power 0.8");
  }
  if (choice.equivalence && taskKind(choice.supposed.task, "--task").outcome != OutcomeKind::kAnswer) {
    throw InputError(fmt::format("the task {} has no answers whose shares could be equivalent", choice.supposed.task),
                     "--equivalence", "leave it out");
  }
}

/// What is tested: the term "view" of a model of a pair, or a contrast.
struct TestedModel {
  const PlannedModel* model = nullptr;
  std::optional<PlannedContrast> contrast{};
};

/// Whether answers are numbers: then the effect that is supposed is one of signed errors.
bool isOfEstimates(const std::string& task) {
  return taskKind(task, "--task").outcome == OutcomeKind::kEstimate;
}

TestedModel contrastNamed(const PowerChoice& choice, const AnalysisPlan& plan, const ViewConditions& conditions) {
  std::vector<std::string> names;
  for (const PlannedModel& model : plan.models) {
    const bool hasEffect = !isOfEstimates(choice.supposed.task) || model.kind == ModelKind::kSignedErrorMixed;
    if (model.task != choice.supposed.task || !isMixed(model.kind) || !hasEffect) {
      continue;
    }
    for (const PlannedContrast& contrast : contrastsOf(plan, model, conditions)) {
      if (contrast.name == choice.contrast || comparisonText(contrast) == choice.contrast) {
        return {&model, contrast};
      }
      names.push_back(contrast.name);
    }
  }
  throw InputError(choice.contrast.empty()
                       ? fmt::format("the study has {} conditions: which contrast should be found?", conditions.size())
                       : fmt::format("there is no contrast \"{}\" of the task", choice.contrast),
                   "--contrast", fmt::format("one of: {}", fmt::join(names, "; ")));
}

TestedModel testedModel(const PowerChoice& choice, const AnalysisPlan& plan, const ViewConditions& conditions) {
  if (!conditions.isPair() || !choice.contrast.empty()) {
    return contrastNamed(choice, plan, conditions);
  }
  const OutcomeKind outcome = taskKind(choice.supposed.task, "--task").outcome;
  const bool isEstimate = outcome == OutcomeKind::kEstimate;
  // The default plan models right answers of a task before its times; the effect that is supposed is one of the
  // outcome.
  std::optional<ModelKind> kind;
  if (isEstimate) {
    kind = ModelKind::kSignedErrorMixed;
  } else if (outcome == OutcomeKind::kTime && choice.plan.empty()) {
    kind = ModelKind::kLogNormalMixed;
  }
  const PlannedModel* model = viewModelOf(plan, choice.supposed.task, kind);
  if (model == nullptr) {
    throw InputError(fmt::format("the plan has no mixed model of {} with the term \"view\"", choice.supposed.task),
                     choice.plan.empty() ? "the default plan" : choice.plan,
                     isEstimate
                         ? "a model of the kind signed_error_mixed with that term: the effect that is supposed is "
                           "one of signed errors"
                         : "a model of the kind log_normal_mixed, of times, or binomial_mixed, of answers, with "
                           "that term");
  }
  return {model};
}

std::vector<Truth> truthsOf(const PowerChoice& choice, const Protocol& protocol, const TestedModel& tested,
                            const PlannedEquivalence* bounds, const CommandContext& context) {
  if (tested.contrast) {
    std::vector<Truth> ofContrast{contrastTruth(protocol, choice.supposed, *tested.model, *tested.contrast)};
    if (!choice.withoutNone) {
      ofContrast.push_back(contrastTruthWithoutEffect(protocol, choice.supposed.task, ofContrast.front()));
    }
    return ofContrast;
  }
  std::vector<Truth> truths{wantedTruth(protocol, choice.supposed)};
  if (choice.withoutNone) {
    return truths;
  }
  if (truths.front().kind != Truth::Kind::kNone) {
    truths.push_back(truthWithoutEffect(protocol, choice.supposed.task, truths.front()));
  }
  if (bounds != nullptr) {
    if (const std::optional<Truth> atBound = truthAtBound(protocol, truths.front(), *bounds)) {
      truths.push_back(*atBound);
    } else {
      context.note(
          "no share of right answers is as far from that with the pinhole as the bounds of equivalence: its "
          "type-I error is not simulated");
    }
  }
  return truths;
}

void runPower(const PowerChoice& choice, const CommandContext& context) {
  const Protocol protocol = readProtocol(choice.protocol);
  const ProtocolFacts facts = protocolFacts(protocol.text, choice.protocol);
  // That which is asked for is refused below where the protocol does not have it.
  std::vector<std::string> tasks = tasksOf(facts);
  tasks.push_back(choice.supposed.task);
  AnalysisPlan plan = choice.plan.empty() ? defaultPlan(facts.conditions, tasks)
                                          : readPlan(choice.plan, plannableTasks(tasksOf(facts)));
  if (choice.plan.empty()) {
    // What the report does for a task without a row of its own.
    const ReportTask row =
        reportTask(choice.supposed.task, {isOfEstimates(choice.supposed.task), false, protocol.sessions > 1});
    for (const PlannedModel& model : modelsOfTask(plan, row)) {
      if (plan.findModel(model.name) == nullptr) {
        plan.models.push_back(model);
      }
    }
  }
  const double alpha = choice.alpha.value_or(plan.alpha);
  check(choice, alpha);
  const std::string& task = choice.supposed.task;
  const TestedModel tested = testedModel(choice, plan, facts.conditions);
  if (tested.contrast && choice.equivalence) {
    throw InputError("equivalence is tested of two conditions, and not of contrasts", "--equivalence", "leave it out");
  }
  const PlannedEquivalence* bounds = choice.equivalence ? equivalenceBoundsOf(plan, task) : nullptr;
  if (choice.equivalence && bounds == nullptr) {
    throw InputError(
        fmt::format("the plan has no bounds of equivalence for the task {}", task),
        choice.plan.empty() ? "the default plan" : choice.plan,
        fmt::format(R"("equivalence": [{{"task": "{}", "lower": -0.1, "upper": 0.1}}] in the plan)", task));
  }
  const std::vector<Truth> truths = truthsOf(choice, protocol, tested, bounds, context);
  Ranks& ranks = context.ranks();
  if (!choice.folder.empty() && ranks.isFirst()) {
    checkReportFolder(choice.folder);
  }
  const PowerWork work{
      protocol,           plan,  *tested.model,  bounds,      choice.subjects,
      choice.simulations, alpha, choice.dropOut, choice.seed, tested.contrast ? &*tested.contrast : nullptr};
  PowerStudy study;
  study.curves = simulatePower(work, truths, ranks, context.progress());
  if (!ranks.isFirst()) {
    return;
  }
  study.protocolName = protocol.name;
  study.protocolSha256 = protocol.sha256;
  study.task = task;
  study.conditions = facts.conditions;
  study.plan = plan;
  study.model = tested.model->name;
  study.unit = taskKind(task, "--task").generator.unit;
  study.contrast = tested.contrast ? tested.contrast->name : "";
  study.bounds = bounds == nullptr ? std::nullopt : std::optional(*bounds);
  study.supposed =
      tested.contrast ? describeContrastTruth(protocol, truths.front(), task) : describeTruth(truths.front(), task);
  study.sessions = protocol.sessions;
  study.dropOut = choice.dropOut;
  study.simulations = choice.simulations;
  study.power = choice.power;
  study.alpha = alpha;
  study.seed = choice.seed;
  context.print(choice.asJson ? jsonText(study) : tableText(study));
  if (!choice.folder.empty()) {
    // A signal waits until it is whole.
    UnfinishedOutput(unfinishedReportFolder(choice.folder), [] {}).finish([&] {
      writeReportFolder(choice.folder, reportFiles(powerReport(study, OCELLI_VERSION, utcNow())));
    });
    context.note(fmt::format("wrote a report to {}", choice.folder));
  }
}

void addEffectOptions(CLI::App& command, SupposedEffects& supposed) {
  const CLI::Validator spread = between(0, 180);
  const CLI::Validator share = between(0.01, 0.99);
  std::vector<std::string> names;
  for (const TaskKind& kind : taskKinds()) {
    names.push_back(kind.name);
  }
  command.add_option("--task", supposed.task, "Whose effect of the view is looked for")
      ->check(CLI::IsMember(names))
      ->type_name(fmt::format("{}", fmt::join(names, "|")))
      ->required();
  const auto number = [&](const char* name, std::optional<double>& value, const char* help,
                          const CLI::Validator& range) {
    command.add_option(name, value, help)->check(range)->type_name("NUMBER");
  };
  number(
      "--ratio", supposed.ratio,
      "of times, and of estimates of lengths: geometric mean with the other view condition, divided by that with the "
      "reference",
      between(0.05, 20));
  number(
      "--difference", supposed.difference,
      "of estimates of directions: mean signed error with the other condition, less that with the reference, degrees",
      between(-90, 90));
  number("--seconds-reference,--seconds-ppc", supposed.secondsPpc,
         "of times: geometric mean with the reference, had trials no limit", between(0.1, 3600));
  number("--odds-ratio", supposed.oddsRatio,
         "of answers: odds of a right one of a subject, the other condition to the reference", between(0.01, 100));
  number("--share-reference,--share-ppc", supposed.sharePpc, "of answers: share of right ones with the reference",
         share);
  number("--share-other,--share-gc", supposed.shareGc, "of answers: the same with the other condition", share);
  number(
      "--subject-sd", supposed.subjectSd,
      "How subjects differ: standard deviation in log seconds, logits, log(estimate / truth), or of directions degrees",
      spread);
  number("--subject-view-sd", supposed.subjectViewSd,
         "of times and estimates: how they differ in the effect of the view", spread);
  number("--case-sd", supposed.caseSd, "How cases differ", spread);
  number("--case-view-sd", supposed.caseViewSd, "How they differ in the effect of the view", spread);
  number("--residual-sd", supposed.residualSd, "of times and estimates: how trials of one subject for one case differ",
         spread);
  command
      .add_option("--effects", supposed.file,
                  "JSON file of effects, as of `ocelli study simulate`; other options go before it")
      ->type_name("FILE");
}

}  // namespace

void addPowerCommand(CLI::App& program, const CommandContext& context) {
  CLI::App& command = *program.add_subcommand("power", "How many subjects a study needs, by simulated studies");
  const auto choice = std::make_shared<PowerChoice>();
  command.add_option("PROTOCOL", choice->protocol, "The protocol of the study")->required();
  command.add_option("--plan", choice->plan, "The registered plan of the analysis")->type_name("FILE");
  addEffectOptions(command, choice->supposed);
  command
      .add_option(
          "--contrast", choice->contrast,
          "of other numbers of conditions than two: the contrast of the plan, or NAME / FIRST; --effects has the "
          "effects of conditions")
      ->type_name("NAME");
  command.add_option("--drop-out", choice->dropOut, "Share of subjects who do not come back after each session")
      ->check(between(0, 0.95))
      ->type_name("SHARE")
      ->capture_default_str();
  command.add_flag("--equivalence", choice->equivalence,
                   "of answers: also whether the views are shown to be equivalent");
  command.add_flag("--without-none", choice->withoutNone,
                   "Leave out the studies without an effect, which tell the type-I error");
  command.add_option("--subjects", choice->subjects, "Numbers of subjects to try, rising")
      ->delimiter(',')
      ->check(CLI::Range(1, kMaxSubjects))
      ->expected(1, 50)
      ->type_name("N,N,...")
      ->capture_default_str();
  command.add_option("--simulations", choice->simulations, "Studies of each number of subjects")
      ->check(CLI::Range(20, kMaxSimulations))
      ->capture_default_str();
  command.add_option("--power", choice->power, "Share of studies that should find the effect")
      ->check(between(0.01, 0.999))
      ->type_name("SHARE")
      ->capture_default_str();
  command.add_option("--alpha", choice->alpha, "Of the test, two-sided; that of the plan where not given")
      ->check(between(0.0001, 0.5))
      ->type_name("NUMBER");
  command.add_option("--seed", choice->seed, "All that is random comes of it")->capture_default_str();
  command.add_option("-o,--output", choice->folder, "Folder of a report: new, empty, or an earlier report")
      ->type_name("FOLDER");
  command.add_flag("--json", choice->asJson, "Print the numbers as JSON");
  context.finishShared(
      command,
      "  ocelli power protocols/rosen2010.json --task find --ratio 0.85 --subjects 6,12,18,24\n"
      "  ocelli power study.json --plan plan.json --task count --share-ppc 0.5 --share-gc 0.6 -o power\n"
      "  ocelli power study.json --task path --share-ppc 0.7 --share-gc 0.7 --equivalence --drop-out 0.2",
      [choice, context] { runPower(*choice, context); });
}

}  // namespace ocelli
