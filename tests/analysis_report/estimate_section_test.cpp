// What is said of estimates, of trials whose numbers can be checked by hand.
#include "analysis/report/estimate_section.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/report/direction_section.h"
#include "analysis/report/error_model.h"
#include "analysis/report/estimate_trials.h"
#include "analysis/report/power_law.h"
#include "analysis/report/response_scale.h"
#include "tests/analysis_report/hand_made_trials.h"

namespace ocelli::test {
namespace {

class EstimatesByHand : public testing::Test {
 protected:
  EstimatesByHand() { document_.origins.sources = {"made.db"}; }

  Trial& add(const std::string& subject, TrialView view, const std::string& unit, double estimate, double truth) {
    Trial trial;
    trial.trialId = static_cast<int64_t>(analysis_.data.trials.size()) + 1;
    trial.subject = subject;
    trial.task = "far";
    trial.block = "far";
    trial.caseIndex = static_cast<int>(analysis_.data.trials.size());
    trial.view = view;
    trial.measures = {{"estimate_" + unit, estimate}, {"truth_" + unit, truth}};
    analysis_.data.trials.push_back(trial);
    return analysis_.data.trials.back();
  }
  const ReportDocument& section() {
    addEstimateSection(work_, reportTask("far", {true, false}), trialsOfTask(analysis_, "far"));
    return document_;
  }

  AnalysisData analysis_{};
  ReportDocument document_{};
  ReportWork work_{analysis_, document_};
};

TEST_F(EstimatesByHand, MeansAreGeometricOverSubjects) {
  // S1: half and twice the truth, so 1 in the mean; S2: 4 times. Geometric mean over both: 2.
  add("S1", kPpc, "m", 1, 2);
  add("S1", kPpc, "m", 8, 4);
  add("S2", kPpc, "m", 12, 3);
  Trial& late = add("S2", kPpc, "m", 1, 1);
  late.measures.clear();
  late.censored = true;
  const ReportTable* bias = findTable(section(), "estimates-far-bias");
  ASSERT_NE(bias, nullptr);
  EXPECT_NEAR(*bias->rows[0][1].value, 2, 1e-12);
  // Absolute errors: S1 log 2, S2 log 4, mean log of 2^1.5: 182.8 %.
  const ReportTable* absolute = findTable(document_, "estimates-far-absolute");
  ASSERT_NE(absolute, nullptr);
  EXPECT_NEAR(*absolute->rows[0][1].value, 100 * (std::pow(2, 1.5) - 1), 1e-9);
  const ReportTable* counts = findTable(document_, "estimates-far-counts");
  ASSERT_NE(counts, nullptr);
  EXPECT_EQ(counts->rows[0][1].text, "4");
  EXPECT_EQ(counts->rows[0][2].text, "3");
  EXPECT_EQ(counts->rows[0][3].text, "1");
  EXPECT_EQ(counts->rows[0][4].text, "0");
}

TEST_F(EstimatesByHand, UnitIsThatOfMostTrials) {
  add("S1", kPpc, "m", 1, 2);
  add("S1", kPpc, "degrees", 10, 20);
  add("S1", kPpc, "degrees", 10, 20);
  const EstimateTrials estimates = estimatesIn(trialsOfTask(analysis_, "far"));
  EXPECT_STREQ(estimates.unit->name, "degrees");
  EXPECT_EQ(idsOf(estimates.trials), (std::vector<int64_t>{2, 3}));
  EXPECT_EQ(idsOf(estimates.missing), (std::vector<int64_t>{1}));
  EXPECT_EQ(unitOfEstimates({}), nullptr);
}

TEST_F(EstimatesByHand, ErrorsOfZeroCountWithHalfOfTheSmallest) {
  add("S1", kPpc, "degrees", 30, 30);
  add("S1", kPpc, "degrees", 34, 30);
  add("S1", kPpc, "degrees", 10, 30);
  PlannedModel model{"m", "far", ModelKind::kAbsoluteErrorMixed};
  const TrialList trials = trialsOfTask(analysis_, "far");
  const Estimable<ErrorResponse> response = errorResponse(model, trials);
  ASSERT_TRUE(response);
  EXPECT_EQ(response->zeros, 1);
  EXPECT_DOUBLE_EQ(response->zeroAs, 2);
  EXPECT_THAT(response->values, testing::ElementsAre(std::log(2.0), std::log(4.0), std::log(20.0)));
  EXPECT_THAT(notesOfErrors(model, trials, *response),
              testing::ElementsAre(testing::HasSubstr("1 of 3 estimates are exact")));
  analysis_.data.trials.resize(1);
  EXPECT_EQ(errorResponse(model, trialsOfTask(analysis_, "far")).reason(), "all estimates are exact");
  model.kind = ModelKind::kSignedErrorMixed;
  EXPECT_THAT(errorResponse(model, trialsOfTask(analysis_, "far"))->values, testing::ElementsAre(0.0));
}

TEST_F(EstimatesByHand, LargeErrorsOfDirectionsAreACaution) {
  for (int i = 0; i < 10; ++i) {
    add("S1", kPpc, "degrees", i == 0 ? 170 : 5, 0);
  }
  const PlannedModel model{"m", "far", ModelKind::kSignedErrorMixed};
  const TrialList trials = trialsOfTask(analysis_, "far");
  EXPECT_THAT(notesOfErrors(model, trials, *errorResponse(model, trials)),
              testing::ElementsAre(testing::HasSubstr("1 of 10 errors are beyond 90 degrees")));
}

TEST(MirroredEstimates, AreTheOtherHalf) {
  const EstimateUnit& degrees = estimateUnit("degrees", "test");
  const auto of = [&](double estimate, double truth) { return mirroredEstimate({&degrees, estimate, truth}); };
  EXPECT_TRUE(of(20, 160).isFront);
  EXPECT_EQ(of(20, 160).isFrontBack, true);
  EXPECT_EQ(of(20, 160).isLeftRight, false);
  EXPECT_TRUE(of(20, 160).isBeyondQuarter);
  EXPECT_EQ(of(330, 30).isLeftRight, true);
  EXPECT_EQ(of(330, 30).isFrontBack, false);
  EXPECT_FALSE(of(330, 30).isBeyondQuarter);
  EXPECT_EQ(of(100, 80).isFrontBack, std::nullopt) << "the truth is within 15 degrees of the axis";
  EXPECT_EQ(of(350, 5).isLeftRight, std::nullopt);
  EXPECT_FALSE(of(180, 180).isFront);
}

/// Without noise but for a little of each trial: the exponents that were put in.
TEST_F(EstimatesByHand, PowerLawHasTheExponentsOfConditions) {
  for (const char* subject : {"S1", "S2", "S3", "S4"}) {
    for (int i = 0; i < 8; ++i) {
      const double truth = 1 + i;
      const double wobble = std::exp(0.01 * std::sin(31.0 * i * (1 + subject[1])));
      add(subject, kPpc, "m", std::pow(truth, 0.9) * wobble, truth).caseIndex = i;
      add(subject, kGc, "m", 1.2 * std::pow(truth, 0.6) / wobble, truth).caseIndex = i;
    }
  }
  const Estimable<PowerLawFit> law = fitPowerLaw(defaultConditions(), estimatesIn(trialsOfTask(analysis_, "far")));
  ASSERT_TRUE(law);
  EXPECT_NEAR(law->conditions[0].exponent->value, 0.9, 0.01);
  EXPECT_NEAR(law->conditions[1].exponent->value, 0.6, 0.01);
  EXPECT_NEAR(law->conditions[1].difference->value, -0.3, 0.02);
  EXPECT_LT(law->conditions[1].difference->pValue, 0.001);
  for (Trial& trial : analysis_.data.trials) {
    trial.measures["truth_m"] = 2;
  }
  EXPECT_EQ(fitPowerLaw(defaultConditions(), estimatesIn(trialsOfTask(analysis_, "far"))).reason(),
            "all true lengths are the same");
}

TEST(ResponseScale, SaysHowEffectsAreShown) {
  const PlannedModel signedModel{"m", "far", ModelKind::kSignedErrorMixed};
  const PlannedModel absolute{"m", "far", ModelKind::kAbsoluteErrorMixed};
  const EstimateUnit& degrees = estimateUnit("degrees", "test");
  const EstimateUnit& metres = estimateUnit("m", "test");
  Estimate one;
  one.value = 1;
  EXPECT_EQ(shownEffect(responseScale(signedModel, &degrees), one).value, 1);
  EXPECT_EQ(shownEffect(responseScale(signedModel, &metres), one).value, std::exp(1.0));
  EXPECT_EQ(shownEffect(responseScale(absolute, &degrees), one).value, std::exp(1.0));
  EXPECT_STREQ(responseScale({"m", "find", ModelKind::kLogNormalMixed}, nullptr).one, "ratio of times");
  EXPECT_EQ(shownMean(responseScale({"m", "find", ModelKind::kBinomialMixed}, nullptr), Estimate{0.0}).value, 0.5);
}

}  // namespace
}  // namespace ocelli::test
