// Graph and curved ray cameras on the GPU, against the rasteriser on the CPU.
#include "oc_core/gl/bent_ray_pass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <glm/ext/matrix_transform.hpp>

#include "oc_core/gl/gl_renderer.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/render/rasterize_curved.h"
#include "oc_core/render/rasterize_graph.h"
#include "oc_core/scene/densify.h"
#include "oc_core/worlds/scene_source.h"
#include "oc_core/worlds/solids.h"
#include "tests/camera/test_curved_cameras.h"
#include "tests/camera/test_graph_cameras.h"
#include "tests/gl/gl_test_context.h"
#include "tests/render/ray_agreement.h"
#include "tests/render/render_checks.h"

namespace ocelli {
namespace {

using test::coveredPixels;
using test::Disagreement;
using test::disagreement;

PinholeCamera pinhole() {
  return {View{}, 270, 180};
}

GraphCamera limited() {
  GraphCamera graph = test::crossroads(pinhole());
  graph.limit(1, Plane::through({0, 0, -0.4}, {0.1, 0, -1}));
  graph.limit(2, Plane::through({0, 0, -0.2}, {0, 0.2, -1}));
  return graph;
}

class BentRayPassTest : public testing::TestWithParam<GlProvider> {
 protected:
  std::unique_ptr<GlContext> context_ = openTestContext(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Providers, BentRayPassTest, kOffscreenProviders, providerName);

template <class C>
void expectAgreement(const C& camera, const Mesh& mesh, const GlRenderer& renderer, const char* scene) {
  const Disagreement d = disagreement(rasterize(camera, mesh), renderer.draw(camera), 1e-3f);
  EXPECT_GT(d.samples, 2000u);
  EXPECT_LE(d.differing, d.samples / 200) << scene << ": " << d;
  EXPECT_LE(d.apart, d.samples / 5000) << scene << ": " << d;
}

TEST_P(BentRayPassTest, movesAndReplacesVertices) {
  const Mesh first = loadScene("builtin:boxes", {}, {});
  GlRenderer renderer(*context_, first);
  Mesh moved = loadScene("builtin:statues", {}, {});
  renderer.setMesh(moved);
  const GraphCamera graph = test::crossroads(pinhole());
  EXPECT_EQ(renderer.draw(graph), GlRenderer(*context_, moved).draw(graph));
  const FragmentImage before = renderer.draw(pinhole());
  const size_t count = moved.positions.size() / 4;
  for (size_t v = count; v < 2 * count; ++v) {
    moved.positions[v] += glm::vec3(0.1f, 0.3f, -0.2f);
  }
  renderer.moveVertices(moved, count, count);
  const GlRenderer fresh(*context_, moved);
  EXPECT_EQ(renderer.draw(graph), fresh.draw(graph));
  EXPECT_EQ(renderer.draw(pinhole()), fresh.draw(pinhole()));
  EXPECT_NE(renderer.draw(pinhole()), before);
}

TEST_P(BentRayPassTest, agreesWithTheCpu) {
  for (const char* scene : {"builtin:boxes", "builtin:statues", "builtin:fence,gap=4", "builtin:room"}) {
    const Mesh mesh = loadScene(scene, {}, {});
    const GlRenderer renderer(*context_, mesh);
    expectAgreement(GraphCamera(pinhole()), mesh, renderer, scene);
    expectAgreement(test::crossroads(pinhole()), mesh, renderer, scene);
    expectAgreement(limited(), mesh, renderer, scene);
    expectAgreement(CurvedRayCamera(pinhole()), mesh, renderer, scene);
    expectAgreement(test::bendingRight(pinhole()), mesh, renderer, scene);
    expectAgreement(test::bendingTwice(pinhole()), mesh, renderer, scene);
    expectAgreement(test::bendingTwice(pinhole(), ArcModel::kBezier), mesh, renderer, scene);
  }
}

TEST_P(BentRayPassTest, wallsAllAroundLeaveNoCrack) {
  Mesh box;
  append(box, makeBox({3.5f, 2.6f, 20}), glm::translate(glm::mat4(1), glm::vec3(0.2f, 0.1f, -8)));
  for (const size_t triangles : {12, 5000}) {
    Mesh mesh;
    append(mesh, box, glm::rotate(glm::mat4(1), 0.1f, glm::vec3(0.2f, 0.6f, 0.7f)));
    densify(mesh, triangles);
    const GlRenderer renderer(*context_, mesh);
    EXPECT_EQ(coveredPixels(renderer.draw(test::crossroads(pinhole()))), 270u * 180) << triangles;
    EXPECT_EQ(coveredPixels(renderer.draw(test::bendingTwice(pinhole()))), 270u * 180) << triangles;
  }
}

TEST_P(BentRayPassTest, drawsTheSameBytesAgainAndLeavesOtherCamerasAlone) {
  const Mesh mesh = loadScene("builtin:boxes", {}, {});
  const GlRenderer renderer(*context_, mesh);
  const FragmentImage before = renderer.draw(pinhole());
  const FragmentImage graph = renderer.draw(test::crossroads(pinhole()));
  const FragmentImage curved = renderer.draw(test::bendingTwice(pinhole()));
  EXPECT_EQ(renderer.draw(test::crossroads(pinhole())), graph);
  EXPECT_EQ(renderer.draw(test::bendingTwice(pinhole())), curved);
  EXPECT_EQ(renderer.draw(pinhole()), before);
}

TEST_P(BentRayPassTest, brokenTrianglesLeaveTheirNeighboursAlone) {
  Mesh mesh = loadScene("builtin:boxes", {}, {});
  const auto drawn = [&] {
    const GlRenderer renderer(*context_, mesh);
    return std::pair(renderer.draw(test::crossroads(pinhole())), renderer.draw(test::bendingTwice(pinhole())));
  };
  const auto whole = drawn();
  test::addBrokenTriangles(mesh);
  const auto broken = drawn();
  EXPECT_EQ(whole.first, broken.first);
  EXPECT_EQ(whole.second, broken.second);
  mesh = {};
  EXPECT_EQ(coveredPixels(drawn().first), 0u);
  EXPECT_EQ(coveredPixels(drawn().second), 0u);
}

// All over the mesh, whole blocks of them, and also where vertices move there and back.
TEST_P(BentRayPassTest, leavesOutTrianglesThatAreNotFinite) {
  Mesh mesh = loadScene("builtin:boxes", {}, {});
  densify(mesh, 4000);
  const Mesh whole = mesh;
  const Mesh without = test::breakTriangles(mesh);
  ASSERT_GT(mesh.triangles.size(), 2048u);
  const auto images = [&](const GlRenderer& renderer) {
    return std::array{renderer.draw(GraphCamera(pinhole())), renderer.draw(test::crossroads(pinhole())),
                      renderer.draw(limited()), renderer.draw(test::bendingTwice(pinhole()))};
  };
  const auto expected = images(GlRenderer(*context_, without));
  EXPECT_GT(coveredPixels(expected[1]), 2000u);
  EXPECT_EQ(images(GlRenderer(*context_, mesh)), expected);
  // The same triangles, of corners that are moved away and come back.
  Mesh moving = mesh;
  std::vector<glm::vec3> wrong;
  const size_t first = whole.positions.size();
  for (size_t v = first; v < moving.positions.size(); ++v) {
    wrong.push_back(moving.positions[v]);
    moving.positions[v] = {0.3f, 0.2f, 0.1f};
  }
  GlRenderer renderer(*context_, moving);
  EXPECT_NE(images(renderer), expected);
  std::copy(wrong.begin(), wrong.end(), moving.positions.begin() + static_cast<std::ptrdiff_t>(first));
  renderer.moveVertices(moving, first, wrong.size());
  EXPECT_EQ(images(renderer), expected);
}

}  // namespace
}  // namespace ocelli
