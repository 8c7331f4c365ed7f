#include "display_sim/viewer/effect_choice.h"

#include <gmock/gmock.h>

#include "display_sim/viewer/viewer_keys.h"
#include "oc_core/base/error.h"
#include "oc_core/shade/effects.h"

namespace ocelli {
namespace {

using testing::Contains;

ViewerState effectState(const std::string& camera = "ddoc") {
  return viewerState("builtin:mirror", {}, cameraChoice(camera), View{}, 72, 48, "test");
}

TEST(EffectChoice, theWayIsTheCameraUntilOneIsChosen) {
  ViewerState state = effectState();
  EXPECT_EQ(chosenWay(state), "");  // no effect yet
  chooseEffect(state, "reflection");
  EXPECT_TRUE(state.effect.on);
  EXPECT_EQ(chosenWay(state), "ddoc");
  chooseCamera(state, "cell");
  EXPECT_EQ(chosenWay(state), "cell");
  chooseEffectWay(state, "environment");
  chooseCamera(state, "di");
  EXPECT_EQ(chosenWay(state), "environment");
  chooseEffectWay(state, "");
  EXPECT_EQ(chosenWay(state), "di");
}

TEST(EffectChoice, aCameraThatAnEffectDoesNotTakeGivesWayToTheFirstOfTheList) {
  ViewerState state = effectState("geometry");
  chooseEffect(state, "reflection");
  EXPECT_EQ(chosenWay(state), effectWayNames("reflection").front());
}

TEST(EffectChoice, everyEffectHasAWayThatItTakes) {
  for (const std::string& name : effectNames()) {
    ViewerState state = effectState();
    chooseEffect(state, name);
    EXPECT_NO_THROW(shadeEffect(name).checkWay(chosenWay(state))) << name;
    EXPECT_THAT(effectWayNames(name), Contains("traced")) << name;
  }
}

TEST(EffectChoice, whatDoesNotExistIsAnErrorAndChangesNothing) {
  ViewerState state = effectState();
  EXPECT_THROW(chooseEffectWay(state, "cell"), InputError);  // no effect that takes it
  EXPECT_THROW(chooseEffect(state, "relefction"), InputError);
  EXPECT_FALSE(state.effect.on);
  chooseEffect(state, "reflection");
  EXPECT_THROW(chooseEffectWay(state, "no-such-way"), InputError);
  EXPECT_EQ(chosenWay(state), "ddoc");
}

TEST(EffectChoice, keysGoThroughAllWaysAndEffectsAndBack) {
  ViewerState state = effectState();
  applyAction(state, ViewerAction::kNextWay);
  EXPECT_EQ(state.effect, EffectShown{});  // there is no list without an effect
  applyAction(state, ViewerAction::kNextEffect);
  EXPECT_EQ(state.effect.effect, effectNames().front());
  const size_t count = effectWayNames(state.effect.effect).size();
  std::set<std::string> seen;
  for (size_t i = 0; i < count; ++i) {
    applyAction(state, ViewerAction::kNextWay);
    seen.insert(chosenWay(state));
  }
  EXPECT_EQ(seen.size(), count);
  EXPECT_EQ(chosenWay(state), "ddoc");
  applyAction(state, ViewerAction::kNextWay);
  applyAction(state, ViewerAction::kPreviousWay);
  EXPECT_EQ(chosenWay(state), "ddoc");
  for (size_t i = 0; i < effectNames().size(); ++i) {
    applyAction(state, ViewerAction::kNextEffect);
  }
  EXPECT_EQ(state.effect.effect, effectNames().front());
  applyAction(state, ViewerAction::kPreviousEffect);
  EXPECT_EQ(state.effect.effect, effectNames().back());
}

}  // namespace
}  // namespace ocelli
