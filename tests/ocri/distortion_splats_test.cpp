#include "oc_core/ocri/distortion_splats.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

constexpr int kSplatSize = 40;

DistortionSplat splat(const glm::vec2& position, const glm::vec2& normal, float hidden, float room) {
  return {{position, normal, 0.2f, 0.1f}, hidden, room};
}

/// Splats anywhere, with any normal and bands.
std::vector<DistortionSplat> randomSplats(size_t count, unsigned seed) {
  std::mt19937 random(seed);
  const auto next = [&](float most) { return most * static_cast<float>(random() >> 8) / static_cast<float>(1 << 24); };
  std::vector<DistortionSplat> splats;
  for (size_t i = 0; i < count; ++i) {
    const float x = next(kSplatSize);
    const float y = next(kSplatSize);
    const float angle = next(2 * static_cast<float>(kPi));
    const float hidden = next(20);
    splats.push_back(splat({x, y}, {std::cos(angle), std::sin(angle)}, hidden, next(12)));
  }
  return splats;
}

// "the distortion value d_f can be found using a bias and scale operation d_f = (r - x) / 2" (3.2.2, step 6)
TEST(DistortionSplat, equalBandsAreTheTexts) {
  const DistortionSplat s = splat({0, 0}, {1, 0}, 15, 15);
  for (float x = -15; x <= 15; x += 0.5f) {
    EXPECT_NEAR(s.displacementAt(x), (15 - x) / 2, 1e-5f);
  }
}

TEST(DistortionSplat, squeezesTheBandIntoItsRoom) {
  for (const auto& [hidden, room] : {std::pair(15.0f, 15.0f), {6.0f, 2.0f}, {1.0f, 8.0f}, {48.0f, 16.0f}}) {
    const DistortionSplat s = splat({0, 0}, {1, 0}, hidden, room);
    const auto moved = [&](float x) { return x + s.displacementAt(x); };
    EXPECT_NEAR(moved(-hidden), 0, 1e-4f) << "the deepest hidden sample comes to the edge";
    EXPECT_NEAR(moved(room), room, 1e-4f) << "the outermost visible one stays";
    float last = -1e-3f;
    for (int i = 0; i <= 100; ++i) {
      const float x = -hidden + (hidden + room) * static_cast<float>(i) / 100;
      EXPECT_GT(moved(x), last);
      last = moved(x);
    }
  }
}

TEST(DistortionSplat, nothingHiddenMovesNothing) {
  EXPECT_EQ(splat({0, 0}, {1, 0}, 0, 0).displacementAt(0), 0);
  EXPECT_EQ(splat({0, 0}, {1, 0}, 0, 5).displacementAt(2), 0);
}

TEST(ClaimPixels, nearestCentreWins) {
  const std::vector<DistortionSplat> splats = randomSplats(60, 1);
  const SplatOwners owners = claimPixels(splats, kSplatSize, kSplatSize);
  int claimed = 0;
  for (int y = 0; y < kSplatSize; ++y) {
    for (int x = 0; x < kSplatSize; ++x) {
      int expected = -1;
      float nearest = 1e30f;
      for (size_t i = 0; i < splats.size(); ++i) {
        const glm::vec2 offset =
            glm::vec2(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f) - splats[i].edge.position;
        const float side = glm::dot(offset, splats[i].edge.normal);
        const bool reaches =
            glm::length(offset) <= splats[i].reach() && side >= -splats[i].hidden && side <= splats[i].room;
        if (reaches && glm::length(offset) < nearest) {
          nearest = glm::length(offset);
          expected = static_cast<int>(i);
        }
      }
      EXPECT_EQ(owners(x, y), expected) << x << " " << y;
      claimed += expected >= 0;
    }
  }
  EXPECT_GT(claimed, kSplatSize * kSplatSize / 2);
}

/// Two vertical edges at x = 10 and x = 10 + distance.
std::vector<DistortionSplat> pair(float distance, float leftNormal, float leftRoom, float rightNormal,
                                  float rightRoom) {
  return {splat({10, 20.5f}, {leftNormal, 0}, leftRoom, leftRoom),
          splat({10 + distance, 20.5f}, {rightNormal, 0}, rightRoom, rightRoom)};
}

size_t settle(std::vector<DistortionSplat>& splats, float maxHiddenPerRoom, Conflicts conflicts = Conflicts::kFacing) {
  return shrinkConflicts(splats, claimPixels(splats, kSplatSize, kSplatSize), conflicts, maxHiddenPerRoom);
}

TEST(ShrinkConflicts, facingRoomsMeetHalfWay) {
  for (const Conflicts conflicts : {Conflicts::kFacing, Conflicts::kAll}) {
    auto splats = pair(10, 1, 8, -1, 8);
    EXPECT_EQ(settle(splats, 1, conflicts), 2u);
    for (const DistortionSplat& s : splats) {
      EXPECT_FLOAT_EQ(s.room, 5);
      EXPECT_FLOAT_EQ(s.hidden, 5) << "hidden follows";
    }
  }
}

// On both sides of an occluder of six pixels: a conflict for the text, none for the better variant.
TEST(ShrinkConflicts, backToBackIsAConflictInTheTextOnly) {
  auto all = pair(6, -1, 8, 1, 8);
  EXPECT_EQ(settle(all, 1, Conflicts::kAll), 2u);
  EXPECT_FLOAT_EQ(all[0].room, 3);
  EXPECT_FLOAT_EQ(all[1].hidden, 3);
  auto facing = pair(6, -1, 8, 1, 8);
  EXPECT_EQ(settle(facing, 1, Conflicts::kFacing), 0u);
  EXPECT_FLOAT_EQ(facing[0].room, 8);
}

TEST(ShrinkConflicts, theSmallerOneKeepsWhatItHas) {
  auto splats = pair(10, 1, 8, -1, 3);
  EXPECT_EQ(settle(splats, 1), 1u);
  EXPECT_FLOAT_EQ(splats[0].room, 7);
  EXPECT_FLOAT_EQ(splats[1].room, 3);
}

TEST(ShrinkConflicts, hiddenIsSqueezedNoHarderThanAllowed) {
  auto splats = pair(10, 1, 8, -1, 8);
  splats[0].hidden = 30;
  settle(splats, 3);
  EXPECT_FLOAT_EQ(splats[0].hidden, 15);
  EXPECT_FLOAT_EQ(splats[1].hidden, 8);
}

TEST(ShrinkConflicts, splatsThatDoNotFaceEachOtherKeepTheirRooms) {
  auto parallel = pair(6, 1, 8, 1, 8);
  EXPECT_EQ(settle(parallel, 1), 0u);
  EXPECT_EQ(settle(parallel, 1, Conflicts::kAll), 0u) << "normals of one direction";
  auto apart = pair(17, 1, 8, -1, 8);
  EXPECT_EQ(settle(apart, 1), 0u);
}

// Distance in steps of 1 and sqrt(2) from pixel to pixel.
float chamfer(const glm::vec2& a, const glm::vec2& b) {
  const float dx = std::abs(std::floor(a.x) - std::floor(b.x));
  const float dy = std::abs(std::floor(a.y) - std::floor(b.y));
  return std::max(dx, dy) + (std::sqrt(2.0f) - 1) * std::min(dx, dy);
}

TEST(LimitBandGrowth, boundsTheGrowthBetweenAnyTwoSplats) {
  for (const float growth : {0.1f, 0.5f, 3.0f}) {
    const std::vector<DistortionSplat> before = randomSplats(50, 7);
    std::vector<DistortionSplat> after = before;
    limitBandGrowth(after, growth);
    for (size_t i = 0; i < after.size(); ++i) {
      float hidden = 1e30f;
      float room = 1e30f;
      for (size_t j = 0; j < before.size(); ++j) {
        const float most = growth * chamfer(before[i].edge.position, before[j].edge.position);
        EXPECT_LE(after[i].hidden, after[j].hidden + most + 1e-3f);
        EXPECT_LE(after[i].room, after[j].room + most + 1e-3f);
        hidden = std::min(hidden, before[j].hidden + most);
        room = std::min(room, before[j].room + most);
      }
      // And no more is taken away than the bound asks for.
      EXPECT_NEAR(after[i].hidden, hidden, 1e-3f);
      EXPECT_NEAR(after[i].room, room, 1e-3f);
    }
  }
}

TEST(LimitBandGrowth, zeroLeavesTheBands) {
  std::vector<DistortionSplat> splats = randomSplats(20, 3);
  const std::vector<DistortionSplat> before = splats;
  limitBandGrowth(splats, 0);
  for (size_t i = 0; i < splats.size(); ++i) {
    EXPECT_EQ(splats[i].hidden, before[i].hidden);
    EXPECT_EQ(splats[i].room, before[i].room);
  }
  std::vector<DistortionSplat> none;
  limitBandGrowth(none, 1);
}

TEST(FinalizeMap, pixelsOfTheBandGetTheDisplacementOfTheirDistance) {
  const std::vector<DistortionSplat> splats{splat({20, 20.5f}, {1, 0}, 6, 4)};
  const DistortionMap map =
      finalizeMap(splats, claimPixels(splats, kSplatSize, kSplatSize), DistortionMap::Lookup::kNearest);
  for (int x = 0; x < kSplatSize; ++x) {
    const float side = static_cast<float>(x) + 0.5f - 20;
    const bool inBand = side >= -6 && side <= 4;
    const DistortionSample& sample = map.samples()(x, 20);
    EXPECT_NEAR(sample.displacement.x, inBand ? (4 - side) * 6 / 10 : 0, 1e-5f);
    EXPECT_EQ(sample.displacement.y, 0);
    EXPECT_EQ(sample.inverseNear, inBand ? 0.2f : 0);
    EXPECT_EQ(sample.inverseFar, inBand ? 0.1f : 0);
  }
}

// Step 5: what a splat has claimed and no longer reaches is an orphan.
TEST(FinalizeMap, orphansAreRemoved) {
  std::vector<DistortionSplat> splats{splat({20, 20.5f}, {1, 0}, 6, 6)};
  const SplatOwners owners = claimPixels(splats, kSplatSize, kSplatSize);
  splats[0].hidden = 2;
  splats[0].room = 2;
  const DistortionMap map = finalizeMap(splats, owners, DistortionMap::Lookup::kNearest);
  EXPECT_NE(map.samples()(18, 20).displacement.x, 0);
  EXPECT_EQ(map.samples()(17, 20).displacement.x, 0);
  EXPECT_EQ(map.samples()(22, 20).displacement.x, 0);
  EXPECT_EQ(map.samples()(20, 23).displacement.x, 0) << "2.5 pixels along the edge";
}

TEST(SmoothMap, constantFieldStaysAsItIs) {
  DistortionMap map(kSplatSize, kSplatSize, DistortionMap::Lookup::kNearest);
  for (DistortionSample& sample : map.samples()) {
    sample = {{3, -4}, 0.2f, 0.1f};
  }
  const DistortionMap smooth = smoothMap(map, 1.5f);
  EXPECT_EQ(smooth.lookup(), DistortionMap::Lookup::kBilinear);
  for (const DistortionSample& sample : smooth.samples()) {
    EXPECT_NEAR(sample.displacement.x, 3, 1e-5f);
    EXPECT_NEAR(sample.displacement.y, -4, 1e-5f);
    EXPECT_NEAR(sample.inverseNear, 0.2f, 1e-6f);
    EXPECT_NEAR(sample.inverseFar, 0.1f, 1e-6f);
  }
}

// A step of height h, smoothed with a Gaussian, rises by at most h / (sigma sqrt(2 pi)) a pixel.
TEST(SmoothMap, stepBecomesARamp) {
  constexpr float kSigma = 2;
  DistortionMap map(kSplatSize, kSplatSize, DistortionMap::Lookup::kNearest);
  for (int y = 0; y < kSplatSize; ++y) {
    for (int x = kSplatSize / 2; x < kSplatSize; ++x) {
      map.samples()(x, y) = {{10, 0}, 0.2f, 0.1f};
    }
  }
  const DistortionMap smooth = smoothMap(map, kSigma);
  const double steepest = 10 / (kSigma * std::sqrt(2 * kPi));
  for (int y = 0; y < kSplatSize; ++y) {
    for (int x = 0; x + 1 < kSplatSize; ++x) {
      const float rise = smooth.samples()(x + 1, y).displacement.x - smooth.samples()(x, y).displacement.x;
      EXPECT_GE(rise, -1e-4f);
      EXPECT_LE(rise, 1.02 * steepest) << "2 %: the kernel ends at 2.5 sigma";
    }
    EXPECT_NEAR(smooth.samples()(kSplatSize - 1, y).displacement.x, 10, 1e-4f);
    EXPECT_NEAR(smooth.samples()(0, y).displacement.x, 0, 1e-4f);
    // Depths are those of the pixels that have some, not mixed with nothing.
    EXPECT_NEAR(smooth.samples()(kSplatSize / 2 - 2, y).inverseNear, 0.2f, 1e-6f);
    EXPECT_NEAR(smooth.samples()(kSplatSize / 2 - 2, y).inverseFar, 0.1f, 1e-6f);
  }
}

}  // namespace
}  // namespace ocelli
