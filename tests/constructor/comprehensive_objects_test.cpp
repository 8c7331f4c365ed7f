#include "oc_core/constructor/comprehensive_objects.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "oc_core/base/error.h"
#include "oc_core/render/rasterize_graph.h"
#include "oc_core/worlds/solids.h"
#include "tests/constructor/maze_seen.h"

namespace ocelli {
namespace {

/// Of each object, by identity.
std::vector<size_t> drawnPixels(const GraphCamera& camera, const GuidedScene& scene, size_t objects) {
  std::vector<size_t> pixels(objects + 1, 0);
  for (const Fragment& fragment : rasterize(camera, scene.mesh)) {
    if (fragment.covered()) {
      ++pixels[scene.objectOfTriangle[fragment.triangle]];
    }
  }
  return pixels;
}

TEST(ComprehensiveObjects, whatIsCountedIsDrawn) {
  const test::MazeWithObjects made(5);
  const GraphCamera camera = makeComprehensiveCamera(made.maze, {}, 1920, 1200);
  const std::vector<size_t> counted = pixelsOfObjects(camera, made.scene);
  ASSERT_EQ(counted.size(), made.objects + 1);
  EXPECT_EQ(counted[0], 0u);
  const std::vector<size_t> drawn = drawnPixels(camera, made.scene, made.objects);
  for (size_t object = 1; object <= made.objects; ++object) {
    EXPECT_LE(counted[object], drawn[object] + 1) << object;  // 1 for rounding
    EXPECT_EQ(counted[object] >= 2, drawn[object] >= 2) << object;
  }
}

TEST(ComprehensiveObjects, otherOptionsShowWhatIsHidden) {
  const test::MazeWithObjects made(5);  // its third object stands wholly behind another
  ASSERT_EQ(drawnPixels(makeComprehensiveCamera(made.maze, {}, 1920, 1200), made.scene, made.objects)[3], 0u);
  const ComprehensiveChoice choice = chooseComprehensive(made.scene, {}, 1920, 1200);
  EXPECT_TRUE(choice.unseen.empty());
  const GraphCamera chosen = makeComprehensiveCamera(made.maze, choice.options, 1920, 1200);
  EXPECT_GT(drawnPixels(chosen, made.scene, made.objects)[3], 4u);
}

TEST(ComprehensiveObjects, whereAllIsSeenTheGivenOptionsStay) {
  const test::MazeWithObjects made(10);
  ComprehensiveOptions given;
  given.eyeHeight = 2.25;
  const ComprehensiveChoice choice = chooseComprehensive(made.scene, given, 1920, 1200);
  EXPECT_TRUE(choice.unseen.empty());
  EXPECT_EQ(choice.options.eyeHeight, 2.25);
  EXPECT_EQ(choice.options.evenness, given.evenness);
}

TEST(ComprehensiveObjects, whatNoOptionsShowIsNamed) {
  test::MazeWithObjects made(10);
  // Object 1 in a box without an opening.
  Box box;
  for (size_t i = 0; i < made.scene.mesh.triangles.size(); ++i) {
    for (int k = 0; made.scene.objectOfTriangle[i] == 1 && k < 3; ++k) {
      box.add(made.scene.mesh.positions[made.scene.mesh.triangles[i][k]]);
    }
  }
  const Mesh around = makeBox(box.size() * 0.55f);
  const auto first = static_cast<uint32_t>(made.scene.mesh.positions.size());
  for (const glm::vec3& position : around.positions) {
    made.scene.mesh.positions.push_back(position + box.center());
  }
  made.scene.mesh.colors.resize(made.scene.mesh.positions.size(), glm::vec3(1));
  for (const glm::uvec3& triangle : around.triangles) {
    made.scene.mesh.triangles.push_back(triangle + first);
    made.scene.objectOfTriangle.push_back(static_cast<uint32_t>(made.objects + 1));
  }
  const ComprehensiveChoice choice = chooseComprehensive(made.scene, {}, 1920, 1200);
  EXPECT_EQ(choice.unseen, std::vector<uint32_t>{1});
}

TEST(ComprehensiveObjects, aSceneWithoutAMazeIsRefused) {
  EXPECT_THROW(chooseComprehensive({}, {}, 800, 600), InputError);
}

}  // namespace
}  // namespace ocelli
