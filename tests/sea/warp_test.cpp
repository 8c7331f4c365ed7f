// Warps over the proxy: the fast ones against the exact ones, and against images that are known.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "oc_core/base/random.h"
#include "oc_core/sea/cubic_weights.h"
#include "oc_core/sea/near_atan.h"
#include "oc_core/sea/warp_map.h"
#include "oc_core/sea/warped_image.h"
#include "tests/sea/made_sea.h"

namespace ocelli {
namespace {

using test::meanDifference;
using test::RoomImages;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

const SeaProjection kPanorama{.width = 256, .height = 128};
const SeaProjection kPinhole{SeaProjectionKind::kPinhole, 200, 120, {150, 150}, {100, 60}};

SeaPose poseAt(double x, double z, double yaw = 0) {
  return {{x, 0, z}, glm::angleAxis(yaw, glm::dvec3(0, 1, 0))};
}

/// The distance of two places of a panorama may go round.
float distanceOf(glm::vec2 a, const glm::vec2& b, const SeaProjection& projection) {
  if (projection.wraps()) {
    const auto width = static_cast<float>(projection.width);
    a.x -= width * std::round((a.x - b.x) / width);
  }
  return glm::distance(a, b);
}

struct MapDifference {
  double seenByOne = 0;  ///< share of the pixels
  double far = 0;        ///< share of the pixels that are more than half a pixel apart
};

MapDifference differenceOf(const WarpMap& a, const WarpMap& b, const SeaProjection& projection) {
  MapDifference difference;
  const double each = 1.0 / static_cast<double>(a.size());
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      if (isSeen(a(x, y)) != isSeen(b(x, y))) {
        difference.seenByOne += each;
      } else if (isSeen(a(x, y))) {
        // Next to a pole a pixel is many columns wide.
        const double wide = projection.wraps() ? std::sin(3.14159 * (y + 0.5) / a.height()) : 1;
        difference.far += wide * distanceOf(a(x, y), b(x, y), projection) > 0.5 ? each : 0;
      }
    }
  }
  return difference;
}

TEST(NearAtan2, IsNearTheAngle) {
  Random random(9);
  for (int i = 0; i < 100000; ++i) {
    const float y = random.inRange(-1, 1);
    const float x = random.inRange(-1, 1);
    ASSERT_NEAR(nearAtan2(y, x), std::atan2(y, x), 1e-6) << y << " " << x;
  }
  EXPECT_EQ(nearAtan2(0, 0), 0);
  EXPECT_NEAR(nearAtan2(1, 0), std::atan2(1.0f, 0.0f), 1e-6);
  EXPECT_NEAR(nearAtan2(0, -1), std::atan2(0.0f, -1.0f), 1e-6);
}

TEST(WarpMap, FromItsOwnPlaceEveryPixelStaysWhereItIs) {
  const SeaProxy room(test::roomProxy());
  for (const SeaProjection& projection : {kPanorama, kPinhole}) {
    const WarpMap map = makeWarpMap(room, {projection, poseAt(0.1, 0.2, 0.3)}, {projection, poseAt(0.1, 0.2, 0.3)});
    for (int y = 0; y < map.height(); ++y) {
      for (int x = 0; x < map.width(); ++x) {
        ASSERT_TRUE(isSeen(map(x, y))) << x << " " << y;
        const glm::vec2 pixel = glm::vec2(x, y) + 0.5f;
        EXPECT_LT(
            distanceOf(map(x, y), pixel, projection) * (projection.wraps() ? std::sin(3.14159f * pixel.y / 128) : 1.0f),
            0.01f)
            << x << " " << y;
      }
    }
  }
}

TEST(WarpMap, IsCloseToTheExactOne) {
  const SeaProxy room(test::roomProxy());
  for (const SeaProjection& projection : {kPanorama, kPinhole}) {
    const SeaPose target = poseAt(0.1, 0.6, 0.2);
    const SeaPose reference = poseAt(-0.3, 0.3, 0.1);
    const WarpMap exact = exactWarpMap(room, {projection, target}, {projection, reference});
    const MapDifference fine =
        differenceOf(makeWarpMap(room, {projection, target}, {projection, reference}), exact, projection);
    EXPECT_LT(fine.seenByOne, 0.01);
    EXPECT_LT(fine.far, 0.01);
    // A reference that stands two centimetres elsewhere is told from it.
    const MapDifference other =
        differenceOf(makeWarpMap(room, {projection, target}, {projection, poseAt(-0.28, 0.3, 0.1)}), exact, projection);
    EXPECT_GT(other.far, 0.05);
  }
}

TEST(WarpMap, APinholeLooksIntoAPanorama) {
  const SeaProxy room(test::roomProxy());
  const SeaCamera target{kPinhole, poseAt(0.1, 0.6, 0.2)};
  const SeaCamera reference{kPanorama, poseAt(-0.3, 0.3, 0.1)};
  const MapDifference difference =
      differenceOf(makeWarpMap(room, target, reference), exactWarpMap(room, target, reference), kPanorama);
  EXPECT_LT(difference.seenByOne, 0.01);
  EXPECT_LT(difference.far, 0.01);
}

TEST(WarpMap, TellsWhatTheReferenceDoesNotSee) {
  const SeaProxy room(test::roomProxy());
  const WarpMap map = exactWarpMap(room, {kPanorama, poseAt(0.1, 1.5)}, {kPanorama, poseAt(0.1, -1.5)});
  size_t unseen = 0;
  for (const glm::vec2& place : map) {
    unseen += isSeen(place) ? 0 : 1;
  }
  // What the pillar hides from one of them, from the other it does not.
  EXPECT_GT(unseen, map.size() / 100);
  EXPECT_LT(unseen, map.size() / 4);
}

TEST(WarpMap, WithoutAProxyOnlyTurnsMatter) {
  const SeaProxy none{Mesh{}};
  const WarpMap map = makeWarpMap(none, {kPanorama, poseAt(5, 5, 0)}, {kPanorama, poseAt(0, 0, 3.14159265358979 / 2)});
  // What lies straight ahead is a quarter of a turn to the right of who looks to the left.
  EXPECT_LT(distanceOf(map(128, 64), {128.5f + 64, 64.5f}, kPanorama), 0.5f);
}

TEST(WarpMap, APinholeSeesNothingBeyondItsBorders) {
  const SeaProxy room(test::roomProxy());
  const WarpMap map = makeWarpMap(room, {kPinhole, poseAt(0, 0, 0.5)}, {kPinhole, poseAt(0, 0, 0)});
  EXPECT_FALSE(isSeen(map(0, 60))) << "far to the left of what the reference looks at";
  EXPECT_TRUE(isSeen(map(199, 60)));
}

TEST(WarpedImage, IsWhatIsSeenFromThere) {
  const RoomImages images({poseAt(-0.2, 0.3), poseAt(0.1, 0.4, 0.7)}, {.width = 256, .height = 256});
  const SeaProxy room(test::roomProxy());
  const WarpReference reference(images.image(0), images.projection());
  PartialImage warped = warpedOver(room, reference, images.poses()[0], {images.projection(), images.poses()[1]}, 8);
  const WarpMap map =
      makeWarpMap(room, {images.projection(), images.poses()[1]}, {images.projection(), images.poses()[0]}, 8);
  EXPECT_EQ(warped.image, warpedImage(reference, map));
  for (size_t i = 0; i < map.size(); ++i) {
    ASSERT_EQ(warped.isKnown[i] != 0, isSeen(map[i]));
  }
  fillUnknown(warped);
  const double error = meanDifference(warped.image, images.image(1));
  EXPECT_LT(error, 3);
  EXPECT_GT(meanDifference(images.image(0), images.image(1)), 10 * error) << "without the warp they differ much";
}

TEST(WarpedImage, IsWhatPlainStepsGive) {
  Random random(3);
  Image<Rgb8> noise(256, 128);
  for (Rgb8& pixel : noise) {
    pixel = Rgb8(random.below(256), random.below(256), random.below(256));
  }
  WarpMap map(64, 64);
  for (glm::vec2& place : map) {
    place = {random.inRange(-300, 600), random.inRange(0, 128)};
  }
  map(3, 4) = glm::vec2(kNaN);
  const WarpReference reference(noise, kPanorama);
  const Image<Rgb8> fast = warpedImage(reference, map);
  const Image<Rgb8> plain = plainWarpedImage(reference, map);
  for (size_t i = 0; i < map.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      ASSERT_LE(std::abs(int{fast[i][c]} - int{plain[i][c]}), 1) << i;
    }
  }
  EXPECT_EQ(fast(3, 4), Rgb8(0));
}

TEST(WarpedImage, ItsRimGoesRoundAndOverThePoles) {
  Image<Rgb8> image(256, 128);
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 256; ++x) {
      image(x, y) = Rgb8(x, y, 7);
    }
  }
  const WarpReference reference(image, kPanorama);
  const auto at = [&](int x, int y) { return glm::ivec2(reference.at(x, y)[0], reference.at(x, y)[1]); };
  EXPECT_EQ(at(-1, 50), glm::ivec2(255, 50));
  EXPECT_EQ(at(257, 50), glm::ivec2(1, 50));
  EXPECT_EQ(at(10, -1), glm::ivec2(138, 0)) << "over the pole, on the other side";
  EXPECT_EQ(at(200, 129), glm::ivec2(72, 126));
  EXPECT_EQ(reference.image(), image);
  const WarpReference flat(image, {SeaProjectionKind::kPinhole, 256, 128, {100, 100}, {128, 64}});
  EXPECT_EQ(flat.at(-2, 50).r, 0);
  EXPECT_EQ(flat.at(10, -1).g, 0);
}

TEST(WarpedImage, CubicWeightsSumUpToOneAndKeepPixels) {
  for (const float fraction : {0.0f, 0.1f, 0.5f, 0.99f}) {
    const auto weights = cubicWeights(fraction);
    EXPECT_NEAR(weights[0] + weights[1] + weights[2] + weights[3], 1, 1e-6);
    // Straight lines stay straight.
    EXPECT_NEAR(-weights[0] + weights[2] + 2 * weights[3], fraction, 1e-6);
  }
  EXPECT_THAT(cubicWeights(0), testing::ElementsAre(0, 1, 0, 0));
}

TEST(FillUnknown, GoesOnWithWhatIsAround) {
  PartialImage partial{Image<Rgb8>(64, 64, Rgb8(0)), Image<uint8_t>(64, 64, 0)};
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      if (x < 20 || x >= 44) {
        partial.isKnown(x, y) = 1;
        partial.image(x, y) = x < 20 ? Rgb8(200, 100, 0) : Rgb8(0, 100, 200);
      }
    }
  }
  fillUnknown(partial);
  EXPECT_EQ(partial.image(10, 10), Rgb8(200, 100, 0)) << "what is known stays";
  EXPECT_GT(partial.image(21, 30).r, partial.image(42, 30).r);
  for (int x = 20; x < 44; ++x) {
    EXPECT_NEAR(partial.image(x, 30).g, 100, 1) << x;
  }
}

TEST(FillUnknown, IsGreyWhereNothingIsKnown) {
  PartialImage partial{Image<Rgb8>(10, 10, Rgb8(0)), Image<uint8_t>(10, 10, 0)};
  fillUnknown(partial);
  EXPECT_EQ(partial.image(5, 5), Rgb8(128));
}

}  // namespace
}  // namespace ocelli
