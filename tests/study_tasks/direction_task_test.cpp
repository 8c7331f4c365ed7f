// Which way: bearings by hand, what shows when, and when an answer is right.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "study/tasks/task_registry.h"
#include "study/trial/estimated_value.h"
#include "tests/study_task/study_tasks.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

constexpr TrialScreen kDirectionScreen{640, 400, 60};

std::string directionJson(const std::string& start, const std::string& place, const std::string& more = "") {
  return R"({"maze": "small", "answer_limit_seconds": 5, "start": {)" + start + "}" + more +
         R"(, "cases": [{"label": "a", )" + place + "}]}";
}
const std::string kEast = R"("row": 2, "column": 0, "heading": "east")";
const std::string kWest = R"("row": 2, "column": 5, "heading": "west")";

double truthOf(const std::string& start, const std::string& place) {
  const auto block = test::readBlock("direction", directionJson(start, place));
  return std::stod(block->answerOf(test::planOf("direction", 0, TrialView::kReference)));
}

void point(TrialRun& run, double degrees) {
  run.handle(test::moveTo(test::placeOfAnswer(run.layout(), degrees, true)));
  run.handle(test::button(PointerButton::kLeft, true));
  run.handle(test::button(PointerButton::kLeft, false));
}

TEST(DirectionTask, TheTruthIsTheBearingFromWhereOneLooks) {
  const double aside = std::atan2(0.75, 6) * 180 / M_PI;
  // Looking east the north is left, looking west it is right. Places are of single precision.
  EXPECT_NEAR(truthOf(kEast, R"("row": 2, "column": 2, "south": -0.25)"), 360 - aside, 1e-4);
  EXPECT_NEAR(truthOf(kEast, R"("row": 2, "column": 2, "south": 0.25)"), aside, 1e-4);
  EXPECT_NEAR(truthOf(kWest, R"("row": 2, "column": 3, "south": -0.25)"), aside, 1e-4);
  EXPECT_NEAR(truthOf(kWest, R"("row": 2, "column": 3, "south": 0.25)"), 360 - aside, 1e-4);
  const double ahead = truthOf(kEast, R"("row": 2, "column": 2)");
  EXPECT_GE(ahead, 0);
  EXPECT_LT(ahead, 360);
  EXPECT_NEAR(wrappedDegrees(ahead), 0, 1e-4);
}

TEST(DirectionTask, ErrorsGoAroundTheTurn) {
  const auto block = test::readBlock("direction", directionJson(kEast, R"("row": 2, "column": 2, "south": -0.25)"));
  for (const auto& [degrees, right] :
       std::vector<std::pair<double, bool>>{{352, true}, {6, true}, {340, true}, {9, false}, {335, false}}) {
    const auto run = block->start(test::planOf("direction", 0, TrialView::kOther), kDirectionScreen);
    point(*run, degrees);
    run->handle(test::press(Key::kEnter));
    ASSERT_TRUE(run->outcome().has_value());
    EXPECT_EQ(run->outcome()->correct, right) << run->outcome()->answer;
    EXPECT_NEAR(wrappedDegrees(run->outcome()->measures.at("estimate_degrees") - degrees), 0, 0.05 + 1e-9)
        << "tenths of a degree";
  }
}

TEST(DirectionTask, KeysAloneAnswer) {
  const auto block = test::readBlock("direction", directionJson(kEast, R"("row": 2, "column": 2)"));
  const auto run = block->start(test::planOf("direction", 0, TrialView::kReference), kDirectionScreen);
  for (int i = 0; i < 3; ++i) {
    run->handle(test::press(Key::kLeft));
    run->handle(test::release(Key::kLeft));
  }
  run->handle(test::press(Key::kEnter));
  ASSERT_TRUE(run->outcome().has_value());
  EXPECT_EQ(run->outcome()->answer, "358");
  EXPECT_TRUE(run->outcome()->correct);
}

TEST(DirectionTask, WithoutAnExposureTheSceneShowsWhileOnePoints) {
  const auto block = test::readBlock("direction", directionJson(kEast, R"("row": 2, "column": 2)"));
  EXPECT_FALSE(block->caseInfo(0).exposureSeconds.has_value());
  const TrialLayout layout =
      block->start(test::planOf("direction", 0, TrialView::kReference), kDirectionScreen)->layout();
  EXPECT_EQ(layout.views.size(), 1u);
  ASSERT_TRUE(layout.dial.has_value());
  EXPECT_GE(layout.dial->place.left, layout.views.front().place.right());
  EXPECT_EQ(layout.targetObject, 0);
}

TEST(DirectionTask, AfterAnExposureOnePointsFromMemory) {
  const auto block =
      test::readBlock("direction", directionJson(kEast, R"("row": 2, "column": 2)", R"(, "exposure_seconds": 1)"));
  EXPECT_EQ(block->caseInfo(0).exposureSeconds, 1);
  EXPECT_EQ(block->caseInfo(0).longestSeconds, 6);
  const auto run = block->start(test::planOf("direction", 0, TrialView::kReference), kDirectionScreen);
  run->handle(test::press(Key::kRight));  // too early: there is no dial
  int64_t tick = 0;
  for (; !run->layout().dial; ++tick) {
    EXPECT_EQ(run->layout().views.size(), 1u);
    if (tick % 4 == 0) {
      run->frameShown(tick);
    }
    run->advance();
    ASSERT_LT(tick, 300);
  }
  EXPECT_NEAR(static_cast<double>(tick), 240, 4) << "a frame of 60 Hz";
  EXPECT_TRUE(run->layout().views.empty());
  EXPECT_FALSE(run->layout().dial->degrees);
  run->frameShown(tick);
  for (int i = 0; i < 100; ++i) {
    run->advance();
  }
  point(*run, 0);
  run->handle(test::press(Key::kEnter));
  ASSERT_TRUE(run->outcome().has_value());
  EXPECT_EQ(run->outcome()->responseTicks, 100) << "from the end of the exposure";
  EXPECT_EQ(run->outcome()->exposureFrames, 60);
}

TEST(DirectionTask, RefusesWhatIsNotSeen) {
  EXPECT_THAT(test::readError("direction", directionJson(kEast, R"("row": 4, "column": 0)")),
              HasSubstr("shows 0 pixels"));
  EXPECT_THAT(
      test::readError("direction", directionJson(kEast, R"("row": 2, "column": 2)", R"(, "exposure_seconds": 0)")),
      HasSubstr("exposure_seconds"));
}

}  // namespace
}  // namespace ocelli
