#include "tests/analysis_power/sham_tasks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <utility>

#include "analysis/power/simulated_dataset.h"
#include "oc_core/base/check.h"
#include "oc_core/base/json_fields.h"
#include "study/task/task_fields.h"
#include "study/tasks/task_registry.h"

namespace ocelli::test {
namespace {

constexpr int kCases = 16;
constexpr std::array kConditionNames{"flat", "bent", "high", "wide"};

class ShamBlock final : public TaskBlock {
 public:
  explicit ShamBlock(std::vector<std::pair<std::string, double>> cases) : cases_(std::move(cases)) {}

  int caseCount() const override { return static_cast<int>(cases_.size()); }
  CaseInfo caseInfo(int caseIndex) const override {
    CaseInfo info;
    info.label = cases_.at(static_cast<size_t>(caseIndex)).first;
    info.longestSeconds = 20;
    info.typicalSeconds = 3;
    return info;
  }
  std::string answerOf(const TrialPlan& plan) const override {
    return estimateText(cases_.at(static_cast<size_t>(plan.caseIndex)).second);
  }
  std::unique_ptr<TrialRun> start(const TrialPlan& /*plan*/, const TrialScreen& /*screen*/) const override {
    OC_CHECK(false, "nobody does a sham task");
    return nullptr;
  }

 private:
  std::vector<std::pair<std::string, double>> cases_;
};

std::shared_ptr<const TaskBlock> readSham(JsonFields& fields, const std::string& caseField, const TaskSetting&) {
  std::vector<std::pair<std::string, double>> cases;
  readCases(fields, caseField, [&](JsonFields& each, const std::string& label) {
    cases.emplace_back(label, each.number("truth", 0, 360));
  });
  return std::make_shared<ShamBlock>(std::move(cases));
}

std::unique_ptr<TaskPolicy> nobody(const PolicySetting&) {
  OC_CHECK(false, "nobody does a sham task");
  return nullptr;
}

/// `scale`: of deviations in terms of the unit's errors.
TaskKind shamTask(const std::string& name, const char* unit, double scale, double rightWithin) {
  TaskKind kind;
  kind.name = name;
  kind.description = "estimate what nobody shows";
  kind.outcome = OutcomeKind::kEstimate;
  kind.read = readSham;
  kind.policy = nobody;
  kind.generator.effects = {{"error", 0, "signed error with the reference", levelCovariate},
                            {kGraphEffect, 0, "the other view", graphCovariate},
                            {kSubjectSd, scale, "between subjects"},
                            {kSubjectGraphSd, scale / 2, "between subjects in the effect of the view"},
                            {kItemSd, scale / 2, "between cases"},
                            {kItemViewSd, scale / 3, "between cases in the effect of the view"},
                            {kResidualSd, 1.5 * scale, "between trials"}};
  kind.generator.unit = &estimateUnit(unit, "test");
  kind.generator.rightWithin = rightWithin;
  return kind;
}

}  // namespace

void registerShamTasks() {
  static const bool kDone = [] {
    registerTask(shamTask("reach", "m", 0.2, std::log(1.2)));
    registerTask(shamTask("bearing", "degrees", 10, 15));
    return true;
  }();
  OC_CHECK(kDone, "registered once");
}

Protocol shamProtocol(int conditions) {
  registerShamTasks();
  std::vector<std::string> named;
  for (int i = 0; i < conditions; ++i) {
    named.push_back(fmt::format(R"({{"name": "{}", "view": "{}"}})", kConditionNames.at(static_cast<size_t>(i)),
                                i % 2 == 0 ? "pinhole" : "graph"));
  }
  std::vector<std::string> reaches;
  std::vector<std::string> bearings;
  for (int i = 0; i < kCases; ++i) {
    reaches.push_back(fmt::format(R"({{"truth": {:.3f}}})", 2 * std::pow(6.0, i / (kCases - 1.0))));
    bearings.push_back(fmt::format(R"({{"truth": {:.1f}}})", 360.0 * i / kCases + 7));
  }
  const auto block = [](const char* task, const std::vector<std::string>& cases) {
    return fmt::format(R"({{"name": "{0}", "title": "{0}", "task": "{0}", "views": "all", "cases": [{1}]}})", task,
                       fmt::join(cases, ", "));
  };
  return protocolFromJsonText(
      fmt::format(R"({{"name": "sham", "title": "Sham", "sessions": 1, "conditions": [{}], "blocks": [{}, {}]}})",
                  fmt::join(named, ", "), block("reach", reaches), block("bearing", bearings)),
      "sham.json");
}

Dataset shamStudy(const Protocol& protocol, const GeneratorEffects& effects, int subjects, uint64_t seed) {
  SimulationPlan plan;
  plan.kind = SubjectKind::kGenerator;
  plan.seed = seed;
  plan.sessions.assign(static_cast<size_t>(subjects), 1);
  plan.effects = effects;
  return simulatedDatasetWithoutAnswers(protocol, plan);
}

}  // namespace ocelli::test
