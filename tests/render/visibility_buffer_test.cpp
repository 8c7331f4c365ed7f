#include "oc_core/render/visibility_buffer.h"

#include <gtest/gtest.h>

#include <glm/vec2.hpp>
#include <random>

namespace ocelli {
namespace {

constexpr int kBufferWidth = 48;
constexpr int kBufferHeight = 32;
constexpr size_t kPixels = static_cast<size_t>(kBufferWidth) * kBufferHeight;

RasterVertex at(const glm::vec2& p, float inverseZ = 0.1f) {
  return {p.x, p.y, inverseZ, 0, 0};
}

/// How many of the triangles cover each pixel, each drawn by itself.
Image<int> coverage(const std::vector<std::array<glm::vec2, 3>>& triangles) {
  Image<int> count(kBufferWidth, kBufferHeight, 0);
  for (const auto& [a, b, c] : triangles) {
    VisibilityBuffer buffer(kBufferWidth, kBufferHeight);
    buffer.draw(0, at(a), at(b), at(c));
    for (size_t i = 0; i < kPixels; ++i) {
      count[i] += buffer.fragment(i).covered();
    }
  }
  return count;
}

void expectOnce(const Image<int>& count) {
  for (int y = 0; y < kBufferHeight; ++y) {
    for (int x = 0; x < kBufferWidth; ++x) {
      ASSERT_EQ(count(x, y), 1) << x << " " << y;
    }
  }
}

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  float within(float least, float most) {
    return least + (most - least) * static_cast<float>(engine_() >> 8) / static_cast<float>(1 << 24);
  }
  bool coin() { return (engine_() & 1) != 0; }

 private:
  std::mt19937 engine_;
};

TEST(VisibilityBuffer, centresOnTopAndLeftEdgesBelongToTheTriangle) {
  const auto count =
      coverage({{{{1.5f, 1.5f}, {4.5f, 1.5f}, {4.5f, 3.5f}}}, {{{1.5f, 1.5f}, {4.5f, 3.5f}, {1.5f, 3.5f}}}});
  for (int y = 0; y < kBufferHeight; ++y) {
    for (int x = 0; x < kBufferWidth; ++x) {
      EXPECT_EQ(count(x, y), x >= 1 && x <= 3 && y >= 1 && y <= 2 ? 1 : 0) << x << " " << y;
    }
  }
}

TEST(VisibilityBuffer, trianglesOfAQuadCoverItsPixelsOnce) {
  Random random(1);
  for (int round = 0; round < 200; ++round) {
    // Corners outside of the image or on its corners, the diagonal anywhere: every pixel lies in one of the two.
    const glm::vec2 a(random.within(-40, 0), random.within(-40, 0));
    const glm::vec2 b(random.within(kBufferWidth, kBufferWidth + 40), random.within(-40, 0));
    const glm::vec2 c(random.within(kBufferWidth, kBufferWidth + 40), random.within(kBufferHeight, kBufferHeight + 40));
    const glm::vec2 d(random.within(-40, 0), random.within(kBufferHeight, kBufferHeight + 40));
    expectOnce(random.coin() ? coverage({{{a, b, c}}, {{a, c, d}}}) : coverage({{{b, c, d}}, {{d, a, b}}}));
  }
}

TEST(VisibilityBuffer, gridOfJitteredQuadsCoversEveryPixelOnce) {
  Random random(2);
  for (int round = 0; round < 40; ++round) {
    constexpr int kColumns = 8;
    constexpr int kRows = 6;
    std::array<std::array<glm::vec2, kColumns + 1>, kRows + 1> points;
    for (int j = 0; j <= kRows; ++j) {
      for (int i = 0; i <= kColumns; ++i) {
        glm::vec2 p(static_cast<float>(i * kBufferWidth) / kColumns, static_cast<float>(j * kBufferHeight) / kRows);
        const bool inside = i > 0 && i < kColumns && j > 0 && j < kRows;
        if (inside && random.coin()) {
          p = glm::vec2(std::floor(p.x) + 0.5f, std::floor(p.y) + 0.5f);  // on a pixel centre
        } else if (inside) {
          p += glm::vec2(random.within(-2, 2), random.within(-2, 2));
        }
        points[static_cast<size_t>(j)][static_cast<size_t>(i)] = p;
      }
    }
    std::vector<std::array<glm::vec2, 3>> triangles;
    for (size_t j = 0; j < kRows; ++j) {
      for (size_t i = 0; i < kColumns; ++i) {
        const glm::vec2 a = points[j][i];
        const glm::vec2 b = points[j][i + 1];
        const glm::vec2 c = points[j + 1][i + 1];
        const glm::vec2 d = points[j + 1][i];
        triangles.push_back({a, b, c});
        triangles.push_back(random.coin() ? std::array{a, c, d} : std::array{d, c, a});  // either winding
      }
    }
    expectOnce(coverage(triangles));
  }
}

TEST(VisibilityBuffer, fansAroundAPointCoverEveryPixelOnce) {
  Random random(3);
  for (int round = 0; round < 60; ++round) {
    glm::vec2 hub(random.within(2, kBufferWidth - 2), random.within(2, kBufferHeight - 2));
    if (random.coin()) {
      hub = glm::vec2(std::floor(hub.x) + 0.5f, std::floor(hub.y) + 0.5f);
    }
    std::vector<glm::vec2> rim;
    for (int i = 0; i < 10; ++i) {
      const float t = static_cast<float>(i) / 10;
      rim.emplace_back(t * kBufferWidth, -1.0f);
    }
    for (int i = 0; i < 7; ++i) {
      rim.emplace_back(kBufferWidth + 1.0f, static_cast<float>(i * kBufferHeight) / 7);
    }
    for (int i = 0; i < 10; ++i) {
      rim.emplace_back(kBufferWidth - static_cast<float>(i * kBufferWidth) / 10, kBufferHeight + 1.0f);
    }
    for (int i = 0; i < 7; ++i) {
      rim.emplace_back(-1.0f, kBufferHeight - static_cast<float>(i * kBufferHeight) / 7);
    }
    std::vector<std::array<glm::vec2, 3>> triangles;
    for (size_t i = 0; i < rim.size(); ++i) {
      triangles.push_back({hub, rim[i], rim[(i + 1) % rim.size()]});
    }
    const Image<int> count = coverage(triangles);
    // The corners of the image are cut off: the rim goes straight from side to side there.
    for (int y = 1; y + 1 < kBufferHeight; ++y) {
      for (int x = 1; x + 1 < kBufferWidth; ++x) {
        ASSERT_LE(count(x, y), 1);
        if (std::min(x, kBufferWidth - 1 - x) + std::min(y, kBufferHeight - 1 - y) > 12) {
          ASSERT_EQ(count(x, y), 1) << x << " " << y;
        }
      }
    }
  }
}

TEST(VisibilityBuffer, degenerateTrianglesCoverNothing) {
  VisibilityBuffer buffer(kBufferWidth, kBufferHeight);
  buffer.draw(0, at({5, 5}), at({5, 5}), at({5, 5}));
  buffer.draw(0, at({5.5f, 5.5f}), at({9.5f, 5.5f}), at({30.5f, 5.5f}));
  buffer.draw(0, at({-20, -20}), at({-1, -20}), at({-20, -1}));
  buffer.draw(0, at({60, 5}), at({90, 5}), at({90, 40}));
  for (size_t i = 0; i < kPixels; ++i) {
    EXPECT_FALSE(buffer.fragment(i).covered());
  }
}

// On vertices of the 1/256 grid nothing is snapped: 1/z and, divided by it, the weights are linear over the image.
TEST(VisibilityBuffer, interpolatesLinearlyIn1OverZ) {
  const std::array<glm::dvec2, 3> p{glm::dvec2(2.25, 1.5), {44.125, 6.75}, {13, 30.5}};
  const std::array<double, 3> w{1 / 2.0, 1 / 9.0, 1 / 30.0};
  VisibilityBuffer buffer(kBufferWidth, kBufferHeight);
  const auto vertex = [&](size_t i) {
    return RasterVertex{static_cast<float>(p[i].x), static_cast<float>(p[i].y), static_cast<float>(w[i]),
                        i == 1 ? 1.0f : 0.0f, i == 2 ? 1.0f : 0.0f};
  };
  buffer.draw(7, vertex(0), vertex(1), vertex(2));
  const auto cross = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; };
  const double area = cross(p[1] - p[0], p[2] - p[0]);
  int covered = 0;
  for (int y = 0; y < kBufferHeight; ++y) {
    for (int x = 0; x < kBufferWidth; ++x) {
      const glm::dvec2 c(x + 0.5, y + 0.5);
      const double s1 = cross(c - p[0], p[2] - p[0]) / area;
      const double s2 = cross(p[1] - p[0], c - p[0]) / area;
      const Fragment f = buffer.fragment(static_cast<size_t>(y * kBufferWidth + x));
      const bool inside = s1 > 1e-9 && s2 > 1e-9 && s1 + s2 < 1 - 1e-9;
      ASSERT_EQ(f.covered(), inside);
      if (inside) {
        ++covered;
        const double inverseZ = (1 - s1 - s2) * w[0] + s1 * w[1] + s2 * w[2];
        EXPECT_EQ(f.triangle, 7u);
        // Single precision; and edges that are neither top nor left are moved by one unit of 2^16 to a pixel.
        EXPECT_NEAR(f.t * inverseZ, 1, 2e-6);
        EXPECT_NEAR(f.b1, s1 * w[1] / inverseZ, 2e-6);
        EXPECT_NEAR(f.b2, s2 * w[2] / inverseZ, 2e-6);
      }
    }
  }
  EXPECT_NEAR(covered, area / 2, 30)
      << "half the length of the boundary, 110 pixels, is the most that centres can be off";
}

TEST(VisibilityBuffer, closestWinsAndTheLowerIndexOnATieInAnyOrder) {
  const glm::vec2 a(-5, -5);
  const glm::vec2 b(200, -5);
  const glm::vec2 c(-5, 200);
  for (const auto& order : {std::array{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}) {
    VisibilityBuffer one(kBufferWidth, kBufferHeight);
    std::array<VisibilityBuffer, 3> each{one, one, one};
    for (const int i : order) {
      const float inverseZ = i == 0 ? 0.05f : 0.1f;  // 0 is far; 1 and 2 tie
      const auto triangle = static_cast<uint32_t>(i);
      one.draw(triangle, at(a, inverseZ), at(b, inverseZ), at(c, inverseZ));
      each[triangle].draw(triangle, at(a, inverseZ), at(b, inverseZ), at(c, inverseZ));
    }
    VisibilityBuffer merged(kBufferWidth, kBufferHeight);
    for (const int i : order) {
      merged.mergePixels(each[static_cast<size_t>(i)], 0, kPixels);
    }
    for (size_t i = 0; i < kPixels; ++i) {
      ASSERT_EQ(one.fragment(i).triangle, 1u);
      ASSERT_EQ(merged.fragment(i), one.fragment(i));
    }
  }
}

TEST(VisibilityBuffer, mergesOnlyTheGivenPixels) {
  VisibilityBuffer full(kBufferWidth, kBufferHeight);
  full.draw(3, at({-5, -5}), at({200, -5}), at({-5, 200}));
  VisibilityBuffer merged(kBufferWidth, kBufferHeight);
  merged.mergePixels(full, 10, 20);
  for (size_t i = 0; i < kPixels; ++i) {
    EXPECT_EQ(merged.fragment(i).covered(), i >= 10 && i < 20);
  }
}

}  // namespace
}  // namespace ocelli
