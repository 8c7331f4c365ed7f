#include "oc_core/scene/alpha_cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

namespace ocelli {
namespace {

double cutAreaOf(const Mesh& mesh) {
  double area = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    area += 0.5 * static_cast<double>(glm::length(glm::cross(mesh.positions[t.y] - mesh.positions[t.x],
                                                             mesh.positions[t.z] - mesh.positions[t.x])));
  }
  return area;
}

Mesh triangleToCut() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.colors = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

TEST(CutAway, KeepsACornerOfATriangle) {
  Mesh mesh = triangleToCut();
  const std::vector<EdgeVertex> added = cutAway(mesh, {1, 0, 0}, 0.75f);
  ASSERT_EQ(mesh.triangles.size(), 1u);
  EXPECT_NEAR(cutAreaOf(mesh), 0.5 * 0.25 * 0.25, 1e-7);  // the value is 0.75 a quarter of the way along both sides
  ASSERT_EQ(added.size(), 2u);
  EXPECT_EQ(mesh.positions[3], glm::vec3(0.25f, 0, 0));
  EXPECT_EQ(mesh.colors[3], glm::vec3(0.25f, 0, 0));
  EXPECT_EQ(added[0].share, 0.25f);
  EXPECT_EQ(std::make_pair(added[0].low, added[0].high), std::make_pair(0U, 1U));
}

TEST(CutAway, KeepsAllButACorner) {
  for (uint32_t corner = 0; corner < 3; ++corner) {
    Mesh mesh = triangleToCut();
    std::vector<float> values(3, 1);
    values[corner] = 0;
    cutAway(mesh, values, 0.5f);
    EXPECT_EQ(mesh.triangles.size(), 2u);
    EXPECT_NEAR(cutAreaOf(mesh), 0.5 - 0.5 * 0.25, 1e-7);
    for (const glm::uvec3& t : mesh.triangles) {
      EXPECT_GT(glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]).z, 0)
          << "it still turns as it did";
    }
  }
}

TEST(CutAway, KeepsAllOrNothing) {
  Mesh whole = triangleToCut();
  EXPECT_TRUE(cutAway(whole, {0.5f, 1, 1}, 0.5f).empty());
  EXPECT_EQ(whole.triangles.size(), 1u);
  Mesh none = triangleToCut();
  EXPECT_TRUE(cutAway(none, {0.4f, 0, 0}, 0.5f).empty());
  EXPECT_TRUE(none.triangles.empty());
}

// A square of many triangles with a disc as its mask: the rim is closed, each edge within is of two triangles, and the
// area is that of the disc, but for what the chords of the cells leave out.
TEST(CutAway, LeavesADiscWithoutGaps) {
  constexpr uint32_t kSide = 64;
  Mesh mesh;
  std::vector<float> values;
  for (uint32_t y = 0; y <= kSide; ++y) {
    for (uint32_t x = 0; x <= kSide; ++x) {
      const glm::vec2 place(2 * static_cast<float>(x) / kSide - 1, 2 * static_cast<float>(y) / kSide - 1);
      mesh.positions.emplace_back(place.x, place.y, 0.0f);
      values.push_back(1 - glm::length(place));
      if (x < kSide && y < kSide) {
        const uint32_t low = y * (kSide + 1) + x;
        mesh.triangles.push_back({low, low + 1, low + kSide + 2});
        mesh.triangles.push_back({low, low + kSide + 2, low + kSide + 1});
      }
    }
  }
  cutAway(mesh, values, 0.3f);
  constexpr double kPi = 3.14159265358979;
  EXPECT_NEAR(cutAreaOf(mesh), kPi * 0.49, 0.001 * kPi * 0.49);
  std::map<std::pair<uint32_t, uint32_t>, int> uses;
  for (const glm::uvec3& t : mesh.triangles) {
    for (glm::length_t i = 0; i < 3; ++i) {
      ++uses[std::minmax(t[i], t[(i + 1) % 3])];
    }
  }
  for (const auto& [edge, count] : uses) {
    ASSERT_LE(count, 2);
    if (count == 1) {
      for (const uint32_t vertex : {edge.first, edge.second}) {
        // A cell is 1/32 wide: its chord leaves out its square over 8 radii.
        EXPECT_NEAR(glm::length(mesh.positions[vertex]), 0.7, 0.001);
      }
    }
  }
}

}  // namespace
}  // namespace ocelli
