#include "analysis/power/power_effects.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/base/error.h"
#include "study/subject/generator_truth.h"
#include "tests/analysis_power/small_protocol.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using testing::Contains;
using testing::HasSubstr;

class PowerEffects : public testing::Test {
 protected:
  Truth truthOf(const SupposedEffects& supposed) const { return wantedTruth(protocol_, supposed); }
  std::string problemOf(const SupposedEffects& supposed) const {
    try {
      truthOf(supposed);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  static SupposedEffects of(const std::string& task) {
    SupposedEffects supposed;
    supposed.task = task;
    return supposed;
  }

  Protocol protocol_ = test::smallProtocol();
};

TEST_F(PowerEffects, OfSearchesAreRatiosAndSeconds) {
  SupposedEffects supposed = of("find");
  supposed.ratio = 0.8;
  supposed.secondsPpc = 20;
  supposed.subjectSd = 0.4;
  supposed.caseSd = 0.2;
  const Truth truth = truthOf(supposed);
  EXPECT_NEAR(truth.effects.at("find", "graph"), std::log(0.8), 1e-12);
  EXPECT_NEAR(truth.reference, 20, 1e-9);
  EXPECT_NEAR(truth.other, 16, 1e-9);
  EXPECT_EQ(truth.effects.at("find", "subject_sd"), 0.4);
  EXPECT_EQ(truth.effects.at("find", "item_sd"), 0.2);
  EXPECT_EQ(truth.effects.at("find", "residual_sd"), GeneratorEffects().at("find", "residual_sd"));
  EXPECT_EQ(truth.label, "gc takes 0.8 of the time");
  const Truth none = truthWithoutEffect(protocol_, "find", truth);
  EXPECT_EQ(none.kind, Truth::Kind::kNone);
  EXPECT_NEAR(none.other, 20, 1e-9);
}

TEST_F(PowerEffects, AreSaidInTheNamesOfTheStudysConditions) {
  protocol_.text.replace(
      protocol_.text.find('{'), 1,
      R"({"conditions": [{"name": "flat", "label": "flat view"}, {"name": "bent", "label": "bent view"}],)");
  SupposedEffects supposed = of("find");
  supposed.ratio = 0.8;
  const Truth truth = truthOf(supposed);
  EXPECT_EQ(truth.label, "bent takes 0.8 of the time");
  EXPECT_THAT(describeTruth(truth, "find").front(), HasSubstr("s with the flat view and "));
  supposed = of("count");
  supposed.oddsRatio = 1;
  EXPECT_THAT(describeTruth(truthOf(supposed), "count").front(), HasSubstr("% right with bent, "));
}

TEST_F(PowerEffects, OfAnswersAreTheSharesThatWereAskedFor) {
  for (const char* task : {"count", "path"}) {
    SupposedEffects supposed = of(task);
    supposed.sharePpc = 0.44;
    supposed.shareGc = 0.9;
    const Truth truth = truthOf(supposed);
    EXPECT_NEAR(shareRight(protocol_, truth.effects, task, TrialView::kReference), 0.44, 1e-9);
    EXPECT_NEAR(shareRight(protocol_, truth.effects, task, TrialView::kOther), 0.9, 1e-9);
    // Shares of all subjects lie closer together than those of one, so its odds ratio is larger.
    EXPECT_GT(truth.effect, (0.9 / 0.1) / (0.44 / 0.56));
  }
}

TEST_F(PowerEffects, CasesMayDifferInTheEffectOfTheView) {
  SupposedEffects supposed = of("find");
  supposed.ratio = 0.8;
  EXPECT_THAT(describeTruth(truthOf(supposed), "find"),
              Contains(HasSubstr("cases differ by 0.35, and all have the same effect of the view")));
  supposed.caseViewSd = 0.4;
  EXPECT_EQ(truthOf(supposed).effects.at("find", "item_view_sd"), 0.4);
  EXPECT_THAT(describeTruth(truthOf(supposed), "find"),
              Contains(std::string("cases differ by 0.35, and in the effect of the view by 0.4")));
  for (const char* task : {"count", "path"}) {
    supposed = of(task);
    supposed.sharePpc = 0.6;
    supposed.shareGc = 0.8;
    supposed.caseViewSd = 0.7;
    const Truth truth = truthOf(supposed);
    EXPECT_EQ(truth.effects.at(task, "item_view_sd"), 0.7);
    EXPECT_NEAR(shareRight(protocol_, truth.effects, task, TrialView::kOther), 0.8, 1e-9);
    EXPECT_THAT(describeTruth(truth, task), Contains(HasSubstr("in the effect of the view by 0.7")));
    // Without an effect shares are the same in both views, as cases gain or lose as often.
    const Truth none = truthWithoutEffect(protocol_, task, truth);
    EXPECT_NEAR(none.other, none.reference, 1e-12);
  }
}

TEST_F(PowerEffects, EqualSharesAreNoEffect) {
  SupposedEffects supposed = of("path");
  supposed.sharePpc = 0.7;
  supposed.shareGc = 0.7;
  EXPECT_EQ(truthOf(supposed).kind, Truth::Kind::kNone);
  EXPECT_EQ(truthOf(supposed).effect, 1);
}

TEST_F(PowerEffects, AtTheBoundSharesDifferByIt) {
  SupposedEffects supposed = of("path");
  supposed.sharePpc = 0.7;
  supposed.oddsRatio = 1;
  const PlannedEquivalence bounds{"path", -0.1, 0.15};
  const auto above = truthAtBound(protocol_, truthOf(supposed), bounds);
  ASSERT_TRUE(above);
  EXPECT_NEAR(above->other - above->reference, 0.15, 1e-9);
  supposed.sharePpc = 0.9;  // 1.05 is no share
  const auto below = truthAtBound(protocol_, truthOf(supposed), bounds);
  ASSERT_TRUE(below);
  EXPECT_NEAR(below->other - below->reference, -0.1, 1e-9);
  EXPECT_FALSE(truthAtBound(protocol_, truthOf(supposed), {"path", -0.95, 0.95}));
}

TEST_F(PowerEffects, OptionsComeOnTopOfTheFile) {
  const test::TemporaryFolder folder;
  folder.write("effects.json", R"({"find": {"subject_sd": 0.7, "item_sd": 0.6, "graph": -2}})");
  SupposedEffects supposed = of("find");
  supposed.file = (folder / "effects.json").string();
  supposed.ratio = 0.9;
  supposed.caseSd = 0.1;
  const Truth truth = truthOf(supposed);
  EXPECT_EQ(truth.effects.at("find", "subject_sd"), 0.7);
  EXPECT_EQ(truth.effects.at("find", "item_sd"), 0.1);
  EXPECT_NEAR(truth.effect, 0.9, 1e-12);
}

TEST_F(PowerEffects, RejectWhatDoesNotFitTogether) {
  EXPECT_THAT(problemOf(of("find")), HasSubstr("which effect is it that studies should find?"));
  EXPECT_THAT(problemOf(of("count")), HasSubstr("which effect is it that studies should find?"));
  SupposedEffects supposed = of("count");
  supposed.ratio = 0.8;
  EXPECT_THAT(problemOf(supposed), HasSubstr("--ratio: this option is not for --task count"));
  supposed = of("find");
  supposed.ratio = 0.8;
  supposed.sharePpc = 0.5;
  EXPECT_THAT(problemOf(supposed), HasSubstr("--share-ppc: this option is not for --task find"));
  supposed = of("path");
  supposed.oddsRatio = 2;
  supposed.shareGc = 0.5;
  EXPECT_THAT(problemOf(supposed), HasSubstr("both say what the effect is"));
}

}  // namespace
}  // namespace ocelli
