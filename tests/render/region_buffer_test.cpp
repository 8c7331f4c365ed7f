#include "oc_core/render/region_buffer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "oc_core/base/random.h"

namespace ocelli {
namespace {

constexpr int16_t kNotPassed = -1;

/// The left half of an image of 40x20 pixels has leaf 0, the right one leaf 1.
PixelLeaves twoLeaves() {
  PixelLeaves leaves(40, 20, 0);
  for (int y = 0; y < 20; ++y) {
    for (int x = 20; x < 40; ++x) {
      leaves(x, y) = 1;
    }
  }
  return leaves;
}

RasterVertex anyVertex(Random& random) {
  return {random.inRange(-20, 60), random.inRange(-10, 30), random.inRange(0.1f, 2), random.inRange(0, 1),
          random.inRange(0, 1)};
}

std::vector<Fragment> fragmentsOf(RegionBuffer& region) {
  region.close();
  std::vector<Fragment> fragments(40 * 20);
  region.forEachRun(40, [&](const RegionBuffer::SampleRun& run) {
    for (size_t i = 0; i < run.size; ++i) {
      fragments[static_cast<size_t>(run.y) * 40 + static_cast<size_t>(run.x) + i] = run.fragment(i);
    }
  });
  return fragments;
}

TEST(RegionBuffer, opensThePixelsWhoseRaysPassAndHaveMetNothing) {
  const PixelBounds all{0, 0, 40, 20};
  const std::array<int16_t, 2> right{kNotPassed, 0};
  const std::array<int16_t, 2> both{0, 1};
  const std::array<int16_t, 2> none{kNotPassed, kNotPassed};
  RegionBuffer region;
  region.reset(all, twoLeaves());
  EXPECT_EQ(region.open(all, 0, none), 0u);
  EXPECT_EQ(region.open(all, 0, right), 1u);
  EXPECT_FALSE(region.mayShow({0, 0, 16, 20}, 1));
  EXPECT_TRUE(region.mayShow({0, 0, 24, 20}, 1));
  const RasterVertex a{-100, -100, 0.5f, 0, 0};
  const RasterVertex b{200, -100, 0.5f, 1, 0};
  const RasterVertex c{-100, 200, 0.5f, 0, 1};
  region.fill(all, 7, a, b, c);
  region.touch(all);
  // At a depth of 2: what is farther is hidden there, what is nearer is not.
  EXPECT_FALSE(region.mayShow(all, 2.001f));
  EXPECT_TRUE(region.mayShow(all, 1.999f));
  region.close();
  size_t filled = 0;
  region.forEachRun(1000, [&](const RegionBuffer::SampleRun& run) {
    EXPECT_EQ(run.leaf, 1);
    filled += run.size;
  });
  EXPECT_EQ(filled, 20u * 20);
  // The next piece comes behind: the right half is closed for it, however near.
  EXPECT_EQ(region.open(all, 1, both), 1u);
  EXPECT_FALSE(region.mayShow({24, 0, 40, 20}, 1e-3f));
  EXPECT_TRUE(region.mayShow(all, 1e9f));
}

// Lanes give what single pixels do, bit by bit: of triangles of all sizes, turned both ways.
TEST(RegionBuffer, fillsAsPixelByPixel) {
  const PixelBounds all{0, 0, 40, 20};
  const std::array<int16_t, 2> both{0, 0};
  Random random(3);
  size_t covered = 0;
  for (int image = 0; image < 200; ++image) {
    RegionBuffer lanes;
    RegionBuffer pixels;
    for (RegionBuffer* region : {&lanes, &pixels}) {
      region->reset(all, twoLeaves());
      region->open(all, 0, both);
    }
    for (uint32_t triangle = 0; triangle < 4; ++triangle) {
      const RasterVertex a = anyVertex(random);
      const RasterVertex b = anyVertex(random);
      const RasterVertex c = anyVertex(random);
      lanes.fill(all, triangle, a, b, c);
      pixels.scan(all, a, b, c, [&](size_t pixel, float z, const PixelWeights& weights) {
        if (pixels.isNearest(pixel, z, triangle)) {
          pixels.put(pixel, z, triangle, weights());
          ++covered;
        }
      });
    }
    EXPECT_EQ(fragmentsOf(lanes), fragmentsOf(pixels)) << image;
  }
  EXPECT_GT(covered, 20000u);
}

// Every kind that some pixel has is among those of a rectangle around it; tiles of one leaf add no other.
TEST(RegionBuffer, knowsTheKindsOfRaysInARectangle) {
  const std::array<int16_t, 4> kinds{0, kNotPassed, 2, 2};
  Random random(9);
  size_t told = 0;
  for (int image = 0; image < 50; ++image) {
    PixelLeaves leaves(40, 20, 0);
    for (uint16_t leaf = 1; leaf < 4; ++leaf) {
      const PixelBounds part{static_cast<int>(random.inRange(0, 40)), static_cast<int>(random.inRange(0, 20)), 40, 20};
      for (int y = part.y0; y < part.y1; ++y) {
        for (int x = part.x0; x < part.x1; ++x) {
          leaves(x, y) = leaf;
        }
      }
    }
    RegionBuffer region;
    const PixelBounds all{3, 2, 40, 20};
    region.reset(all, leaves);
    for (int y = all.y0; y < all.y1; ++y) {
      for (int x = all.x0; x < all.x1; ++x) {
        const int16_t kind = kinds[leaves(x, y)];
        const uint64_t found = region.kindsIn({x, y, x + 1, y + 1}, kinds);
        if (kind >= 0) {
          ASSERT_NE(found & RegionBuffer::kindBit(static_cast<size_t>(kind)), 0u) << x << ", " << y;
        }
        told += found == 0 || found == 1 || found == 4 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(told, 50u * 37 * 18 / 2) << "most tiles have one leaf";
  RegionBuffer halves;
  halves.reset({0, 0, 40, 20}, twoLeaves());
  EXPECT_EQ(halves.kindsIn({0, 0, 16, 20}, std::array<int16_t, 2>{0, 1}), 1u);
  EXPECT_EQ(halves.kindsIn({24, 0, 40, 20}, std::array<int16_t, 2>{0, 1}), 2u);
}

// From one pixel in a corner to most of the image: they hold what the whole image does there, and no tile of theirs is
// passed over that may still show something.
TEST(RegionBuffer, regionsHoldWhatTheWholeImageDoes) {
  const PixelBounds all{0, 0, 40, 20};
  const std::array<int16_t, 2> both{0, 0};
  Random random(5);
  size_t covered = 0;
  size_t passedOver = 0;
  for (int image = 0; image < 100; ++image) {
    std::vector<std::array<RasterVertex, 3>> triangles;
    for (int i = 0; i < 4; ++i) {
      triangles.push_back({anyVertex(random), anyVertex(random), anyVertex(random)});
    }
    RegionBuffer whole;
    whole.reset(all, twoLeaves());
    whole.open(all, 0, both);
    for (uint32_t i = 0; i < triangles.size(); ++i) {
      whole.fill(all, i, triangles[i][0], triangles[i][1], triangles[i][2]);
    }
    for (const PixelBounds& rect : std::initializer_list<PixelBounds>{
             {0, 0, 1, 1}, {39, 19, 40, 20}, {13, 7, 14, 20}, {5, 3, 8, 5}, {0, 9, 40, 10}, {7, 1, 39, 20}}) {
      const auto isInside = [&](int x, int y) { return x >= rect.x0 && x < rect.x1 && y >= rect.y0 && y < rect.y1; };
      RegionBuffer part;
      part.reset(rect, twoLeaves());
      EXPECT_EQ(part.open({rect.x1, 0, 50, 20}, 0, both), 0u) << "a piece that is seen elsewhere";
      EXPECT_EQ(part.open(all, 0, both), 1u);
      for (uint32_t i = 0; i < triangles.size(); ++i) {
        const auto& [a, b, c] = triangles[i];
        const float nearest = 0.999f / std::max({a.inverseZ, b.inverseZ, c.inverseZ});
        if (part.mayShow(all, nearest)) {
          part.fill(rect, i, a, b, c);
          part.touch(rect);
        } else {
          ++passedOver;
        }
      }
      std::vector<Fragment> expected = fragmentsOf(whole);
      for (int y = 0; y < 20; ++y) {
        for (int x = 0; x < 40; ++x) {
          Fragment& fragment = expected[static_cast<size_t>(y) * 40 + static_cast<size_t>(x)];
          fragment = isInside(x, y) ? fragment : Fragment();
          covered += fragment.covered();
        }
      }
      EXPECT_EQ(fragmentsOf(part), expected) << image << ", region at " << rect.x0 << ", " << rect.y0;
    }
  }
  EXPECT_GT(covered, 20000u);
  EXPECT_GT(passedOver, 10u);
}

}  // namespace
}  // namespace ocelli
