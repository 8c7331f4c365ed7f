// The window of `ocelli feeds run --window`: what it shows, and its keys.
#include "oc_core/feeds_window/feeds_window.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "oc_core/gl/gl_context.h"
#include "tests/base/temporary_folder.h"
#include "tests/feeds_window/composed_frames.h"
#include "tests/window/gui_window_checks.h"

namespace ocelli::test {
namespace {

class FeedsWindowTest : public testing::TestWithParam<GlProvider> {
 protected:
  FeedsWindowTest() {
    context_ = openGlContext(GetParam(), GlDebug::kErrorsAreFatal);
    window_ = std::make_unique<FeedsWindow>(*context_, frames_.graph(), screen_, folder_.path());
    window_->handle(ResizeEvent{640, 520, 1, 1});
  }
  ~FeedsWindowTest() override { window_.reset(); }

  void press(Key key) const {
    window_->handle(KeyEvent{key, true, {}});
    window_->handle(KeyEvent{key, false, {}});
    window_->update(0.01);
  }
  void show(int tone) {
    screen_.show(frames_.frame(seconds_ += 0.1, tone));
    window_->update(0.1);
  }
  /// Pixels of the image in the window that have not its tone.
  size_t pixelsDrawnOver(int tone) const {
    const Image<Rgb8> whole = drawn(*window_);
    size_t count = 0;
    for (int y = 0; y < window_->imageSize().y; ++y) {
      for (int x = 0; x < window_->imageSize().x; ++x) {
        count += whole(window_->imageCorner().x + x, window_->imageCorner().y + y) != Rgb8(static_cast<uint8_t>(tone));
      }
    }
    return count;
  }

  TemporaryFolder folder_;
  ComposedFrames frames_;
  FeedsScreen screen_{false};
  double seconds_ = 5;
  std::unique_ptr<GlContext> context_;
  std::unique_ptr<FeedsWindow> window_;
};

TEST_P(FeedsWindowTest, showsTheImageInItsOwnShape) {
  press(Key::kL);
  show(77);
  EXPECT_EQ(pixelsDrawnOver(77), 0u) << "without labels and outlines";
  EXPECT_NEAR(static_cast<double>(window_->imageSize().x) / window_->imageSize().y, 320.0 / 240, 0.01);
  EXPECT_LT(window_->imageCorner().y + window_->imageSize().y, 520) << "states stand below it";
  show(99);
  EXPECT_EQ(pixelsDrawnOver(99), 0u);
}

TEST_P(FeedsWindowTest, labelsAndOutlinesComeAndGo) {
  show(77);
  const size_t labels = pixelsDrawnOver(77);
  EXPECT_GT(labels, 1000u);
  press(Key::kO);
  const size_t both = pixelsDrawnOver(77);
  EXPECT_GT(both, labels + 500);
  press(Key::kL);
  EXPECT_LT(pixelsDrawnOver(77), both);
  press(Key::kO);
  EXPECT_EQ(pixelsDrawnOver(77), 0u);
}

/// The near faces are where the graph camera has them.
TEST_P(FeedsWindowTest, outlinesLieOnTheNearFaces) {
  press(Key::kL);
  press(Key::kO);
  show(0);
  const Image<Rgb8> whole = drawn(*window_);
  const double scale = window_->imageSize().x / 320.0;
  for (size_t i = 1; i < 3; ++i) {
    const auto& part = frames_.graph().camera().frusta()[i].part;
    for (size_t k = 0; k < part.size(); ++k) {
      const glm::dvec2 middle = 0.5 * (part[k] + part[(k + 1) % part.size()]) * scale;
      const glm::ivec2 at = window_->imageCorner() + glm::ivec2(middle);
      if (middle.x > 3 && middle.y > 3 && middle.x < window_->imageSize().x - 3 &&
          middle.y < window_->imageSize().y - 3) {
        EXPECT_GT(int{whole(at.x, at.y).g}, 100) << "frustum " << i << ", side " << k;
      }
    }
  }
}

TEST_P(FeedsWindowTest, eachStateLooksDifferent) {
  std::set<std::vector<uint8_t>> looks;
  for (const FeedState state :
       {FeedState::kLive, FeedState::kLate, FeedState::kFrozen, FeedState::kEnded, FeedState::kLost}) {
    for (FeedLabel& label : frames_.labels()) {
      label.state = state;
    }
    show(40);
    const Image<Rgb8> image = drawn(*window_);
    std::vector<uint8_t> gray;  // as one who sees no colours does: marks and words differ
    for (size_t i = 0; i < image.size(); ++i) {
      gray.push_back(static_cast<uint8_t>((299 * image[i].r + 587 * image[i].g + 114 * image[i].b) / 1000));
    }
    EXPECT_TRUE(looks.insert(gray).second);
  }
}

TEST_P(FeedsWindowTest, keysTellTheRun) {
  show(1);
  EXPECT_EQ(screen_.erased(), ErasedLook::kBackground);
  press(Key::kE);
  EXPECT_EQ(screen_.erased(), ErasedLook::kRed);
  press(Key::kE);
  EXPECT_EQ(screen_.erased(), ErasedLook::kBackground);
  press(Key::kSpace);
  EXPECT_TRUE(screen_.isPaused());
  press(Key::kP);
  EXPECT_FALSE(screen_.isPaused());
}

TEST_P(FeedsWindowTest, liveFeedsCannotBePaused) {
  FeedsScreen live(true);
  FeedsWindow window(*context_, frames_.graph(), live, folder_.path());
  window.handle(ResizeEvent{640, 520, 1, 1});
  window.handle(KeyEvent{Key::kSpace, true, {}});
  window.update(0.01);
  EXPECT_FALSE(live.isPaused());
  EXPECT_EQ(window.message(), "live feeds cannot be paused");
}

TEST_P(FeedsWindowTest, savesTheImageAsItIsShown) {
  press(Key::kS);
  EXPECT_EQ(window_->message(), "there is no image yet");
  show(77);
  press(Key::kL);
  drawn(*window_);
  press(Key::kS);
  const Image<Rgb8> saved = readPng(folder_ / "feeds-001.png");
  EXPECT_EQ(glm::ivec2(saved.width(), saved.height()), window_->imageSize());
  EXPECT_EQ(saved(saved.width() / 2, saved.height() - 1), Rgb8(77));
  press(Key::kO);
  press(Key::kH);
  press(Key::kS);
  const Image<Rgb8> second = readPng(folder_ / "feeds-002.png");
  EXPECT_NE(second, saved) << "with outlines";
  EXPECT_EQ(second(second.width() / 2, second.height() - 1), Rgb8(77)) << "and without the help";
  window_->update(60);
  EXPECT_EQ(window_->message(), "");
}

TEST_P(FeedsWindowTest, saysWhereItCannotSave) {
  FeedsWindow window(*context_, frames_.graph(), screen_, folder_ / "nowhere");
  window.handle(ResizeEvent{640, 520, 1, 1});
  screen_.show(frames_.frame(1, 1));
  window.update(0.1);
  window.handle(KeyEvent{Key::kS, true, {}});
  window.update(0.01);
  EXPECT_THAT(window.message(), testing::HasSubstr("nowhere"));
}

TEST_P(FeedsWindowTest, isDrawnForEachImageAndForTheEnd) {
  drawn(*window_);
  window_->update(0.1);
  EXPECT_FALSE(window_->needsDrawing());
  show(5);
  EXPECT_TRUE(window_->needsDrawing());
  drawn(*window_);
  EXPECT_FALSE(window_->needsDrawing());
  screen_.end();
  window_->update(0.1);
  EXPECT_TRUE(window_->needsDrawing());
}

TEST_P(FeedsWindowTest, hasTheKeysOfAnyWindow) {
  show(5);
  expectUsualKeys(*window_);
  expectNoKeyDoesTwoThings(feedsKeyActions());
}

INSTANTIATE_TEST_SUITE_P(Providers, FeedsWindowTest, testing::Values(GlProvider::kEgl, GlProvider::kOsMesa),
                         [](const auto& given) { return nameOf(given.param); });

}  // namespace
}  // namespace ocelli::test
