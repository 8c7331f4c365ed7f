// Edges that run along the slanted rows of samples: none of their samples lies beyond a crossing.
#include "oc_core/antialiasing/pixel_masks.h"

#include <gtest/gtest.h>

#include <vector>

namespace ocelli::test {
namespace {

/// The triangle below (above: `sign` -1) the line y = height + x / n, whose end points lie far out, with the line as
/// the edge opposite of one corner. Its steps from row to row are so large that their 21st part of 1e30 is no float.
std::array<RasterVertex, 3> halfPlane(int n, float height, float sign, size_t corner) {
  constexpr float kReach = 16;
  const float x = kReach * static_cast<float>(n);
  const std::array<RasterVertex, 3> vertices = {
      {{0, height + sign * 500, 1, 0, 0}, {x, height + kReach, 1, 0, 0}, {-x, height - kReach, 1, 0, 0}}};
  std::array<RasterVertex, 3> turned;
  for (size_t i = 0; i < 3; ++i) {
    turned[(i + corner) % 3] = vertices[i];
  }
  return turned;
}

/// What share of a pixel's samples the triangles cover.
float covered(const std::vector<std::array<RasterVertex, 3>>& of, const ImageBox& square,
              const SamplePattern& pattern) {
  const Mesh white;  // a mesh without colours is
  BlockTriangles triangles;
  triangles.start({0, 0});
  std::vector<PixelTriangle> seen;
  for (const auto& [a, b, c] : of) {
    seen.push_back({triangles.add(static_cast<uint32_t>(seen.size()), a, b, c), 1, 1, 1000});
  }
  PixelMasks masks;
  return masks.mean(seen, triangles, square, pattern, white, glm::vec3(0)).x;
}

TEST(PixelMasks, edgesAlongTheRowsCutBetweenRows) {
  for (const int n : {1, 4, 7, 16, 32}) {
    const SamplePattern pattern(n, *findSamplePlacement("slanted"));
    ASSERT_TRUE(PixelMasks::take(pattern));
    size_t cut = 0;
    for (const float side : {1.0f, 0.5f}) {
      for (const float height : {0.0f, 0.015625f, -0.015625f, 0.515625f}) {
        for (const float y : {-1.0f, 0.0f, 1.0f}) {
          const glm::vec2 at(0.25f, y);
          int below = 0;
          int above = 0;
          for (int row = 0; row < n; ++row) {
            // A sample's share of the slope is that of the line: all of a row has the same distance from it.
            const double distance = n * (double{at.y} - double{height}) + double{side} * row - double{at.x};
            below += distance >= 0 ? 1 : 0;
            above += distance <= 0 ? 1 : 0;
          }
          cut += below > 0 && below < n ? 1 : 0;
          const ImageBox square{at, at + side};
          for (size_t corner = 0; corner < 3; ++corner) {
            SCOPED_TRACE(testing::Message() << n << " " << side << " " << height << " " << y << " " << corner);
            const auto lower = halfPlane(n, height, 1, corner);
            const auto upper = halfPlane(n, height, -1, (corner + 1) % 3);
            // Sums of whole numbers up to 1,024, divided once.
            EXPECT_FLOAT_EQ(covered({lower}, square, pattern), static_cast<float>(below) / static_cast<float>(n));
            EXPECT_FLOAT_EQ(covered({upper}, square, pattern), static_cast<float>(above) / static_cast<float>(n));
            EXPECT_FLOAT_EQ(covered({lower, upper}, square, pattern), 1);  // neither gap nor twice
          }
        }
      }
    }
    EXPECT_EQ(cut > 0, n > 1);  // the line goes through pixels, but for those of one row
  }
}

}  // namespace
}  // namespace ocelli::test
