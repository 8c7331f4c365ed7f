// What feedback says of answers that are numbers.
#include "study/session/session_pages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "study/trial/estimated_value.h"

namespace ocelli {
namespace {

using testing::ElementsAre;

TrialOutcome estimated(const char* unit, double estimate, double truth, bool correct) {
  TrialOutcome outcome;
  outcome.correct = correct;
  outcome.responseTicks = 3 * kTicksPerSecond;
  outcome.measures = measuresOf({&estimateUnit(unit, "test"), estimate, truth});
  return outcome;
}

TEST(FeedbackPage, TellsEstimatesAndTheirTruth) {
  const SubjectTexts english;
  EXPECT_THAT(feedbackPage(english, estimated("m", 5, 8.04, false)).paragraphs,
              ElementsAre("You said 5.0 m, and it was 8.0 m."));
  EXPECT_THAT(feedbackPage(english, estimated("m", 8.2, 8.04, true)).paragraphs,
              ElementsAre("It took you 3.0 seconds.", "You said 8.2 m, and it was 8.0 m."));
  EXPECT_THAT(feedbackPage(english, estimated("degrees", 350, 10.3, false)).paragraphs,
              ElementsAre("You pointed 20 degrees beside it."));
}

TEST(FeedbackPage, SaysNoMoreOfOtherAnswers) {
  TrialOutcome outcome;
  outcome.measures = {{"left_distance_m", 3}};
  EXPECT_TRUE(feedbackPage(SubjectTexts(), outcome).paragraphs.empty());
  outcome.correct = true;
  EXPECT_EQ(feedbackPage(SubjectTexts(), outcome).paragraphs.size(), 1u);
}

}  // namespace
}  // namespace ocelli
