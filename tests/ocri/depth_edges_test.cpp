#include "oc_core/ocri/depth_edges.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>

#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

constexpr int kSize = 60;
constexpr float kNear = 1 / 5.0f;
constexpr float kFar = 1 / 10.0f;

/// 1/z of an image that `isNear(u, v)` splits into an occluder and a background, both facing the camera.
template <class Shape>
Image<float> twoDepths(const Shape& isNear) {
  Image<float> inverseZ(kSize, kSize);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      inverseZ(x, y) = isNear(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f) ? kNear : kFar;
    }
  }
  return inverseZ;
}

/// Neighbouring pixels on different sides: there must be one edge for each.
size_t borderPairs(const Image<float>& inverseZ) {
  size_t pairs = 0;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      pairs += x + 1 < kSize && inverseZ(x, y) != inverseZ(x + 1, y);
      pairs += y + 1 < kSize && inverseZ(x, y) != inverseZ(x, y + 1);
    }
  }
  return pairs;
}

double degreesBetween(const glm::vec2& a, const glm::vec2& b) {
  return degreesFromRadians(std::acos(std::min(1.0f, glm::dot(a, b))));
}

const DepthEdgeOptions kOptions{0.001f, 0, 5};

// The edge pixels of a straight line lie within half a pixel of it. A line fitted over 5 pixels to both sides, with
// weights 1 - |x| / 5, can turn by no more than a slope of sum(w |x| / 2) / sum(w x^2) = 0.2, or 11.3 degrees; where
// one side is missing at the image border, by twice that. Errors of both signs leave far less on average.
TEST(DepthEdges, stepHasEdgesWithTheNormalOfItsLine) {
  double sum = 0;
  size_t count = 0;
  for (int degrees = 0; degrees < 360; degrees += 7) {
    const auto angle = static_cast<float>(radiansFromDegrees(degrees));
    const glm::vec2 normal(std::cos(angle), std::sin(angle));
    const glm::vec2 onLine(30.2f, 29.7f);
    const Image<float> inverseZ =
        twoDepths([&](float u, float v) { return glm::dot(glm::vec2(u, v) - onLine, normal) < 0; });
    const std::vector<DepthEdge> edges = findDepthEdges(inverseZ, kOptions);
    EXPECT_EQ(edges.size(), borderPairs(inverseZ)) << degrees;
    for (const DepthEdge& edge : edges) {
      EXPECT_LE(std::abs(glm::dot(edge.position - onLine, normal)), 0.5f + 1e-4f) << "between two pixel centres";
      EXPECT_NEAR(glm::length(edge.normal), 1, 1e-5f);
      const float border =
          std::min({edge.position.x, edge.position.y, kSize - edge.position.x, kSize - edge.position.y});
      const double off = degreesBetween(edge.normal, normal);
      EXPECT_LT(off, border > 6 ? 11.4 : 22.7) << degrees;
      EXPECT_EQ(edge.inverseNear, kNear);
      EXPECT_EQ(edge.inverseFar, kFar);
      sum += off;
      ++count;
    }
  }
  EXPECT_LT(sum / static_cast<double>(count), 3);
}

TEST(DepthEdges, planesHaveNone) {
  for (const glm::vec2 slope :
       {glm::vec2(0, 0), glm::vec2(0.01f, 0), glm::vec2(0, -0.004f), glm::vec2(0.01f, 0.006f)}) {
    Image<float> inverseZ(kSize, kSize);
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        inverseZ(x, y) = 0.3f + slope.x * static_cast<float>(x) + slope.y * static_cast<float>(y);
      }
    }
    EXPECT_TRUE(findDepthEdges(inverseZ, kOptions).empty()) << "slopes of ten times the least step of 0.001";
  }
}

TEST(DepthEdges, creaseBetweenTwoPlanesHasNone) {
  Image<float> inverseZ(kSize, kSize);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      inverseZ(x, y) = 0.5f - 0.005f * static_cast<float>(std::abs(x - 30));
    }
  }
  EXPECT_TRUE(findDepthEdges(inverseZ, kOptions).empty());
}

// A circle turns evenly along the 5 pixels to both sides; what is left is what digital lines are off.
TEST(DepthEdges, discHasRadialNormals) {
  const glm::vec2 centre(30.3f, 29.6f);
  const Image<float> inverseZ =
      twoDepths([&](float u, float v) { return glm::distance(glm::vec2(u, v), centre) < 15; });
  const std::vector<DepthEdge> edges = findDepthEdges(inverseZ, kOptions);
  EXPECT_EQ(edges.size(), borderPairs(inverseZ));
  double sum = 0;
  for (const DepthEdge& edge : edges) {
    const double off = degreesBetween(edge.normal, glm::normalize(edge.position - centre));
    EXPECT_LT(off, 11.4) << edge.position.x << " " << edge.position.y;
    sum += off;
  }
  EXPECT_LT(sum / static_cast<double>(edges.size()), 3);
}

TEST(DepthEdges, barOfOnePixelHasEdgesOnBothSides) {
  const Image<float> inverseZ = twoDepths([](float u, float) { return u > 30 && u < 31; });
  const std::vector<DepthEdge> edges = findDepthEdges(inverseZ, kOptions);
  ASSERT_EQ(edges.size(), 2u * kSize);
  for (const DepthEdge& edge : edges) {
    EXPECT_LT(degreesBetween(edge.normal, {edge.position.x < 30.5f ? -1 : 1, 0}), 1);
  }
}

TEST(DepthEdges, stepsBelowTheLeastDoNotCount) {
  const Image<float> inverseZ = twoDepths([](float u, float) { return u < 30; });
  DepthEdgeOptions options = kOptions;
  options.minInverseZStep = (kNear - kFar) * 1.001f;
  EXPECT_TRUE(findDepthEdges(inverseZ, options).empty());
  options.minInverseZStep = (kNear - kFar) * 0.999f;
  EXPECT_EQ(findDepthEdges(inverseZ, options).size(), static_cast<size_t>(kSize));
}

TEST(DepthEdges, emptyPixelsTakeTheDepthOfTheBackground) {
  Image<float> inverseZ = twoDepths([](float u, float) { return u < 30; });
  for (float& w : inverseZ) {
    w = w == kNear ? w : 0;
  }
  DepthEdgeOptions options = kOptions;
  options.backgroundInverseZ = 0.15f;
  const std::vector<DepthEdge> edges = findDepthEdges(inverseZ, options);
  ASSERT_EQ(edges.size(), static_cast<size_t>(kSize));
  for (const DepthEdge& edge : edges) {
    EXPECT_EQ(edge.inverseNear, kNear);
    EXPECT_EQ(edge.inverseFar, 0.15f);
    EXPECT_EQ(edge.position.x, 30);
  }
}

TEST(DepthEdges, comeInRowOrder) {
  const auto edges = findDepthEdges(
      twoDepths([](float u, float v) { return glm::distance(glm::vec2(u, v), glm::vec2(30)) < 11; }), kOptions);
  EXPECT_TRUE(std::is_sorted(edges.begin(), edges.end(), [](const DepthEdge& a, const DepthEdge& b) {
    return std::tuple(std::floor(a.position.y), std::floor(a.position.x)) <
           std::tuple(std::floor(b.position.y), std::floor(b.position.x));
  }));
}

// The text's edges are steps of z. A plane that runs away from the eye has steps of z as well, which grow with z^2, and
// so an edge far away where 1/z has none.
TEST(DepthEdges, onZAreStepsOfZ) {
  Image<float> steps(kSize, kSize);
  Image<float> plane(kSize, kSize);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      steps(x, y) = 1 / (x < 20 ? 10.0f : x < 40 ? 10.04f : 10.1f);  // by 0.04 and by 0.06
      plane(x, y) = 0.2f - 0.003f * static_cast<float>(x);           // z from 5 to 43
    }
  }
  const DepthEdgeOptions onZ{.minInverseZStep = 1, .minZStep = 0.05f};
  const std::vector<DepthEdge> found = findDepthEdges(steps, onZ);
  ASSERT_EQ(found.size(), static_cast<size_t>(kSize));
  for (const DepthEdge& edge : found) {
    EXPECT_EQ(edge.position.x, 40);
    EXPECT_GT(edge.normal.x, 0.9999f);
    EXPECT_FLOAT_EQ(1 / edge.inverseNear, 10.04f);
    EXPECT_FLOAT_EQ(1 / edge.inverseFar, 10.1f);
  }
  EXPECT_TRUE(findDepthEdges(plane, kOptions).empty());
  EXPECT_FALSE(findDepthEdges(plane, onZ).empty());
}

}  // namespace
}  // namespace ocelli
