// The window of `ocelli feeds edit`: what mouse and keys do, and what it shows.
#include "oc_core/feeds_editor_window/face_window.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/gl/gl_context.h"
#include "tests/feeds/made_setup.h"
#include "tests/window/gui_window_checks.h"

namespace ocelli::test {
namespace {

class FaceWindowTest : public testing::TestWithParam<GlProvider> {
 protected:
  FaceWindowTest() : editor_(tSetup(), {{"corner of a wall", {-1.2, 0}}}) {
    context_ = openGlContext(GetParam(), GlDebug::kErrorsAreFatal);
    FaceWindowOptions options;
    options.walls = {{{{-9, 0}, {-1.2f, 0}}}, {{{-1.2f, 0}, {-1.2f, 6}}}, {{{-9, -2.4f}, {9, -2.4f}}}};
    for (const int tone : {60, 140, 220}) {
      options.frames.emplace_back(640, 480, Rgb8(static_cast<uint8_t>(tone)));
    }
    options.save = [this](const FeedSetup& setup) {
      if (failsToSave_) {
        throw WorkError("the disk is full", "setup.json", "make room");
      }
      saved_ = setup;
      return std::string("wrote setup.json");
    };
    window_ = std::make_unique<FaceWindow>(*context_, editor_, options);
    window_->handle(ResizeEvent{1000, 600, 1, 1});
  }
  ~FaceWindowTest() override { window_.reset(); }

  void press(Key key, const Modifiers& modifiers = {}) const {
    window_->handle(KeyEvent{key, true, modifiers});
    window_->handle(KeyEvent{key, false, {}});
  }
  void drag(const glm::dvec2& from, const glm::dvec2& to, bool release = true) const {
    const glm::dvec2 a = window_->windowFromPlan(from);
    const glm::dvec2 b = window_->windowFromPlan(to);
    window_->handle(PointerMoveEvent{a.x, a.y});
    window_->handle(PointerButtonEvent{PointerButton::kLeft, true, {.shift = true}});
    window_->handle(PointerMoveEvent{b.x, b.y});
    if (release) {
      window_->handle(PointerButtonEvent{PointerButton::kLeft, false, {}});
    }
  }
  PlanFace left() const { return editor_.faces()[0]; }
  static size_t count(const Image<Rgb8>& image, const Rgb8& color) {
    size_t found = 0;
    for (size_t i = 0; i < image.size(); ++i) {
      found += image[i] == color ? 1 : 0;
    }
    return found;
  }

  FaceEditor editor_;
  std::optional<FeedSetup> saved_;
  bool failsToSave_ = false;
  std::unique_ptr<GlContext> context_;
  std::unique_ptr<FaceWindow> window_;
};

TEST_P(FaceWindowTest, showsTheImageOfTheFirstFrames) {
  const Image<Rgb8> image = drawn(*window_);
  for (const int tone : {60, 140, 220}) {
    EXPECT_GT(count(image, Rgb8(static_cast<uint8_t>(tone))), 1000u) << tone;
  }
}

TEST_P(FaceWindowTest, theMouseMovesFaces) {
  const size_t before = count(drawn(*window_), Rgb8(140));
  drag(left().from, {-0.9, -0.4});
  EXPECT_LT(glm::distance(left().from, {-0.9, -0.4}), 0.03);
  EXPECT_EQ(editor_.problem(), "");
  EXPECT_LT(count(drawn(*window_), Rgb8(140)), before) << "the image follows: its part is smaller";
  press(Key::kZ, {.control = true});
  EXPECT_EQ(editor_.setup(), tSetup());
  press(Key::kY, {.control = true});
  EXPECT_LT(glm::distance(left().from, {-0.9, -0.4}), 0.03);
}

TEST_P(FaceWindowTest, snapsWithoutShift) {
  editor_.select("left");
  drag(left().from, {-2, 0.5});
  const glm::dvec2 a = window_->windowFromPlan(left().from);
  const glm::dvec2 b = window_->windowFromPlan({-1.22, 0.02});
  window_->handle(PointerMoveEvent{a.x, a.y});
  window_->handle(PointerButtonEvent{PointerButton::kLeft, true, {}});
  window_->handle(PointerMoveEvent{b.x, b.y});
  ASSERT_TRUE(editor_.snap());
  EXPECT_EQ(editor_.snap()->what, "corner of a wall");
  drawn(*window_);
  window_->handle(PointerButtonEvent{PointerButton::kLeft, false, {}});
  EXPECT_LT(glm::distance(left().from, {-1.2, 0}), 1e-9);
}

TEST_P(FaceWindowTest, showsProblemsAndDoesNotSaveThem) {
  const Image<Rgb8> good = drawn(*window_);
  drag(left().from, {1.0, -0.4});
  EXPECT_NE(editor_.problem(), "");
  EXPECT_NE(drawn(*window_), good);
  press(Key::kS, {.control = true});
  EXPECT_FALSE(saved_);
  EXPECT_THAT(window_->message(), testing::HasSubstr("not saved"));
  press(Key::kZ, {.control = true});
  press(Key::kS, {.control = true});
  EXPECT_EQ(saved_, tSetup());
  EXPECT_EQ(window_->message(), "wrote setup.json");
  failsToSave_ = true;
  press(Key::kS, {.control = true});
  EXPECT_THAT(window_->message(), testing::HasSubstr("the disk is full"));
}

TEST_P(FaceWindowTest, escapeLetsGoThenClosesTheHelpThenAsksThenCloses) {
  drag(left().from, {-2, 1}, false);
  press(Key::kEscape);
  EXPECT_EQ(editor_.setup(), tSetup());
  EXPECT_FALSE(window_->wantsClose());
  window_->handle(PointerButtonEvent{PointerButton::kLeft, false, {}});
  press(Key::kH);
  drawn(*window_);
  press(Key::kEscape);
  EXPECT_FALSE(window_->wantsClose());
  drag(left().from, {-1.1, -0.2});
  press(Key::kEscape);
  EXPECT_FALSE(window_->wantsClose()) << "it is not saved";
  EXPECT_THAT(window_->message(), testing::HasSubstr("not saved"));
  press(Key::kEscape);
  EXPECT_TRUE(window_->wantsClose());
}

TEST_P(FaceWindowTest, thePlanZoomsAndMoves) {
  const glm::dvec2 before = window_->windowFromPlan({0, 0});
  window_->handle(PointerMoveEvent{100, 100});
  window_->handle(PointerButtonEvent{PointerButton::kRight, true, {}});
  window_->handle(PointerMoveEvent{130, 80});
  window_->handle(PointerButtonEvent{PointerButton::kRight, false, {}});
  EXPECT_LT(glm::distance(window_->windowFromPlan({0, 0}), before + glm::dvec2(30, -20)), 1e-6);
  const double length = glm::distance(window_->windowFromPlan({0, 0}), window_->windowFromPlan({1, 0}));
  window_->handle(ScrollEvent{0, 2});
  EXPECT_GT(glm::distance(window_->windowFromPlan({0, 0}), window_->windowFromPlan({1, 0})), 1.2 * length);
  press(Key::kA);
  drawn(*window_);
  EXPECT_LT(glm::distance(window_->windowFromPlan({0, 0}), before), 1e-6);
}

TEST_P(FaceWindowTest, keysChangeTheSelectedFace) {
  press(Key::kTab);
  EXPECT_EQ(editor_.selected(), "left");
  press(Key::kUp);
  EXPECT_GT(left().top, 2.8);
  press(Key::kUp, {.shift = true});
  EXPECT_GT(left().bottom, 0);
  press(Key::kDelete);
  EXPECT_EQ(editor_.faces().size(), 1u);
  drawn(*window_);
}

TEST_P(FaceWindowTest, theButtonOfTheWindowAsksToo) {
  drag(left().from, {-1.1, -0.2});
  window_->handle(CloseEvent());
  EXPECT_FALSE(window_->wantsClose());
  EXPECT_THAT(window_->message(), testing::HasSubstr("not saved"));
  press(Key::kS, {.control = true});
  window_->handle(CloseEvent());
  EXPECT_TRUE(window_->wantsClose());
}

TEST_P(FaceWindowTest, hasTheKeysOfAnyWindow) {
  expectUsualKeys(*window_);
  expectNoKeyDoesTwoThings(faceKeyActions());
}

INSTANTIATE_TEST_SUITE_P(Providers, FaceWindowTest, testing::Values(GlProvider::kEgl, GlProvider::kOsMesa),
                         [](const auto& given) { return nameOf(given.param); });

}  // namespace
}  // namespace ocelli::test
