#include "oc_core/explore_window/explore_keys.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "oc_core/explore_window/explore_pane.h"
#include "oc_core/explore_window/explore_pane_choice.h"
#include "tests/explore_window/recording_model.h"

namespace ocelli {
namespace {

TEST(ExploreKeys, noKeyStandsForTwoThings) {
  std::set<std::tuple<Key, bool, bool>> seen;
  for (const ExploreKeyAction& row : exploreKeyActions()) {
    EXPECT_TRUE(seen.insert({row.key, row.shift, row.control}).second) << nameOf(row.key);
  }
  // What is held counts with Shift as well.
  for (const ExploreHeldKey& row : exploreHeldKeys()) {
    for (const bool shift : {false, true}) {
      EXPECT_TRUE(seen.insert({row.key, shift, false}).second) << nameOf(row.key);
    }
  }
}

TEST(ExploreKeys, noButtonStandsForTwoThings) {
  std::set<int> seen;
  for (const ExploreKeyAction& row : exploreKeyActions()) {
    if (row.padButton >= 0) {
      EXPECT_TRUE(seen.insert(row.padButton).second) << row.padButton;
      EXPECT_EQ(exploreActionOfPadButton(row.padButton), &row);
    }
  }
  EXPECT_EQ(exploreActionOfPadButton(-1), nullptr);
}

/// A row that the help does not list follows one that lists it, and does something.
TEST(ExploreKeys, everyRowBelongsToALineOfTheHelp) {
  std::string group;
  for (const ExploreKeyAction& row : exploreKeyActions()) {
    EXPECT_NE(row.act, nullptr);
    if (*row.keys != '\0') {
      EXPECT_STRNE(row.meaning, "");
      group = row.group;
    }
    EXPECT_EQ(group, row.group) << nameOf(row.key);
  }
  group.clear();
  for (const ExploreHeldKey& row : exploreHeldKeys()) {
    EXPECT_NE(row.part, nullptr);
    if (*row.keys != '\0') {
      group = row.group;
    }
    EXPECT_EQ(group, row.group) << nameOf(row.key);
  }
}

TEST(ExploreKeys, keysAreFoundWithTheirModifiers) {
  const auto meaningOf = [](const KeyEvent& event) {
    const ExploreKeyAction* action = exploreActionOf(event);
    return action == nullptr ? "" : action->keys;
  };
  EXPECT_STREQ(meaningOf({Key::kM, true, {}}), "M");
  EXPECT_STREQ(meaningOf({Key::kM, false, {}}), "");
  EXPECT_STREQ(meaningOf({Key::kM, true, {.alt = true}}), "");
  EXPECT_STREQ(meaningOf({Key::kQ, true, {}}), "");
  EXPECT_STREQ(meaningOf({Key::kQ, true, {.control = true}}), "Ctrl + Q");
  EXPECT_STREQ(meaningOf({Key::kW, true, {}}), "");  // it is held
}

class ExploreKeyPress : public testing::Test {
 protected:
  void press(Key key, Modifiers modifiers = {}) {
    ExploreKeyTarget target{state, work, wishes, status.picture.get()};
    const ExploreKeyAction* action = exploreActionOf({key, true, modifiers});
    ASSERT_NE(action, nullptr);
    action->act(target, action->argument);
    work.step(0);
    status = work.status();
  }
  void SetUp() override {
    work.step(0);
    status = work.status();
  }

  test::ModelRecord record;
  ExploreWindowState state;
  ExploreWindowWork work{[this](const Progress&) { return test::makeRecordingModel(record); },
                         ExploreWindowWork::Way::kStepwise};
  ExploreWindowWishes wishes;
  ExploreWindowStatus status;
};

TEST_F(ExploreKeyPress, numbersChooseCamerasThatThereAre) {
  press(Key::k2);
  press(Key::k9);
  EXPECT_EQ(record.calls, std::vector<std::string>{"choose 1"});
  EXPECT_EQ(status.picture->chosen, 1U);
}

TEST_F(ExploreKeyPress, theNextCameraAfterTheLastIsTheFirst) {
  press(Key::kT);
  press(Key::kT);
  press(Key::kT);
  press(Key::kT, {.shift = true});
  EXPECT_EQ(record.calls, (std::vector<std::string>{"choose 1", "choose 2", "choose 0", "choose 2"}));
}

TEST_F(ExploreKeyPress, optionsChangeByTheirStepsAlsoWithTheFormClosed) {
  press(Key::kMinus);  // the pinhole has none
  press(Key::k2);
  press(Key::kEqual);
  press(Key::kJ);
  press(Key::kMinus);
  EXPECT_EQ(record.calls, (std::vector<std::string>{"choose 1", "change amount 1", "change reach -1"}));
  EXPECT_EQ(state.formRow, 1U);
  EXPECT_TRUE(state.form);
}

TEST_F(ExploreKeyPress, escapeLeavesOneThingAtATime) {
  state.help = state.captured = state.form = true;
  press(Key::kEscape);
  EXPECT_FALSE(state.help);
  EXPECT_TRUE(state.captured);
  press(Key::kEscape);
  EXPECT_FALSE(state.captured);
  EXPECT_TRUE(state.form);
  press(Key::kEscape);
  EXPECT_FALSE(state.form);
}

TEST_F(ExploreKeyPress, planZoomHasLimits) {
  for (int i = 0; i < 40; ++i) {
    press(Key::kZ);
  }
  EXPECT_FLOAT_EQ(state.planZoom, 32);
  for (int i = 0; i < 40; ++i) {
    press(Key::kZ, {.shift = true});
  }
  EXPECT_FLOAT_EQ(state.planZoom, 1);
}

TEST_F(ExploreKeyPress, panesGoAndComeBack) {
  state.active = "plan";
  press(Key::kM);
  EXPECT_FALSE(state.shown.contains("plan"));
  EXPECT_EQ(state.active, "view");
  press(Key::kM);
  EXPECT_TRUE(state.shown.contains("plan"));
}

TEST_F(ExploreKeyPress, onePaneThatNeedsTheRoomHidesTheOthersMeanwhile) {
  press(Key::kTab);
  const auto before = state.shown;
  EXPECT_EQ(before.size(), 2U);
  press(Key::kG);
  EXPECT_EQ(state.shown.size(), 1U);
  const std::string alone = *state.shown.begin();
  EXPECT_EQ(state.active, alone);
  press(Key::kF6);
  EXPECT_NE(state.active, alone);
  press(Key::kF6);
  EXPECT_EQ(state.active, alone);
  press(Key::kG);
  EXPECT_EQ(state.shown, before);
  EXPECT_NE(state.active, alone);
}

TEST(ExplorePanes, rowsHaveNamesOfTheirOwnAndTheLargeOneTakesKeys) {
  std::set<std::string> names;
  for (const ExplorePaneKind& kind : explorePanes()) {
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
  }
  EXPECT_TRUE(explorePanes().front().takesKeys);
  EXPECT_EQ(mainExplorePane(), explorePanes().front().name);
  EXPECT_FALSE(firstExplorePanes().contains(mainExplorePane()));
}

TEST_F(ExploreKeyPress, enterPicksTheMiddle) {
  press(Key::kEnter);
  EXPECT_EQ(record.calls, std::vector<std::string>{"pick 640 360"});  // of 1280 x 720
}

}  // namespace
}  // namespace ocelli
