// Regions: where they are, how many samples they get, and what happens where they overlap.
#include "oc_core/antialiasing/antialias_regions.h"

#include <gtest/gtest.h>

#include "tests/antialiasing/antialias_scenes.h"

namespace ocelli::test {
namespace {

/// A background of two triangles, object 0, and two clusters of small ones, objects 1 and 2.
struct TwoClusters {
  PinholeCamera camera = flatCamera(160, 96);
  Mesh mesh;
  std::vector<uint32_t> objects;

  TwoClusters() {
    addFlat(mesh, {-400, -400}, {800, -400}, {-400, 800}, {0.5f, 0.5f, 0.2f}, camera);
    objects.push_back(0);
    for (uint32_t cluster = 0; cluster < 2; ++cluster) {
      const glm::vec2 corner = cluster == 0 ? glm::vec2(16, 24) : glm::vec2(104, 40);
      const Mesh cloud = triangleCloud(cluster == 0 ? 4000 : 9000, 0.02f);
      for (const glm::uvec3& t : cloud.triangles) {
        const auto at = [&](uint32_t i) {
          return corner + (glm::vec2(cloud.positions[i]) + 0.64f) * (cluster == 0 ? 20.0f : 26.0f);
        };
        addFlat(mesh, at(t.x), at(t.y), at(t.z), cloud.colors[t.x], camera, 1 + cloud.positions[t.x].z);
        objects.push_back(cluster + 1);
      }
    }
  }
};

bool holds(const PixelBounds& outer, const PixelBounds& inner) {
  return outer.x0 <= inner.x0 && outer.y0 <= inner.y0 && outer.x1 >= inner.x1 && outer.y1 >= inner.y1;
}

TEST(AntialiasRegions, areFoundWhereTrianglesAreDense) {
  const TwoClusters it;
  const AntialiasScene scene(it.camera, it.mesh);
  const std::vector<PixelBounds> found = denseRectangles(scene, 1);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_TRUE(holds({16, 24, 48, 56}, found[0])) << found[0].x0 << " " << found[0].x1;
  EXPECT_TRUE(holds({104, 40, 144, 80}, found[1])) << found[1].x0 << " " << found[1].x1;
  EXPECT_GT(trianglesPerPixel(scene, found[0]), 3);
  EXPECT_TRUE(denseRectangles(scene, 1000).empty());
}

TEST(AntialiasRegions, areBoxesAroundDenseObjects) {
  const TwoClusters it;
  const AntialiasScene scene(it.camera, it.mesh);
  const std::vector<PixelBounds> found = objectRectangles(scene, it.objects, 1);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_TRUE(holds({16, 24, 43, 51}, found[0]));
  EXPECT_TRUE(holds(found[0], {18, 26, 40, 48}));
  EXPECT_EQ(objectRectangles(scene, it.objects, 8).size(), 1U);  // 9,000 on 33 x 33 pixels, 4,000 on 25 x 25
}

TEST(AntialiasRegions, getWhatFitsTheirTile) {
  const TwoClusters it;
  const AntialiasScene scene(it.camera, it.mesh);
  const PixelBounds box{16, 24, 48, 56};
  EXPECT_EQ(fittedRegion(scene, box, {640, 640}).side, 20);
  // 4,000 triangles, some of which count in two blocks, on 32 x 32 pixels: 4.4 a pixel, and 16 * 4.4^(1/6) is 20.5.
  EXPECT_EQ(fittedRegion(scene, box, {6400, 6400}).side, 21);
  EXPECT_EQ(fittedRegion(scene, box, {320, 200}).side, 6);
  EXPECT_EQ(fittedRegion(scene, box, {10, 10}).side, 1);
  EXPECT_EQ(fittedRegion(scene, {0, 88, 8, 96}, {6400, 6400}).side, 8);  // of one triangle on 64 pixels
}

TEST(AntialiasRegions, overlapsTakeTheMostSamplesAndCountOnce) {
  const TwoClusters it;
  const AntialiasScene scene(it.camera, it.mesh);
  const std::vector<AntialiasRegion> regions = {{{10, 20, 60, 60}, 12, 1}, {{30, 30, 120, 70}, 4, 1}};
  const SamplePlacement& sheared = *findSamplePlacement("sheared");
  const Image<glm::vec3> both = scene.draw(regionPlan(it.camera, regions, sheared, 0, squareRule(1, "grid")), kNight);
  const Image<glm::vec3> fine = scene.draw(everywhere(squareRule(12, "sheared")), kNight);
  const Image<glm::vec3> coarse = scene.draw(everywhere(squareRule(4, "sheared")), kNight);
  const Image<glm::vec3> plain = scene.draw(everywhere(squareRule(1, "grid")), kNight);
  for (int y = 0; y < 96; ++y) {
    for (int x = 0; x < 160; ++x) {
      const bool inFirst = x >= 10 && x < 60 && y >= 20 && y < 60;
      const bool inSecond = x >= 30 && x < 120 && y >= 30 && y < 70;
      EXPECT_EQ(both(x, y), (inFirst ? fine : inSecond ? coarse : plain)(x, y)) << x << " " << y;
    }
  }
  // Outside has as many samples as one of them: it is as good there.
  const AntialiasPlan plan = regionPlan(it.camera, regions, sheared, 0, squareRule(4, "grid"));
  EXPECT_EQ(plan.ruleOfPixel(100, 50), 0);
  EXPECT_EQ(plan.ruleOfPixel(40, 40), 1);
  // Whichever comes first.
  EXPECT_EQ(scene.draw(regionPlan(it.camera, {regions[1], regions[0]}, sheared, 0, squareRule(1, "grid")), kNight),
            both);
}

}  // namespace
}  // namespace ocelli::test
