#include "oc_core/feeds/subject_memory.h"

#include <gtest/gtest.h>

#include "tests/feeds/made_blobs.h"
#include "tests/feeds/made_setup.h"

namespace ocelli {
namespace {

constexpr double kMemoryStep = 1.0 / 15;
constexpr size_t kLeft = 1;  ///< the feed, and its frustum
constexpr Rgb8 kFloor{100};

using MadeBodies = std::vector<test::MadeBody>;

/// The feeds of a T in which bodies stand, and who is hidden in each.
class Remembered {
 public:
  Remembered() {
    for (size_t i = 0; i < graph_.setup().feeds.size(); ++i) {
      portraits_.emplace_back(graph_, i);
    }
  }

  void see(const MadeBodies& bodies, double seconds, double light = 1) {
    for (const double end = seconds_ + seconds; seconds_ < end - kMemoryStep / 2; seconds_ += kMemoryStep) {
      const auto blobs = test::allBlobs(graph_.setup(), bodies);
      tracks_.update(blobs, seconds_);
      for (size_t i = 0; i < portraits_.size(); ++i) {
        portraits_[i].look(tracks_, frameOf(blobs[i], light), glm::dvec3(light), seconds_);
      }
      hidden_.update(tracks_, portraits_, seconds_);
    }
  }

  Image<Rgb8> shown() {
    const Feed& feed = graph_.setup().feeds[kLeft];
    return hidden_.in(Image<Rgb8>(feed.width, feed.height, kFloor));
  }
  /// Pixels that are not the floor, and their mean place.
  std::pair<size_t, glm::dvec2> foreground() {
    const Image<Rgb8> image = shown();
    size_t count = 0;
    glm::dvec2 sum(0);
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        if (image(x, y) != kFloor) {
          ++count;
          sum += glm::dvec2(x, y) + 0.5;
        }
      }
    }
    return {count, sum / std::max<double>(1, static_cast<double>(count))};
  }
  const FeedGraph& graph() const { return graph_; }
  const HiddenSubjects& hidden() const { return hidden_; }
  const SubjectTracks& tracks() const { return tracks_; }
  double seconds() const { return seconds_; }

 private:
  /// The colours of the cells, in another light, on the floor.
  static Image<Rgb8> frameOf(const FeedBlobs& blobs, double light) {
    Image<Rgb8> frame(blobs.core.width() * blobs.scale, blobs.core.height() * blobs.scale, kFloor);
    for (int y = 0; y < frame.height(); ++y) {
      for (int x = 0; x < frame.width(); ++x) {
        if (blobs.core(x / blobs.scale, y / blobs.scale) > 0) {
          frame(x, y) = Rgb8(glm::dvec3(blobs.colors(x / blobs.scale, y / blobs.scale)) * light);
        }
      }
    }
    return frame;
  }

  FeedGraph graph_{test::tSetup()};
  SubjectTracks tracks_{graph_};
  std::vector<SubjectPortraits> portraits_;
  HiddenSubjects hidden_{graph_, kLeft};
  double seconds_ = 0;
};

// The camera of the left branch stands at x = 5 and looks along the branches. One stands in its branch; the other walks
// in the right branch, which is before its near face, and so is erased from its feed.
constexpr glm::dvec3 kFar{-2.5, 0, -1.2};
constexpr glm::dvec3 kBeside{2.5, 0, -0.4};
constexpr glm::dvec3 kBefore{2.5, 0, -1.2};

TEST(SubjectMemory, whoIsHiddenIsShownAsHeWas) {
  Remembered feeds;
  feeds.see({{kFar, test::kRed}}, 1);
  EXPECT_EQ(feeds.foreground().first, 0u) << "nobody hides him";
  const double seenAt = feeds.seconds();
  feeds.see({{kFar, test::kRed}, {kBefore, test::kBlue}}, 0.5);
  const auto [count, middle] = feeds.foreground();
  const auto expected = feedPixelOf(feeds.graph().setup().feeds[kLeft], kFar + glm::dvec3(0, 0.8, 0));
  ASSERT_TRUE(expected);
  EXPECT_GT(count, 1000u);
  EXPECT_NEAR(middle.x, expected->x, 6);
  EXPECT_NEAR(middle.y, expected->y, 15);  // made bodies have larger heads than people
  const Image<Rgb8> image = feeds.shown();
  EXPECT_EQ(image(static_cast<int>(expected->x), static_cast<int>(expected->y)), test::kRed);
  const auto at = feeds.hidden().at(glm::ivec2(*expected));
  ASSERT_TRUE(at);
  EXPECT_EQ(at->feed, kLeft);
  EXPECT_LT(at->seconds, seenAt + kMemoryStep);
  EXPECT_LT(glm::length(glm::dvec2(at->pixel) - *expected), 8) << "he stands still";
  EXPECT_FALSE(feeds.hidden().at({0, 0}));
}

TEST(SubjectMemory, pixelsHaveTheLightOfTheBackground) {
  Remembered feeds;
  feeds.see({{kFar, test::kRed}}, 1, 0.5);
  feeds.see({{kFar, test::kRed}, {kBefore, test::kBlue}}, 0.5, 1);
  const auto at = feedPixelOf(feeds.graph().setup().feeds[kLeft], kFar + glm::dvec3(0, 0.8, 0));
  const Image<Rgb8> image = feeds.shown();
  const glm::ivec3 pixel(image(static_cast<int>(at->x), static_cast<int>(at->y)));
  for (int channel = 0; channel < 3; ++channel) {
    EXPECT_NEAR(pixel[channel], test::kRed[channel], 2);  // half levels were rounded
  }
}

TEST(SubjectMemory, whoIsBesideOrBeforeTheFaceIsNot) {
  Remembered feeds;
  feeds.see({{kFar, test::kRed}}, 1);
  feeds.see({{kFar, test::kRed}, {kBeside, test::kBlue}}, 1);
  EXPECT_EQ(feeds.foreground().first, 0u) << "nobody hides anybody";
  // Both before the near face: the farther one is erased as well.
  Remembered before;
  const glm::dvec3 second(1.8, 0, -1.2);
  before.see({{second, test::kRed}}, 1);
  before.see({{second, test::kRed}, {{3.3, 0, -1.2}, test::kBlue}}, 0.5);
  ASSERT_EQ(before.tracks().count(), 2u);
  EXPECT_EQ(before.foreground().first, 0u);
}

TEST(SubjectMemory, isForgottenWithItsSubject) {
  Remembered feeds;
  feeds.see({{kFar, test::kRed}}, 1);
  feeds.see({{kFar, test::kRed}, {kBefore, test::kBlue}}, 0.5);
  EXPECT_GT(feeds.foreground().first, 1000u);
  feeds.see({}, 3);
  EXPECT_EQ(feeds.tracks().count(), 0u);
  EXPECT_EQ(feeds.foreground().first, 0u);
  // They are others when they come back, and this feed has not seen the far one: another one shows him.
  feeds.see({{kFar, test::kRed}, {kBefore, test::kBlue}}, 0.2);
  EXPECT_GT(feeds.foreground().first, 1000u);
  const auto at = feeds.hidden().at(glm::ivec2(feeds.foreground().second));
  ASSERT_TRUE(at);
  EXPECT_NE(at->feed, kLeft);
}

}  // namespace
}  // namespace ocelli
