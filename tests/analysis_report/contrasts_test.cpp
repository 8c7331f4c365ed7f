// Contrasts of conditions against closed forms of balanced designs, and their weights.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "analysis/models/mixed_model.h"
#include "analysis/report/condition_model.h"
#include "oc_core/base/random_numbers.h"
#include "tests/analysis_report/hand_made_trials.h"

namespace ocelli::test {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pointwise;

/// Two cameras at two heights, and a third camera at one.
ViewConditions conditionsOf(size_t count) {
  const std::vector<ViewCondition> all{
      {"flat-low", "flat, low", "", {}, {{"camera", "flat"}, {"height", "low"}}},
      {"flat-high", "flat, high", "", {}, {{"camera", "flat"}, {"height", "high"}}},
      {"bent-low", "bent, low", "", {}, {{"camera", "bent"}, {"height", "low"}}},
      {"bent-high", "bent, high", "", {}, {{"camera", "bent"}, {"height", "high"}}},
      {"bent-high-2", "bent, high, again", "", {}, {{"camera", "bent"}, {"height", "high"}}}};
  ViewConditions conditions;
  conditions.list.assign(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count));
  conditions.factors = {{"camera", {"flat", "bent"}}, {"height", {"low", "high"}}};
  return conditions;
}

PlannedContrast ofWeights(std::vector<std::pair<std::string, double>> weights) {
  PlannedContrast contrast;
  contrast.name = "weights";
  contrast.weights = std::move(weights);
  return contrast;
}

PlannedContrast ofLevels(std::vector<ContrastLevels> levels) {
  PlannedContrast contrast;
  contrast.name = "levels";
  contrast.levels = std::move(levels);
  return contrast;
}

const ContrastLevels kCamera{"camera", "bent", "flat"};
const ContrastLevels kHeight{"height", "low", "high"};

PlannedModel modelOf(std::vector<std::string> slopes) {
  return {"time", "find", ModelKind::kLinearMixed, {"view"}, {{"subject", slopes}, {"case", slopes}}};
}

constexpr int kSubjects = 9;
constexpr int kCases = 6;

/// Each subject sees each case in each condition once; log seconds are a sum of all effects and a residual.
struct BalancedStudy {
  explicit BalancedStudy(size_t count, double cellDeviation = 0) {
    data.conditions = conditionsOf(count);
    RandomNumbers numbers(7);
    const auto drawn = [&](size_t size, double deviation) {
      std::vector<double> values(size);
      for (double& value : values) {
        value = deviation * numbers.normal();
      }
      return values;
    };
    const std::vector<double> subjects = drawn(kSubjects, 0.4);
    const std::vector<double> cases = drawn(kCases, 0.3);
    const std::vector<double> cells = drawn(kSubjects * count, cellDeviation);
    for (size_t i = 0; i < kSubjects; ++i) {
      for (size_t j = 0; j < kCases; ++j) {
        for (size_t k = 0; k < count; ++k) {
          const double log =
              2 + 0.2 * static_cast<double>(k) + subjects[i] + cases[j] + cells[i * count + k] + 0.5 * numbers.normal();
          HandMadeTrial trial;
          trial.subject = "s" + std::to_string(i);
          trial.caseIndex = static_cast<int>(j);
          trial.view = conditionAt(k);
          trial.seconds = std::exp(log);
          trials.add(trial);
          logs.push_back(log);
        }
      }
    }
  }

  /// Of the logs, over those that `pick` takes.
  template <class Pick>
  double mean(const Pick& pick) const {
    double sum = 0;
    int count = 0;
    size_t row = 0;
    for (size_t i = 0; i < kSubjects; ++i) {
      for (size_t j = 0; j < kCases; ++j) {
        for (size_t k = 0; k < data.conditions.size(); ++k, ++row) {
          if (pick(i, j, k)) {
            sum += logs[row];
            ++count;
          }
        }
      }
    }
    return sum / count;
  }

  Dataset data{};
  HandMadeTrials trials{"find"};
  std::vector<double> logs{};
};

TEST(Contrasts, AreThoseOfLeastSquaresInABalancedDesign) {
  const BalancedStudy study(4);
  const std::vector<PlannedContrast> contrasts{ofWeights({{"bent-low", 1}, {"flat-low", -1}}), ofLevels({kCamera}),
                                               ofLevels({kHeight}), ofLevels({kCamera, kHeight}),
                                               ofWeights({{"flat-low", -1}, {"bent-low", 0.5}, {"bent-high", 0.5}})};
  const std::vector<std::vector<double>> weights{
      {-1, 0, 1, 0}, {-0.5, -0.5, 0.5, 0.5}, {0.5, -0.5, 0.5, -0.5}, {-1, 1, 1, -1}, {-1, 0, 0.5, 0.5}};
  const Estimable<ConditionFit> fit =
      fitConditions(study.data, modelOf({}), study.trials.list(), TimeoutTreatment::kSetToLimit, contrasts);
  ASSERT_TRUE(fit) << fit.reason();
  // The residual mean square of the additive analysis of variance.
  const auto all = [](size_t, size_t, size_t) { return true; };
  double squares = 0;
  size_t row = 0;
  for (size_t i = 0; i < kSubjects; ++i) {
    for (size_t j = 0; j < kCases; ++j) {
      for (size_t k = 0; k < 4; ++k, ++row) {
        const double residual = study.logs[row] - study.mean([&](size_t a, size_t, size_t) { return a == i; }) -
                                study.mean([&](size_t, size_t b, size_t) { return b == j; }) -
                                study.mean([&](size_t, size_t, size_t c) { return c == k; }) + 2 * study.mean(all);
        squares += residual * residual;
      }
    }
  }
  const double degrees = kSubjects * kCases * 4 - 1 - (kSubjects - 1) - (kCases - 1) - 3;
  for (size_t c = 0; c < contrasts.size(); ++c) {
    SCOPED_TRACE(comparisonText(contrasts[c]));
    double expected = 0;
    double lengths = 0;
    for (size_t k = 0; k < 4; ++k) {
      expected += weights[c][k] * study.mean([&](size_t, size_t, size_t condition) { return condition == k; });
      lengths += weights[c][k] * weights[c][k];
    }
    ASSERT_TRUE(fit->contrasts[c].estimate) << fit->contrasts[c].estimate.reason();
    const Estimate& estimate = *fit->contrasts[c].estimate;
    // Generalised least squares are ordinary ones here, whatever the variances are: to rounding.
    EXPECT_NEAR(estimate.value, expected, 1e-9);
    // The search for variances ends where the deviance is flat to about 1e-8, and so they are right to about 1e-4.
    const double error = std::sqrt(squares / degrees * lengths / (kSubjects * kCases));
    EXPECT_NEAR(estimate.standardError, error, 1e-3 * error);
    EXPECT_NEAR(estimate.degreesOfFreedom, degrees, 0.01 * degrees);
    EXPECT_NEAR(estimate.statistic, estimate.value / estimate.standardError, 1e-9);
  }
  for (size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(fit->means[k]->value, study.mean([&](size_t, size_t, size_t condition) { return condition == k; }),
                1e-9);
  }
  EXPECT_EQ(fit->structure, "(1 | subject) + (1 | case)");
}

TEST(Contrasts, CountSubjectsAndNotTrialsWhereTheseDifferInTheConditions) {
  // With (1 | subject:view) alone a contrast is that of subjects' means: its error is that of k cells by subject.
  const BalancedStudy study(3, 0.6);
  PlannedModel model = modelOf({});
  model.randomEffects = {{"subject", {"view"}}, {"case", {}}};
  const Estimable<ConditionFit> fit =
      fitConditions(study.data, model, study.trials.list(), TimeoutTreatment::kSetToLimit,
                    {ofWeights({{"bent-low", 1}, {"flat-low", -1}})});
  ASSERT_TRUE(fit) << fit.reason();
  EXPECT_EQ(fit->structure, "(1 | subject) + (1 | subject:view) + (1 | case)");
  double squares = 0;  // of subject by condition, from the additive model
  for (size_t i = 0; i < kSubjects; ++i) {
    for (size_t k = 0; k < 3; ++k) {
      const double residual = study.mean([&](size_t a, size_t, size_t c) { return a == i && c == k; }) -
                              study.mean([&](size_t a, size_t, size_t) { return a == i; }) -
                              study.mean([&](size_t, size_t, size_t c) { return c == k; }) +
                              study.mean([](size_t, size_t, size_t) { return true; });
      squares += residual * residual;
    }
  }
  const double degrees = (kSubjects - 1) * 2;
  const double error = std::sqrt(2 * squares / degrees / kSubjects);
  const Estimate& estimate = *fit->contrasts[0].estimate;
  EXPECT_NEAR(estimate.standardError, error, 1e-3 * error);
  EXPECT_NEAR(estimate.degreesOfFreedom, degrees, 0.02 * degrees);
  const Estimate expected = estimateOf(estimate.value, error, degrees, 0.95);
  EXPECT_NEAR(estimate.lower, expected.lower, 1e-2);
  EXPECT_NEAR(estimate.upper, expected.upper, 1e-2);
}

TEST(Contrasts, DoNotDependOnWhichConditionIsFirst) {
  const BalancedStudy study(4, 0.5);
  Dataset turned = study.data;
  std::rotate(turned.conditions.list.begin(), turned.conditions.list.begin() + 1, turned.conditions.list.end());
  HandMadeTrials trials("find");
  for (const Trial* trial : study.trials.list()) {
    HandMadeTrial made;
    made.subject = trial->subject;
    made.caseIndex = trial->caseIndex;
    made.view = conditionAt((indexOfCondition(trial->view) + 3) % 4);
    made.seconds = *trial->responseSeconds;
    trials.add(made);
  }
  const std::vector<PlannedContrast> contrasts{ofWeights({{"bent-low", 1}, {"flat-high", -1}}),
                                               ofLevels({kCamera, kHeight})};
  const auto fitOf = [&](const Dataset& data, const TrialList& list) {
    return *fitConditions(data, modelOf({"view"}), list, TimeoutTreatment::kSetToLimit, contrasts);
  };
  const ConditionFit first = fitOf(study.data, study.trials.list());
  const ConditionFit second = fitOf(turned, trials.list());
  EXPECT_EQ(first.structure, second.structure);
  for (size_t i = 0; i < contrasts.size(); ++i) {
    EXPECT_NEAR(first.contrasts[i].estimate->value, second.contrasts[i].estimate->value, 1e-6);
    EXPECT_NEAR(first.contrasts[i].estimate->standardError, second.contrasts[i].estimate->standardError, 1e-5);
  }
}

std::vector<double> weightsIn(const PlannedContrast& contrast, const ViewConditions& conditions) {
  Dataset data;
  data.conditions = conditions;
  const PlannedModel model = modelOf({});
  const Estimable<std::vector<double>> weights = weightsOf(contrast, ConditionTerms(data, model, {}));
  EXPECT_TRUE(weights) << weights.reason();
  return weights ? *weights : std::vector<double>{};
}

std::string reasonOf(const PlannedContrast& contrast, const ViewConditions& conditions) {
  Dataset data;
  data.conditions = conditions;
  const PlannedModel model = modelOf({});
  const Estimable<std::vector<double>> weights = weightsOf(contrast, ConditionTerms(data, model, {}));
  return weights ? "" : weights.reason();
}

TEST(Contrasts, TakeTheMeanOfConditionsOfOneCell) {
  EXPECT_THAT(weightsIn(ofLevels({kCamera}), conditionsOf(5)),
              Pointwise(DoubleNear(1e-12), {-0.5, -0.5, 0.5, 0.25, 0.25}));
  EXPECT_THAT(weightsIn(ofLevels({kCamera, kHeight}), conditionsOf(5)),
              Pointwise(DoubleNear(1e-12), {-1.0, 1.0, 1.0, -0.5, -0.5}));
}

TEST(Contrasts, AreRefusedWhereFactorsAreNotCrossed) {
  EXPECT_THAT(reasonOf(ofLevels({kCamera}), conditionsOf(3)), HasSubstr("not crossed"));
  EXPECT_THAT(reasonOf(ofLevels({kCamera, kHeight}), conditionsOf(3)), HasSubstr("have no condition"));
  EXPECT_THAT(reasonOf(ofLevels({kCamera}), conditionsOf(2)), HasSubstr("have no condition"));
  EXPECT_THAT(reasonOf(ofLevels({{"camera", "bent", "round"}}), conditionsOf(4)), HasSubstr("no level \"round\""));
  EXPECT_THAT(reasonOf(ofLevels({{"color", "red", "blue"}}), conditionsOf(4)), HasSubstr("no level \"red\""));
  EXPECT_THAT(reasonOf(ofWeights({{"bent-low", 1}, {"gone", -1}}), conditionsOf(4)),
              HasSubstr("no condition \"gone\""));
  EXPECT_EQ(reasonOf(ofWeights({{"bent-low", 1}, {"flat-low", -1}}), conditionsOf(3)), "") << "of no factor";
}

TEST(Contrasts, AreThoseWithTheFirstWhereThePlanHasNone) {
  const ViewConditions conditions = conditionsOf(4);
  const std::vector<PlannedContrast> contrasts = contrastsOf({}, modelOf({}), conditions);
  ASSERT_EQ(contrasts.size(), 3u);
  EXPECT_EQ(comparisonText(contrasts[2]), "bent-high / flat-low");
  EXPECT_EQ(contrasts[0].family, contrasts[2].family);
  EXPECT_TRUE(contrastsOf({}, modelOf({}), conditionsOf(1)).empty());
  AnalysisPlan plan;
  plan.contrasts = {ofLevels({kCamera})};
  plan.contrasts[0].model = "time";
  ASSERT_EQ(contrastsOf(plan, modelOf({}), conditions).size(), 1u);
  EXPECT_EQ(comparisonText(plan.contrasts[0]), "camera (bent / flat)");
  EXPECT_EQ(comparisonText(ofWeights({{"a", -1}, {"b", 0.5}, {"c", 0.5}})), "weights -a + 0.5 b + 0.5 c");
}

TEST(Contrasts, SayWhatHasNoTrials) {
  const BalancedStudy study(4);
  TrialList trials = study.trials.list();
  std::erase_if(trials, [](const Trial* trial) { return trial->view == conditionAt(3); });
  const Estimable<ConditionFit> fit =
      fitConditions(study.data, modelOf({}), trials, TimeoutTreatment::kSetToLimit,
                    {ofWeights({{"bent-low", 1}, {"flat-low", -1}}), ofWeights({{"bent-high", 1}, {"flat-low", -1}})});
  ASSERT_TRUE(fit) << fit.reason();
  EXPECT_TRUE(fit->contrasts[0].estimate);
  EXPECT_FALSE(fit->contrasts[1].estimate);
  EXPECT_THAT(fit->contrasts[1].estimate.reason(), HasSubstr("has no trials"));
  EXPECT_FALSE(fit->means[3]);
  EXPECT_FALSE(fitConditions(study.data, modelOf({}), {}, TimeoutTreatment::kSetToLimit, {}));
  PlannedModel unknown = modelOf({});
  unknown.terms = {"view", "color"};
  EXPECT_THAT(fitConditions(study.data, unknown, trials, TimeoutTreatment::kSetToLimit, {}).reason(),
              HasSubstr("no factor \"color\""));
  unknown.terms = {"view", "view:session"};
  EXPECT_THAT(fitConditions(study.data, unknown, trials, TimeoutTreatment::kSetToLimit, {}).reason(),
              HasSubstr("needs view and session"));
}

}  // namespace
}  // namespace ocelli::test
