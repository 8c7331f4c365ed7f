// The window of `ocelli sea view`: a walk, its keys and mouse, and its pictures.
#include "oc_core/sea_window/sea_window.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <thread>

#include "oc_core/gl/gl_context.h"
#include "oc_core/sea/sea_build.h"
#include "tests/base/temporary_folder.h"
#include "tests/sea/made_sea.h"
#include "tests/window/gui_window_checks.h"

namespace ocelli {
namespace {

class SeaWindowTest : public testing::TestWithParam<GlProvider> {
 protected:
  SeaWindowTest() {
    buildSea(images_, test::roomProxy(), test::settingsOf(images_), folder_ / "room.sea");
    sea_ = std::make_unique<SeaFile>(folder_ / "room.sea");
    context_ = openGlContext(GetParam(), GlDebug::kErrorsAreFatal);
    window_ = std::make_unique<SeaWindow>(*context_, *sea_, nullptr, true);
    window_->handle(ResizeEvent{640, 400, 1, 1});
  }
  ~SeaWindowTest() override { window_.reset(); }

  void press(Key key, bool pressed = true, bool shift = false) const {
    window_->handle(KeyEvent{key, pressed, {.shift = shift}});
  }
  void hold(Key key, double seconds, bool shift = false) const {
    press(key, true, shift);
    window_->update(seconds);
    press(key, false, shift);
  }
  SeaVisit& visit() const { return window_->visit(); }

  test::TemporaryFolder folder_;
  test::RoomImages images_{test::gridPoses(5, 4, 0.15), {.width = 128, .height = 128}};
  std::unique_ptr<SeaFile> sea_;
  std::unique_ptr<GlContext> context_;
  std::unique_ptr<SeaWindow> window_;
};

TEST_P(SeaWindowTest, showsWhatIsSeenFromThere) {
  window_->draw();
  press(Key::kM);  // without the map
  window_->draw();
  const Image<Rgb8> shown = window_->screenshot();
  ASSERT_EQ(shown.width(), 640);
  // As a pinhole sees it, of 60 degrees.
  const SeaProjection projection{SeaProjectionKind::kPinhole, 640, 400, glm::dvec2(200 / std::tan(3.14159265 / 6)),
                                 glm::dvec2(320, 200)};
  const test::RoomImages truth({images_.poses()[0]}, projection);
  const Image<Rgb8> expected = truth.image(0);
  double sum = 0;
  for (int y = 0; y < 300; ++y) {  // above the line of facts
    for (int x = 0; x < 640; ++x) {
      sum += std::abs(int{shown(x, y).g} - int{expected(x, y).g}) / (300.0 * 640.0);
    }
  }
  EXPECT_LT(sum, 6) << "an image of 128 pixels around, shown large";
  visit().turn(0.2, 0);
  window_->draw();
  EXPECT_GT(test::meanDifference(window_->screenshot(), expected), 2 * test::meanDifference(shown, expected))
      << "who looks elsewhere sees something else";
}

TEST_P(SeaWindowTest, walksAndTurnsWhileKeysAreHeld) {
  visit().goToImage(12);
  const glm::dvec3 start = visit().place();
  hold(Key::kW, 0.1);
  EXPECT_LT(visit().place().z, start.z) << "ahead is -z";
  EXPECT_NEAR(visit().place().x, start.x, 1e-9);
  const double slow = start.z - visit().place().z;
  visit().goToImage(12);
  hold(Key::kUp, 0.1, true);
  EXPECT_NEAR(start.z - visit().place().z, 4 * slow, 1e-9) << "faster with Shift";
  window_->update(1);
  EXPECT_NEAR(start.z - visit().place().z, 4 * slow, 1e-9) << "nothing is held any more";
  hold(Key::kQ, 0.5);
  EXPECT_GT(visit().yaw(), 0.1);
  visit().goToImage(12);
  visit().turn(3.14159265358979 / 2 - visit().yaw(), 0);
  hold(Key::kW, 0.1);
  EXPECT_LT(visit().place().x, start.x) << "to the left is -x";
  hold(Key::kR, 100);
  EXPECT_LT(visit().pitch(), 1.5) << "not over the head";
}

TEST_P(SeaWindowTest, nobodyLeavesTheSea) {
  hold(Key::kW, 100);
  const glm::dvec3& nearest = visit().positions()[visit().nearest()];
  EXPECT_LT(glm::distance(visit().place(), nearest), 3 * visit().spacing() + 1e-9);
}

TEST_P(SeaWindowTest, goesFromImageToImage) {
  press(Key::kN);
  EXPECT_EQ(visit().nearest(), 1u);
  press(Key::kP);
  press(Key::kP);
  EXPECT_EQ(visit().nearest(), 19u) << "round the end";
  press(Key::kHome);
  EXPECT_EQ(visit().nearest(), 0u);
}

TEST_P(SeaWindowTest, theMouseLooksAroundAndTheMapTakesOneThere) {
  window_->draw();
  window_->handle(PointerMoveEvent{100, 200});
  window_->handle(PointerButtonEvent{PointerButton::kLeft, true, {}});
  window_->handle(PointerMoveEvent{140, 200});
  window_->handle(PointerButtonEvent{PointerButton::kLeft, false, {}});
  EXPECT_NEAR(visit().yaw(), 0.1 * 3.14159265 / 2, 1e-6) << "what one drags stays below the pointer";
  window_->handle(ScrollEvent{0, 3});
  EXPECT_LT(visit().fovVertical(), 1);
  // The lower right corner of the map is the last image.
  window_->handle(PointerMoveEvent{640 - 12 - 14.0, 12 + 240 - 40.0});
  window_->handle(PointerButtonEvent{PointerButton::kLeft, true, {}});
  for (int i = 0; i < 12; ++i) {  // Dear ImGui takes one change of a button a frame
    window_->draw();
  }
  window_->handle(PointerButtonEvent{PointerButton::kLeft, false, {}});
  EXPECT_EQ(visit().nearest(), 19u);
}

TEST_P(SeaWindowTest, noKeyIsHeldWithoutTheFocus) {
  visit().goToImage(12);
  window_->draw();
  const glm::dvec3 start = visit().place();
  press(Key::kW);
  window_->loseFocus();
  window_->update(1);
  EXPECT_EQ(visit().place(), start);
}

TEST_P(SeaWindowTest, isDrawnWhileItMovesUntilItRests) {
  const auto drawsUntilItRests = [&](SeaWindow& window) {
    int draws = 0;
    for (window.update(0.01); window.needsDrawing() && draws < 1000; window.update(0.01)) {
      window.draw();
      ++draws;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return draws;
  };
  EXPECT_LE(drawsUntilItRests(*window_), 2);
  press(Key::kW);
  for (int i = 0; i < 10; ++i) {
    window_->update(0.01);
    EXPECT_TRUE(window_->needsDrawing()) << i;
    window_->draw();
  }
  press(Key::kW, false);
  EXPECT_LE(drawsUntilItRests(*window_), 2);
  SeaWindow decoding(*context_, *sea_);
  decoding.handle(ResizeEvent{640, 400, 1, 1});
  EXPECT_LT(drawsUntilItRests(decoding), 1000);
  const Image<Rgb8> atRest = decoding.screenshot();
  EXPECT_EQ(test::drawn(decoding), atRest) << "panels have the sizes of their texts";
}

TEST_P(SeaWindowTest, hasTheKeysOfAnyWindow) {
  test::expectUsualKeys(*window_);
  test::expectNoKeyDoesTwoThings(seaHeldKeys(), seaKeyActions());
}

INSTANTIATE_TEST_SUITE_P(Providers, SeaWindowTest, testing::Values(GlProvider::kEgl, GlProvider::kOsMesa),
                         [](const auto& given) { return nameOf(given.param); });

}  // namespace
}  // namespace ocelli
