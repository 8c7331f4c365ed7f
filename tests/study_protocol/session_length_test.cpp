#include "study/protocol/session_length.h"

#include <gtest/gtest.h>

#include "tests/study_protocol/sham_protocol.h"

namespace ocelli::test {
namespace {

Protocol twoBlocks() {
  Protocol protocol = shamProtocol({shamBlock("a", 5, TrialOrder::kBalanced, ViewsOfCases::kAll),
                                    shamBlock("b", 4, TrialOrder::kBalanced, ViewsOfCases::kOne)},
                                   false, 2);
  protocol.blocks[0].breakEveryTrials = 4;
  protocol.breakSeconds = 30;
  return protocol;
}

TEST(SessionLength, HasBreaksWithinBlocksAndBetweenThem) {
  const Protocol protocol = twoBlocks();
  const SessionSchedule schedule = scheduleOf(protocol, 0, 1, 1);
  std::vector<size_t> breaks;
  for (size_t i = 0; i < schedule.trials.size(); ++i) {
    if (hasBreakAfter(protocol, schedule, i)) {
      breaks.push_back(i);
    }
  }
  EXPECT_EQ(breaks, (std::vector<size_t>{3, 7, 9}));  // after 4 and 8 trials of the first block, and after it
}

TEST(SessionLength, AddsUpTrialsPracticeAndBreaks) {
  Protocol protocol = twoBlocks();
  protocol.blocks[1].practice = ProtocolPractice{shamTask(1), 2, 6};
  const std::vector<PartLength> parts = partsOf(protocol, scheduleOf(protocol, 0, 1, 1));
  ASSERT_EQ(parts.size(), 4u);
  EXPECT_EQ(parts[1].name, "a");
  EXPECT_EQ(parts[1].trials, 10);
  EXPECT_DOUBLE_EQ(parts[1].duration.typicalSeconds, 10 * 11.5);  // trials of 10 s and 1.5 s between them
  EXPECT_DOUBLE_EQ(parts[1].duration.longestSeconds, 10 * 35.0);
  EXPECT_DOUBLE_EQ(parts[2].duration.typicalSeconds, (4 + 2) * 11.5);
  EXPECT_DOUBLE_EQ(parts[2].duration.longestSeconds, (4 + 6) * 35.0);
  EXPECT_DOUBLE_EQ(parts[3].duration.typicalSeconds, 3 * 30.0);
  EXPECT_DOUBLE_EQ(durationOf(parts).typicalSeconds, 10 * 11.5 + 6 * 11.5 + 90);
}

TEST(SessionLength, AsksDemographicsFirstAndTheSurveyLast) {
  Protocol protocol = twoBlocks();
  protocol.demographics = ProtocolForm{"demographics", "You", "", {{"age", "Age?", {"a", "b"}, {}}}};
  protocol.survey = ProtocolForm{"survey", "Views", "", {{"easy", "Easier?", {"1", "2"}, {}}}};
  const std::vector<PartLength> first = partsOf(protocol, scheduleOf(protocol, 0, 1, 1));
  const std::vector<PartLength> last = partsOf(protocol, scheduleOf(protocol, 0, 2, 1));
  EXPECT_GT(first.front().duration.typicalSeconds, last.front().duration.typicalSeconds);
  EXPECT_EQ(first.back().name, "breaks");
  EXPECT_EQ(last.back().name, "survey");
  protocol.surveyAfterLastSessionOnly = false;
  EXPECT_EQ(partsOf(protocol, scheduleOf(protocol, 0, 1, 1)).back().name, "survey");
}

}  // namespace
}  // namespace ocelli::test
