// What takes long is made beforehand: of which trials, and that they find it.
#include "study/session/trial_preparation.h"

#include <gtest/gtest.h>

#include "study/task/trial_image.h"

namespace ocelli::test {
namespace {

constexpr TrialScreen kPreparedScreen{320, 200, 60};

/// Two conditions, of which `other` is the second; two cases, one of practice, one example.
Protocol preparedProtocol(const std::string& other) {
  const std::string cases =
      R"([{"left": {"ahead_meters": 5, "right_meters": -0.25}, "right": {"ahead_meters": 6.2, "right_meters": 0.25}}])";
  return protocolFromJsonText(R"({"name": "prepared", "title": "Prepared",
      "mazes": {"hall": {"plan": ["+-+-+-+-+", "|       |", "+ +-+-+-+"]}},
      "conditions": [{"name": "plain", "view": "pinhole"}, {"name": "other", "view": )" +
                                  other + R"(}],
      "blocks": [{"name": "a", "title": "A", "task": "frontmost", "maze": "hall", "cases": [
          {"left": {"ahead_meters": 5, "right_meters": -0.25}, "right": {"ahead_meters": 6.2, "right_meters": 0.25}},
          {"left": {"ahead_meters": 6.2, "right_meters": -0.25}, "right": {"ahead_meters": 5, "right_meters": 0.25}}],
        "start": {"row": 0, "column": 0, "heading": "east"}, "practice": {"most_trials": 4},
        "practice_cases": )" + cases +
                                  R"(, "example_cases": )" + cases + R"(, "instructions":
        [{"title": "A", "paragraphs": ["Look"], "picture": {"condition": "other"}}]}]})",
                              "prepared");
}

TEST(TrialPreparation, MakesNothingWhereAllIsQuick) {
  const Protocol protocol = preparedProtocol(R"("graph")");
  EXPECT_EQ(prepareTrials(protocol, scheduleOf(protocol, 0, 1, 1), kPreparedScreen), 0);
}

TEST(TrialPreparation, MakesImagesOfTrialsPracticeAndPages) {
  const Protocol protocol = preparedProtocol(R"({"kind": "display", "profile": "test", "distance_meters": 5.6,
      "radius_meters": 2, "head": {"sway_degrees": 10, "images": 5}})");
  const SessionSchedule schedule = scheduleOf(protocol, 0, 1, 1);
  double last = 0;
  const int prepared = prepareTrials(protocol, schedule, kPreparedScreen, [&](std::string_view, double fraction) {
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1);
    last = fraction;
  });
  // Two cases, every second of four trials of practice, and a page.
  EXPECT_EQ(prepared, 2 + 2 + 1);
  EXPECT_GT(last, 0.5);
  // What they show is what a protocol shows of which nothing was made beforehand.
  const Protocol fresh = protocolFromJsonText(protocol.text, "again");
  for (const TrialPlan& plan : schedule.trials) {
    for (const int64_t tick : {0, 240}) {
      const auto imageOf = [&](const Protocol& of) {
        TrialLayout layout = of.blocks.front().task->start(plan, kPreparedScreen)->layout();
        layout.tick = tick;
        return viewsOf(layout, kPreparedScreen, rasterizeStudy);
      };
      EXPECT_EQ(imageOf(protocol), imageOf(fresh));
    }
  }
}

}  // namespace
}  // namespace ocelli::test
