#include "oc_core/scene/closed_parts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "oc_core/worlds/solids.h"

namespace ocelli {
namespace {

using testing::Each;

Mesh turnedInsideOut(Mesh mesh) {
  for (glm::uvec3& t : mesh.triangles) {
    std::swap(t.y, t.z);
  }
  return mesh;
}

/// Every triangle gets three vertices of its own.
Mesh soup(const Mesh& mesh) {
  Mesh apart;
  for (const glm::uvec3& t : mesh.triangles) {
    const auto first = static_cast<uint32_t>(apart.positions.size());
    for (int i = 0; i < 3; ++i) {
      apart.positions.push_back(mesh.positions[t[i]]);
    }
    apart.triangles.emplace_back(first, first + 1, first + 2);
  }
  return apart;
}

TEST(ClosedParts, solidsFaceOut) {
  for (const Mesh& solid : {makeBox({1, 2, 3}), makeSphere(24), makeTorus(0.3f, 24)}) {
    EXPECT_THAT(closureOfTriangles(solid), Each(Closure::kFacesOut));
    EXPECT_THAT(closureOfTriangles(turnedInsideOut(solid)), Each(Closure::kFacesIn));
    EXPECT_THAT(closureOfTriangles(soup(solid)), Each(Closure::kFacesOut)) << "places count, not indices";
  }
}

TEST(ClosedParts, solidsFarFromTheOriginFaceOut) {
  Mesh far;
  append(far, makeBox({1, 1, 1}), glm::translate(glm::mat4(1), glm::vec3(900, -700, 800)));
  EXPECT_THAT(closureOfTriangles(far), Each(Closure::kFacesOut));
}

TEST(ClosedParts, aSheetIsOpen) {
  Mesh sheet;
  sheet.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_THAT(closureOfTriangles(sheet), Each(Closure::kOpen));
}

// A box without one of its six faces: a border of length 4 a around a^2, taken as a circle of 16 a^2 / 4 pi = 1.27 a^2,
// a quarter of the 5 a^2 that are left.
TEST(ClosedParts, holesCountByTheirArea) {
  Mesh box = makeBox({1, 1, 1});
  const auto isTop = [&](const glm::uvec3& t) {
    return box.positions[t.x].y > 0 && box.positions[t.y].y > 0 && box.positions[t.z].y > 0;
  };
  box.triangles.erase(std::remove_if(box.triangles.begin(), box.triangles.end(), isTop), box.triangles.end());
  ASSERT_EQ(box.triangles.size(), 10u);
  EXPECT_THAT(closureOfTriangles(box, 0.25), Each(Closure::kOpen));
  EXPECT_THAT(closureOfTriangles(box, 0.26), Each(Closure::kFacesOut));
  // A scan with one small hole is a solid.
  Mesh sphere = makeSphere(40);
  sphere.triangles.erase(sphere.triangles.begin() + 200, sphere.triangles.begin() + 204);
  EXPECT_THAT(closureOfTriangles(sphere), Each(Closure::kFacesOut));
  EXPECT_THAT(closureOfTriangles(sphere, 0), Each(Closure::kOpen));
}

TEST(ClosedParts, partsAreJudgedOneByOne) {
  Mesh mesh = makeBox({1, 1, 1});
  const size_t boxTriangles = mesh.triangles.size();
  const auto first = static_cast<uint32_t>(mesh.positions.size());
  for (const glm::vec3& corner : {glm::vec3(5, 0, 0), glm::vec3(6, 0, 0), glm::vec3(6, 1, 0)}) {
    mesh.positions.push_back(corner);
  }
  mesh.triangles.emplace_back(first, first + 1, first + 2);
  const std::vector<Closure> closures = closureOfTriangles(mesh);
  for (size_t i = 0; i < boxTriangles; ++i) {
    EXPECT_EQ(closures[i], Closure::kFacesOut);
  }
  EXPECT_EQ(closures.back(), Closure::kOpen);
}

TEST(ClosedParts, trianglesThatDisagreeAboutOutsideAreOpen) {
  Mesh box = makeBox({1, 1, 1});
  for (size_t i = 0; i < box.triangles.size(); i += 2) {
    std::swap(box.triangles[i].y, box.triangles[i].z);
  }
  EXPECT_THAT(closureOfTriangles(box), Each(Closure::kOpen));
}

TEST(ClosedParts, degenerateInputIsOpen) {
  EXPECT_TRUE(closureOfTriangles({}).empty());
  Mesh flat;
  flat.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  flat.triangles = {{0, 0, 0}, {0, 1, 1}, {0, 1, 2}, {0, 2, 1}};  // points, a line, and a sheet closed upon itself
  EXPECT_THAT(closureOfTriangles(flat), Each(Closure::kOpen));
}

}  // namespace
}  // namespace ocelli
