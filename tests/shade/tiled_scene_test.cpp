#include "oc_core/shade/tiled_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/shade/shaded_scene.h"
#include "oc_core/worlds/builtin_scenes.h"

namespace ocelli {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(TiledScene, copiesOfAMeshAreTilesOfOneObject) {
  const char* const source = "builtin:parking,tiles=5";
  const ShadedScene scene = loadShadedScene(source, rolesFor(source, ""));
  ASSERT_NE(scene.tiled, nullptr);
  const TiledScene& tiled = *scene.tiled;
  EXPECT_EQ(tiled.objects.size(), 1u);
  EXPECT_EQ(tiled.tiles.size(), 5u);
  // In the unit sphere.
  EXPECT_NEAR(glm::length(boundsOf(tiled.objects[0]).center()), 0, 1e-5f);
  // Where they stand in the scene that other commands load, and all there is.
  const GuidedScene loaded = loadGuidedScene(source);
  Box tiles;
  size_t triangles = 0;
  for (size_t i = 0; i < loaded.mesh.triangles.size(); ++i) {
    if (loaded.objectOfTriangle[i] == 1) {
      ++triangles;
      for (int corner = 0; corner < 3; ++corner) {
        tiles.add(loaded.mesh.positions[loaded.mesh.triangles[i][corner]]);
      }
    }
  }
  const Box own = boundsOf(tiled.flatTiles());
  EXPECT_NEAR(glm::distance(own.lower, tiles.lower), 0, 1e-4f);
  EXPECT_NEAR(glm::distance(own.upper, tiles.upper), 0, 1e-4f);
  EXPECT_EQ(tiled.flatTiles().triangles.size(), triangles);
  EXPECT_EQ(tiled.around.triangles.size(), loaded.mesh.triangles.size() - triangles);
  // Other effects take them as what they are besides.
  EXPECT_EQ(scene.cast.triangles.size(), triangles);
  EXPECT_EQ(scene.billboards.triangles.size(), tiled.around.triangles.size());
}

TEST(TiledScene, sourcesStandAtPlaces) {
  RoledObject balls{.roles = kIsRelief, .source = "builtin:sphere,segments=16", .radius = 0.5};
  balls.places = {{1, 2, 3, 0}, {-1, 0, 0, 45}};
  RoledObject another = balls;
  another.places.clear();
  another.center = {0, 5, 0};
  const ShadedScene scene = loadShadedScene("builtin:box", {{.object = 0, .roles = kCasts}, balls, another});
  const TiledScene& tiled = *scene.tiled;
  EXPECT_EQ(tiled.objects.size(), 1u);
  ASSERT_EQ(tiled.tiles.size(), 3u);
  EXPECT_NEAR(glm::distance(glm::vec3(tiled.tiles[0].worldFromTile[3]), {1, 2, 3}), 0, 1e-6f);
  EXPECT_NEAR(glm::distance(glm::vec3(tiled.tiles[2].worldFromTile[3]), {0, 5, 0}), 0, 1e-6f);
  EXPECT_NEAR(boundsOf(tiled.flatTiles()).size().y, 5 + 0.5f + 0.5f, 1e-4f);
  EXPECT_EQ(scene.surroundings.triangles.size(), 3 * tiled.objects[0].triangles.size());
}

TEST(TiledScene, withoutTheRoleThereIsNone) {
  EXPECT_EQ(loadShadedScene("builtin:box", {{.object = 0, .roles = kCasts}}).tiled, nullptr);
  SceneOptions moving;
  moving.motion.seconds = 0;
  EXPECT_THAT([&] { loadTiledScene("builtin:waving", {{.object = 0, .roles = kIsRelief}}, glm::mat4(1), moving); },
              ThrowsMessage<InputError>(HasSubstr("moves has no relief tiles")));
}

}  // namespace
}  // namespace ocelli
