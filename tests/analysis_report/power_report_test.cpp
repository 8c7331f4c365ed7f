#include "analysis/report/power_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/report/html_report.h"
#include "analysis/report/report_task.h"

namespace ocelli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

PowerSize sizeOf(int subjects, int found, int studies = 100) {
  PowerSize size;
  size.subjects = subjects;
  size.analysed = subjects;
  size.found = {found, studies};
  size.estimate = 0.82;
  return size;
}

PowerStudy sampleStudy() {
  PowerStudy study;
  study.protocolName = "maze";
  study.task = "find";
  study.plan = defaultPlan();
  study.plan.families.clear();
  study.model = "find-time";
  study.simulations = 100;
  PowerCurve power;
  power.truth = "gc takes 0.8 of the time";
  power.trueValue = 0.8;
  power.sizes = {sizeOf(10, 40), sizeOf(20, 75), sizeOf(30, 95)};
  PowerCurve errors;
  errors.question = PowerCurve::Question::kFalseAlarm;
  errors.truth = "no effect of the view";
  errors.trueValue = 1;
  errors.sizes = {sizeOf(10, 5), sizeOf(20, 6), sizeOf(30, 4)};
  study.curves = {power, errors};
  return study;
}

TEST(PowerStudy, AnswersWithSubjectsOrSaysThatTheyAreTooFew) {
  PowerStudy study = sampleStudy();
  // 20 + 10 (0.80 - 0.75) / (0.95 - 0.75) = 22.5
  EXPECT_THAT(answerOf(study, study.curves[0]), HasSubstr("a power of 0.8 takes about 23 subjects"));
  study.power = 0.99;
  EXPECT_THAT(answerOf(study, study.curves[0]), HasSubstr("is not reached with 30 subjects"));
  study.power = 0.3;
  EXPECT_THAT(answerOf(study, study.curves[0]), HasSubstr("takes at most 10 subjects"));
}

TEST(PowerStudy, ErrorsArePooledOverSizes) {
  const PowerStudy study = sampleStudy();
  EXPECT_THAT(answerOf(study, study.curves[1]), HasSubstr("5.0 % of all studies find it though it is not there"));
  EXPECT_THAT(cautionsOf(study), IsEmpty());
}

TEST(PowerStudy, CautionsAgainstErrorsAboveAlphaAndMissingResults) {
  PowerStudy study = sampleStudy();
  study.curves[1].sizes[0].found.successes = 15;
  study.curves[0].sizes[0].notEstimable = 7;
  study.curves[0].sizes[0].reason = "all is the same";
  EXPECT_THAT(cautionsOf(study), ElementsAre(HasSubstr("7 of 300 studies had no result"),
                                             HasSubstr("With 10 subjects, 15.0 % of studies find what is not there")));
}

TEST(PowerStudy, CautionsWhereThePlanSharesAlphaAmongHypotheses) {
  PowerStudy study = sampleStudy();
  study.plan = defaultPlan();
  EXPECT_THAT(cautionsOf(study),
              ElementsAre(HasSubstr("The plan tests \"find-faster\" with 2 others in the family \"primary\"")));
}

TEST(PowerReport, IsMarkedAsSimulatedAndHoldsTheAnswer) {
  const PowerStudy study = sampleStudy();
  const ReportDocument document = powerReport(study, "1.2.3", "2026-01-01T00:00:00Z");
  EXPECT_EQ(document.marking, "Simulated studies");
  const std::string page = htmlReport(document);
  EXPECT_THAT(page, HasSubstr("a power of 0.8 takes about 23 subjects"));
  EXPECT_THAT(page, HasSubstr("they say nothing about people"));
  EXPECT_THAT(powerStudyFigure(study).description, HasSubstr("is reached at 30."));
}

}  // namespace
}  // namespace ocelli
