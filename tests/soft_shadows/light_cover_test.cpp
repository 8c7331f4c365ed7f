#include "oc_core/soft_shadows/light_cover.h"

#include <gtest/gtest.h>

#include <vector>

#include "oc_core/base/random.h"
#include "tests/soft_shadows/light_scenes.h"

namespace ocelli {
namespace {

struct Cover {
  explicit Cover(bool isDisc = false, int side = 16) : grid(LightFrame(test::lightAbove(isDisc)), side), cover(grid) {
    cover.clear();
  }
  /// A polygon, its surface to the left of its edges.
  void add(const std::vector<glm::vec2>& polygon) {
    for (size_t i = 0; i < polygon.size(); ++i) {
      cover.add(polygon[i], polygon[(i + 1) % polygon.size()], 1);
    }
  }
  LightGrid grid;
  LightCover cover;
};

/// Whether a sample lies in a counter-clockwise triangle, in grid coordinates.
bool isInside(const std::vector<glm::vec2>& triangle, const glm::vec2& p) {
  for (size_t i = 0; i < 3; ++i) {
    const glm::vec2 side = triangle[(i + 1) % 3] - triangle[i];
    const glm::vec2 way = p - triangle[i];
    if (side.x * way.y - side.y * way.x < 0) {
      return false;
    }
  }
  return true;
}

TEST(LightCover, withoutEdgesIsTheSameForAll) {
  Cover whole;
  EXPECT_EQ(whole.cover.least().count, 16 * 16);
  EXPECT_EQ(whole.cover.least().neighbours, 0);
  Cover disc(true);
  // The samples of a disc: pi / 4 of its square, to a row of cells around it.
  EXPECT_NEAR(disc.cover.least().count, 201, 16);
  EXPECT_EQ(disc.cover.least().count, disc.grid.count());
}

TEST(LightCover, ofASquareIsAroundIt) {
  Cover cover;
  cover.add({{4, 3.5f}, {12, 3.5f}, {12, 7.5f}, {4, 7.5f}});
  EXPECT_EQ(cover.cover.least().count, 16 * 16 - 8 * 4);
  EXPECT_FALSE(cover.cover.isLeast(6, 5));
  EXPECT_TRUE(cover.cover.isLeast(2, 5));
  EXPECT_TRUE(cover.cover.isLeast(13, 5));
  EXPECT_TRUE(cover.cover.isLeast(6, 8));
}

// Triangles that reach over all sides of the light, on top of each other: those that fewest hide are as when each
// sample is looked at by itself.
TEST(LightCover, isThatOfEachSample) {
  Random random(1);
  for (int round = 0; round < 300; ++round) {
    Cover cover(round % 3 == 0);
    std::vector<std::vector<glm::vec2>> triangles;
    for (int i = 0; i < 1 + round % 6; ++i) {
      std::vector<glm::vec2> triangle;
      for (int corner = 0; corner < 3; ++corner) {
        const float x = random.inRange(-12, 28);
        const float y = random.inRange(-12, 28);
        triangle.emplace_back(x, y);
      }
      const glm::vec2 p = triangle[1] - triangle[0];
      const glm::vec2 q = triangle[2] - triangle[0];
      if (p.x * q.y - p.y * q.x < 0) {
        std::swap(triangle[1], triangle[2]);
      }
      cover.add(triangle);
      triangles.push_back(triangle);
    }
    cover.cover.least();
    int fewest = 100;
    std::vector<int> hidden;
    for (int column = 0; column < 16; ++column) {
      for (int row = 0; row < 16; ++row) {
        const glm::vec2 p(static_cast<float>(column) + cover.grid.shift(row), static_cast<float>(row));
        int count = 0;
        for (const std::vector<glm::vec2>& triangle : triangles) {
          count += isInside(triangle, p);
        }
        hidden.push_back(cover.grid.isOnLight(column, row) ? count : 1000);
        fewest = std::min(fewest, hidden.back());
      }
    }
    for (int column = 0; column < 16; ++column) {
      for (int row = 0; row < 16; ++row) {
        ASSERT_EQ(cover.cover.isLeast(column, row), hidden[static_cast<size_t>(column * 16 + row)] == fewest)
            << round << ": " << column << ", " << row;
      }
    }
  }
}

TEST(LightCover, namesOneOfTheLeast) {
  Cover cover;
  cover.add({{-5, -5}, {20, -5}, {20, 9}, {-5, 9}});
  const LightCover::Least least = cover.cover.least();
  EXPECT_EQ(least.count, 7 * 16);
  EXPECT_TRUE(cover.cover.isLeast(least.column, least.row));
  EXPECT_EQ(least.neighbours, 16);
}

}  // namespace
}  // namespace ocelli
