#include "oc_core/explore_window/explore_window_work.h"

#include <gtest/gtest.h>

#include <chrono>

#include "oc_core/base/error.h"
#include "tests/explore_window/recording_model.h"

namespace ocelli {
namespace {

using Way = ExploreWindowWork::Way;

ExploreWindowWork::Make recording(test::ModelRecord& record) {
  return [&record](const Progress&) { return test::makeRecordingModel(record); };
}

/// Until it is so; fails the test where that takes longer than a machine in trouble would need.
template <class IsDone>
void waitUntil(const IsDone& isDone) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!isDone()) {
    ASSERT_LT(std::chrono::steady_clock::now(), end);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

TEST(ExploreWindowWork, turnsAddUpUntilAFrameTakesThem) {
  test::ModelRecord record;
  ExploreWindowWork work(recording(record), Way::kStepwise);
  work.want({.turnedDegrees = {2, 1}}, {});
  work.want({.ahead = 1, .turnedDegrees = {3, 0}}, {});
  work.step(0.5);
  EXPECT_EQ(record.motion.turnedDegrees, glm::vec2(5, 1));
  EXPECT_EQ(record.motion.ahead, 1);
  work.step(0.5);
  EXPECT_EQ(record.turned, glm::vec2(5, 1));
  EXPECT_EQ(record.motion.ahead, 1);  // it is still held
  EXPECT_EQ(record.seconds, 1);
}

TEST(ExploreWindowWork, errorsOfTasksAreMessagesAndTheOthersGoOn) {
  test::ModelRecord record;
  ExploreWindowWork work(recording(record), Way::kStepwise);
  work.tell([](ExploreWindowModel& model) {
    model.setField("amount", 1000);
    return std::string("set");
  });
  work.tell([](ExploreWindowModel&) { return std::string("done"); });
  work.tell([](ExploreWindowModel&) { return std::string(); });
  work.step(0);
  const ExploreWindowStatus status = work.status();
  ASSERT_EQ(status.messages.size(), 2U);
  EXPECT_TRUE(status.messages[0].isError);
  EXPECT_NE(status.messages[0].text.find("amount"), std::string::npos);
  EXPECT_EQ(status.messages[1].text, "done");
  EXPECT_FALSE(status.messages[1].isError);
  EXPECT_TRUE(work.status().messages.empty());  // told once
  EXPECT_EQ(status.pictureCount, 1U);
}

TEST(ExploreWindowWork, theThreadDrawsUntilNothingIsWanted) {
  test::ModelRecord record;
  ExploreWindowWork work(recording(record), Way::kThread);
  work.want({}, {});
  waitUntil([&] { return work.status().pictureCount == 1; });
  waitUntil([&] { return !work.isBusy(); });
  work.want({.ahead = 1}, {});
  waitUntil([&] { return work.status().pictureCount > 3; });
  work.want({}, {});
  waitUntil([&] { return !work.isBusy(); });
  const uint64_t count = work.status().pictureCount;
  std::this_thread::sleep_for(std::chrono::milliseconds(60));
  EXPECT_EQ(work.status().pictureCount, count);
}

TEST(ExploreWindowWork, whatCannotBeMadeIsThrownToWhoLooks) {
  ExploreWindowWork work(
      [](const Progress&) -> std::unique_ptr<ExploreWindowModel> {
        throw InputError("is not a scene", "a.txt", "give another");
      },
      Way::kThread);
  EXPECT_THROW(waitUntil([&] { return work.status().pictureCount > 0; }), InputError);
  EXPECT_FALSE(work.isBusy());
}

TEST(ExploreWindowWork, closingEndsLongWorkWhereItTellsHowFarItIs) {
  bool ended = false;
  {
    ExploreWindowWork work(
        [&](const Progress& progress) -> std::unique_ptr<ExploreWindowModel> {
          struct AtTheEnd {
            bool& flag;
            ~AtTheEnd() { flag = true; }
          } const end{ended};
          while (true) {
            report(progress, "reading the scene", 0.5);
          }
        },
        Way::kThread);
    waitUntil([&] { return work.status().stage == "reading the scene"; });
    EXPECT_EQ(work.status().fraction, 0.5);
  }
  EXPECT_TRUE(ended);
}

}  // namespace
}  // namespace ocelli
