#include "oc_core/scene/point_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/base/random.h"
#include "oc_core/scene/shading.h"
#include "tests/scene/mesh_checks.h"

namespace ocelli {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

PointCloud cloudOf(std::vector<glm::vec3> positions) {
  return {std::move(positions), {}, {}};
}

/// About evenly on the unit sphere (Vogel 1979).
PointCloud spherePoints(size_t count) {
  std::vector<glm::vec3> points;
  for (size_t i = 0; i < count; ++i) {
    const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(count);
    const double angle = 2.399963229728653 * static_cast<double>(i);
    points.push_back(glm::vec3(std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle), z));
  }
  return cloudOf(points);
}

glm::vec3 normalOf(const Mesh& mesh, size_t triangle) {
  const glm::uvec3& t = mesh.triangles[triangle];
  return glm::normalize(areaNormal(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]));
}

TEST(PointMesh, OfASphereAreItsTangentPanels) {
  const PointCloud cloud = spherePoints(3000);
  const PointMesh points = meshOfPoints(cloud, {}, "test");
  EXPECT_EQ(points.facts.points, 3000u);
  EXPECT_EQ(points.facts.panels, 3000u);
  ASSERT_EQ(points.mesh.triangles.size(), 6000u);
  EXPECT_TRUE(points.mesh.colors.empty());
  for (size_t i = 0; i < 3000; ++i) {
    // Planes of ten neighbours, which are 0.11 away, are tilted by less than 0.06 from the tangent.
    EXPECT_GT(glm::dot(normalOf(points.mesh, 2 * i), cloud.positions[i]), 0.998f) << i;
  }
  // 1.15 squared times the area of the sphere, and what rectangles have more than cells: twice at the most.
  EXPECT_GT(areaOf(points.mesh), 1.32 * 12.566);
  EXPECT_LT(areaOf(points.mesh), 2 * 1.32 * 12.566);
  // sqrt(4 pi / 3000) is 0.065.
  EXPECT_TRUE(points.facts.areWidthsChosen);
  EXPECT_NEAR(points.facts.medianWidth, 0.065 * 1.15, 0.025);
  EXPECT_LE(points.facts.narrowest, points.facts.medianWidth);
  EXPECT_LE(points.facts.medianWidth, points.facts.widest);
}

TEST(PointMesh, IsAsLargeAsItsPointsAndWhereTheyAre) {
  PointCloud moved = spherePoints(500);
  for (glm::vec3& position : moved.positions) {
    position = 1e-20f * position + glm::vec3(3e-20f, 0, 0);
  }
  const PointMesh tiny = meshOfPoints(moved, {}, "test");
  const PointMesh unit = meshOfPoints(spherePoints(500), {}, "test");
  EXPECT_NEAR(tiny.facts.medianWidth * 1e20, unit.facts.medianWidth, 1e-4);
  EXPECT_NEAR(boundsOf(tiny.mesh).center().x * 1e20f, 3, 0.05f);
  PointCloud huge = spherePoints(500);
  for (glm::vec3& position : huge.positions) {
    position *= 1e30f;
  }
  EXPECT_NEAR(meshOfPoints(huge, {}, "test").facts.medianWidth * 1e-30, unit.facts.medianWidth, 1e-4);
}

TEST(PointMesh, HasSquaresOfTheWidthThatIsGiven) {
  const PointMesh points = meshOfPoints(spherePoints(200), {.width = 0.04}, "test");
  EXPECT_FALSE(points.facts.areWidthsChosen);
  EXPECT_NEAR(points.facts.medianWidth, 0.04, 1e-6);
  EXPECT_NEAR(areaOf(points.mesh), 200 * 0.04 * 0.04, 1e-6);
}

TEST(PointMesh, TrustsNormalsThatAreGiven) {
  PointCloud cloud = spherePoints(400);
  cloud.normals.assign(400, glm::vec3(0, -5, 0));
  cloud.normals[7] = glm::vec3(0);
  cloud.normals[8] = glm::vec3(std::numeric_limits<float>::quiet_NaN(), 0, 0);
  const PointMesh points = meshOfPoints(cloud, {}, "test");
  EXPECT_EQ(points.facts.panels, 398u);
  EXPECT_EQ(points.facts.solids, 2u) << "those without a direction";
  EXPECT_NEAR(normalOf(points.mesh, 0).y, -1, 1e-5f);
  EXPECT_NO_THROW(validate(points.mesh, "test"));
}

TEST(PointMesh, HasClosedSolidsWhereThereIsNoSurface) {
  std::vector<glm::vec3> line;
  for (int i = 0; i < 40; ++i) {
    line.push_back({static_cast<float>(i), 0, 0});
  }
  const PointMesh points = meshOfPoints(cloudOf(line), {}, "test");
  EXPECT_EQ(points.facts.solids, 40u);
  EXPECT_TRUE(isClosed(points.mesh));
  EXPECT_GT(signedVolume(points.mesh), 0);
  // The nearest six are 1, 1, 2, 2, 3, 3 away but near the ends; an octahedron reaches 0.75 of their mean.
  EXPECT_NEAR(points.facts.medianWidth, 2 * 0.75 * 2, 1e-4);
}

TEST(PointMesh, KeepsColorsAndTheOrderOfTheFile) {
  PointCloud cloud = spherePoints(300);
  for (size_t i = 0; i < 300; ++i) {
    cloud.colors.push_back(glm::vec3(static_cast<float>(i) / 300, 0, 1));
  }
  // Repeated points lose against the first one.
  cloud.positions.insert(cloud.positions.begin() + 10, cloud.positions[4]);
  cloud.colors.insert(cloud.colors.begin() + 10, glm::vec3(0, 1, 0));
  const PointMesh points = meshOfPoints(cloud, {}, "test");
  EXPECT_EQ(points.facts.points, 301u);
  EXPECT_EQ(points.facts.repeated, 1u);
  ASSERT_EQ(points.mesh.positions.size(), 1200u);
  for (size_t i = 0; i < 1200; ++i) {
    EXPECT_EQ(points.mesh.colors[i], glm::vec3(static_cast<float>(i / 4) / 300, 0, 1));
  }
}

TEST(PointMesh, CountsPointsAsRepeatedThatRoundingPutsAtOnePlace) {
  // The box is from 0 to 2, so that points are moved by 1, near which floats are 6e-8 apart; near 0 they are closer.
  PointCloud cloud = cloudOf({{0, 0.5f, 0}, {2, 0.5f, 0}});
  for (int i = 0; i < 900; ++i) {
    const float x = static_cast<float>(i % 30 + 1) / 1024;
    const float y = static_cast<float>(i / 30) / 32;
    cloud.positions.push_back({x, y, 0});
    cloud.positions.push_back({std::nextafter(x, 2.0f), y, 0});
  }
  const PointMesh points = meshOfPoints(cloud, {}, "test");
  EXPECT_EQ(points.facts.points, 1802u);
  EXPECT_EQ(points.facts.repeated, 900u);
  EXPECT_NO_THROW(validate(points.mesh, "test"));
}

TEST(PointMesh, DoesNotLetAPointFarAwayGrow) {
  PointCloud cloud = spherePoints(300);
  cloud.positions.push_back({40, 0, 0});
  const PointMesh points = meshOfPoints(cloud, {}, "test");
  EXPECT_NEAR(points.facts.widest, 4 * points.facts.medianWidth, 1e-5);
}

TEST(PointMesh, IsTheSameWithAnyNumberOfThreads) {
  Random random(6);
  std::vector<glm::vec3> positions(20'000);
  for (glm::vec3& position : positions) {
    position = {random.inRange(0, 1), random.inRange(0, 1), random.inRange(0, 1)};
    position.z = position.x < 0.5f ? 0.1f * position.x : position.z;
  }
  setThreadCount(1);
  const Mesh one = meshOfPoints(cloudOf(positions), {}, "test").mesh;
  setThreadCount(4);
  const Mesh four = meshOfPoints(cloudOf(positions), {}, "test").mesh;
  setThreadCount(0);
  EXPECT_EQ(one.positions, four.positions);
  EXPECT_EQ(one.triangles, four.triangles);
}

TEST(PointMesh, SaysWhatIsWrong) {
  const auto make = [](std::vector<glm::vec3> positions, const PointSceneOptions& options = {}) {
    return meshOfPoints(cloudOf(std::move(positions)), options, "cloud.ply");
  };
  EXPECT_THAT([&] { make({}); }, ThrowsMessage<InputError>(AllOf(HasSubstr("no points"), HasSubstr("cloud.ply"))));
  EXPECT_THAT([&] { make({{1, 2, 3}}); }, ThrowsMessage<InputError>(HasSubstr("--point-size")));
  EXPECT_THAT([&] { make({{1, 2, 3}, {1, 2, 3}}); }, ThrowsMessage<InputError>(HasSubstr("at one place")));
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    EXPECT_THAT([&] { make({{0, 0, 0}, {1, 0, 0}, {0, bad, 0}}); }, ThrowsMessage<InputError>(HasSubstr("point 2")));
  }
  EXPECT_EQ(make({{1, 2, 3}}, {.width = 0.5}).mesh.triangles.size(), 8u);
  EXPECT_EQ(make({{1, 2, 3}, {1, 2, 3}}, {.width = 0.5}).facts.repeated, 1u);
  for (size_t count = 2; count < 12; ++count) {
    EXPECT_NO_THROW(validate(make(spherePoints(count).positions).mesh, "few")) << count;
  }
}

}  // namespace
}  // namespace ocelli
