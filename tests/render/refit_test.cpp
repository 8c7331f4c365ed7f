// Acceleration structures that follow moving triangles, against such as are built anew.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "oc_core/render/raycast.h"
#include "oc_core/render/refit_quality.h"
#include "oc_core/render/triangle_tree.h"
#include "oc_core/worlds/solids.h"
#include "tests/render/camera_cases.h"

namespace ocelli {
namespace {

class RandomRays {
 public:
  explicit RandomRays(unsigned seed) : random_(seed) {}
  float next() { return static_cast<float>(random_() >> 8) / static_cast<float>(1 << 23) - 1; }
  glm::vec3 point() { return {next(), next(), next()}; }
  RayPath ray() { return {3.0f * point(), 3.0f * point(), 3.0f * point()}; }

 private:
  std::mt19937 random_;
};

using Deformation = void (*)(Mesh&);

void squeeze(Mesh& mesh) {
  for (glm::vec3& p : mesh.positions) {
    p = {p.x * 0.1f, p.y * 2, p.z + p.x};
  }
}

/// Every layer turned by its height.
void twist(Mesh& mesh) {
  for (glm::vec3& p : mesh.positions) {
    const float angle = 5 * p.y;
    p = {std::cos(angle) * p.x - std::sin(angle) * p.z, p.y, std::sin(angle) * p.x + std::cos(angle) * p.z};
  }
}

/// Vertices change places: no triangle stays where it was, or near its neighbours.
void scatter(Mesh& mesh) {
  std::mt19937 random(5);
  for (size_t i = mesh.positions.size() - 1; i > 0; --i) {
    std::swap(mesh.positions[i], mesh.positions[random() % (i + 1)]);
  }
}

/// All in one plane.
void press(Mesh& mesh) {
  for (glm::vec3& p : mesh.positions) {
    p.z = 0.25f;
  }
}

class Refit : public testing::TestWithParam<Deformation> {
 protected:
  void SetUp() override {
    mesh = test::randomTriangles(500, 3);
    append(mesh, makeSphere(24));
  }
  Mesh mesh;
};

TEST_P(Refit, RaysMeetTheSameAsInAStructureThatIsBuiltAnew) {
  RayScene moving(mesh, RayScene::Quality::kLow, RayScene::Motion::kMoves);
  GetParam()(mesh);
  moving.update();
  const RayScene built(mesh);
  EXPECT_EQ(moving.bounds().lower, built.bounds().lower);
  EXPECT_EQ(moving.bounds().upper, built.bounds().upper);
  RandomRays random(7);
  std::vector<RayPath> rays;
  for (int i = 0; i < 4000; ++i) {
    rays.push_back(random.ray());
  }
  std::vector<Fragment> ofMoving(rays.size());
  std::vector<Fragment> ofBuilt(rays.size());
  moving.intersect(rays, ofMoving);
  built.intersect(rays, ofBuilt);
  size_t met = 0;
  for (size_t i = 0; i < rays.size(); ++i) {
    met += ofBuilt[i].covered() ? 1 : 0;
    ASSERT_EQ(ofMoving[i].covered(), ofBuilt[i].covered()) << i;
    // Where several triangles are met at one point (a shared edge, or all of them in one plane) either may be told.
    EXPECT_NEAR(ofMoving[i].t, ofBuilt[i].t, 1e-5f) << i;
    if (ofMoving[i].triangle == ofBuilt[i].triangle) {
      EXPECT_EQ(ofMoving[i].b1, ofBuilt[i].b1) << i;
    }
    const Fragment one = moving.intersect(rays[i]);
    EXPECT_EQ(one.covered(), ofBuilt[i].covered()) << i;
  }
  EXPECT_GT(met, 200u);
}

TEST_P(Refit, PointsAreAsNearAsInAStructureThatIsBuiltAnew) {
  RayScene moving(mesh, RayScene::Quality::kLow, RayScene::Motion::kMoves);
  GetParam()(mesh);
  moving.update();
  const RayScene built(mesh);
  RandomRays random(8);
  for (int i = 0; i < 500; ++i) {
    const glm::vec3 point = random.point();
    const auto a = moving.closestSurface(point, 0.5f);
    const auto b = built.closestSurface(point, 0.5f);
    ASSERT_EQ(a.has_value(), b.has_value());
    if (a) {
      EXPECT_EQ(a->triangle, b->triangle);
      EXPECT_EQ(a->position, b->position);
    }
  }
}

// Our own tree, which stands behind RayScene where the toolkit is built without Embree.
TEST_P(Refit, TheTreeMeetsTheSameAsOneThatIsBuiltAnew) {
  TriangleTree moving(mesh);
  GetParam()(mesh);
  moving.refit();
  const TriangleTree built(mesh);
  EXPECT_EQ(moving.bounds().lower, built.bounds().lower);
  EXPECT_EQ(moving.bounds().upper, built.bounds().upper);
  RandomRays random(9);
  size_t met = 0;
  for (int i = 0; i < 4000; ++i) {
    const glm::vec3 origin = 3.0f * random.point();
    const glm::vec3 step = random.point() - origin;
    const auto a = moving.meet(origin, step, 3);
    const auto b = built.meet(origin, step, 3);
    ASSERT_EQ(a.has_value(), b.has_value());
    if (a) {
      ++met;
      EXPECT_EQ(a->triangle, b->triangle);
      EXPECT_EQ(a->share, b->share);
    }
    const auto near = moving.nearest(origin, 2);
    const auto builtNear = built.nearest(origin, 2);
    ASSERT_EQ(near.has_value(), builtNear.has_value());
    EXPECT_TRUE(!near || near->triangle == builtNear->triangle);
  }
  EXPECT_GT(met, 200u);
}

INSTANTIATE_TEST_SUITE_P(Deformations, Refit, testing::Values(squeeze, twist, scatter, press));

TEST(RayScene, IsBuiltAnewWhereNeighboursPart) {
  Mesh mesh = makeSphere(64);
  RayScene scene(mesh, RayScene::Quality::kLow, RayScene::Motion::kMoves);
  EXPECT_EQ(scene.update(), RayScene::Update::kRefitted) << "nothing has moved";
  squeeze(mesh);
  EXPECT_EQ(scene.update(), RayScene::Update::kRefitted) << "neighbours stay neighbours";
  scatter(mesh);
  EXPECT_EQ(scene.update(), RayScene::Update::kRebuilt);
  EXPECT_EQ(scene.update(), RayScene::Update::kRefitted) << "as it was when it was built";
  const Mesh nothing;
  RayScene empty(nothing, RayScene::Quality::kLow, RayScene::Motion::kMoves);
  EXPECT_EQ(empty.update(), RayScene::Update::kRefitted);
  EXPECT_TRUE(empty.bounds().empty());
}

TEST(RefitQuality, DoesNotChangeWithTheScale) {
  Mesh mesh = makeSphere(64);
  const RefitQuality quality(mesh);
  EXPECT_DOUBLE_EQ(quality.ratio(), 1);
  for (glm::vec3& p : mesh.positions) {
    p = p * 100.0f + glm::vec3(7, 8, 9);
  }
  EXPECT_NEAR(quality.ratio(), 1, 1e-4);  // rounding of places far from the origin
  scatter(mesh);
  EXPECT_GT(quality.ratio(), 10);
  const Mesh empty;
  EXPECT_EQ(RefitQuality(empty).ratio(), 1);
}

TEST(RefitQuality, GrowsAsNeighboursPart) {
  Mesh mesh = makeSphere(64);
  const RefitQuality quality(mesh);
  double before = 1;
  for (const float bend : {0.5f, 1.0f, 2.0f, 4.0f}) {
    Mesh bent = mesh;
    for (glm::vec3& p : bent.positions) {
      p.x += bend * std::sin(40 * p.y);
    }
    std::swap(mesh.positions, bent.positions);
    EXPECT_GT(quality.ratio(), before) << bend;
    before = quality.ratio();
    std::swap(mesh.positions, bent.positions);
  }
}

}  // namespace
}  // namespace ocelli
