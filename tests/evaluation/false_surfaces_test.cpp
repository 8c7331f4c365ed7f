#include "oc_core/evaluation/false_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::smallCamera;

constexpr float kWallDepth = 10;

/// Adds the rectangle whose image in the small camera is [u0, u1] x [v0, v1], at a depth.
void addImageRectangle(Mesh& mesh, float u0, float v0, float u1, float v1, float depth) {
  const PinholeCamera camera = smallCamera();
  const auto at = [&](float u, float v) { return *camera.unproject({u, v, depth}); };
  test::addQuad(mesh, at(u0, v1), at(u1, v1), at(u1, v0), at(u0, v0));
}

Mesh imageRectangle(float u0, float v0, float u1, float v1, float depth) {
  Mesh mesh;
  addImageRectangle(mesh, u0, v0, u1, v1, depth);
  return mesh;
}

struct Counts {
  size_t strict = 0;
  size_t thick = 0;
  size_t falseSkins = 0;
  size_t wrongFronts = 0;

  bool operator==(const Counts&) const = default;
  friend void PrintTo(const Counts& c, std::ostream* out) {
    *out << "strict " << c.strict << ", thick " << c.thick << ", false skins " << c.falseSkins << ", wrong fronts "
         << c.wrongFronts;
  }
};

Counts compare(const Mesh& scene, const Mesh& representation) {
  const PinholeCamera camera = smallCamera();
  const Image<glm::vec4> truth = positionImage(camera, scene);
  const Image<glm::vec4> frame = positionImage(camera, representation);
  const Image<SampleState> states = compareFrames(camera, truth, frame);
  const MissingSamples missing = countMissing(states);
  const auto marked = [](const Image<uint8_t>& map) {
    return static_cast<size_t>(std::count(map.begin(), map.end(), uint8_t{1}));
  };
  return {missing.strict, missing.thick, marked(falseSkins(camera, truth, frame, RayScene(scene))),
          marked(wrongFronts(camera, truth, frame, states))};
}

TEST(FalseSurfaces, noneInTheSceneItself) {
  for (const Mesh& mesh : {test::wall(0), test::boxBeforeWall(), makeSphere(20)}) {
    EXPECT_EQ(compare(mesh, mesh), Counts{});
  }
}

// A sheet of 10 x 6 pixels before the wall. What it hides is missing but for a rim of one pixel, whose neighbours show
// the wall.
TEST(FalseSurfaces, sheetBeforeTheWallIsFalseAndHidesIt) {
  const Mesh wall = imageRectangle(0, 0, 90, 60, kWallDepth);
  Mesh withSheet = wall;
  addImageRectangle(withSheet, 40, 20, 50, 26, 9);
  EXPECT_EQ(compare(wall, withSheet), (Counts{8 * 4, 6 * 2, 10 * 6, 8 * 4}));
}

TEST(FalseSurfaces, sheetOverNothingHidesNothing) {
  const Mesh wall = imageRectangle(0, 0, 30, 60, kWallDepth);
  Mesh withSheet = wall;
  addImageRectangle(withSheet, 40, 20, 50, 26, 9);
  EXPECT_EQ(compare(wall, withSheet), (Counts{0, 0, 10 * 6, 0}));
}

// Two squares, one before the other. Without the nearer one, the farther one shows: it is there, though hidden.
TEST(FalseSurfaces, hiddenSurfaceOfTheSceneIsNotFalse) {
  Mesh scene = imageRectangle(10, 10, 70, 50, kWallDepth);
  const Mesh farther = scene;
  addImageRectangle(scene, 30, 20, 50, 40, 9);
  EXPECT_EQ(compare(scene, farther), (Counts{20 * 20, 18 * 18, 0, 0}));
}

TEST(FalseSurfaces, reachIsOneAndAHalfFootprints) {
  const float footprint = kWallDepth / smallCamera().focalPixels();
  const Mesh wall = imageRectangle(0, 0, 90, 60, kWallDepth);
  EXPECT_EQ(compare(wall, imageRectangle(0, 0, 90, 60, kWallDepth - 1.4f * footprint)).falseSkins, 0u);
  EXPECT_EQ(compare(wall, imageRectangle(0, 0, 90, 60, kWallDepth - 1.6f * footprint)).falseSkins, 90u * 60);
  EXPECT_EQ(compare(wall, imageRectangle(0, 0, 90, 60, kWallDepth - 1.6f * footprint)).wrongFronts, 90u * 60);
  // Behind the wall nothing is hidden by it.
  EXPECT_EQ(compare(wall, imageRectangle(0, 0, 90, 60, kWallDepth + 1.6f * footprint)),
            (Counts{90 * 60, 88 * 58, 90 * 60, 0}));
}

// The square ends at 30.3. Pixel centres at 30.5 and 31.5 are 0.2 and 1.2 pixels away, 32.5 is 2.2 away.
TEST(FalseSurfaces, silhouetteMayStandOutByAPixel) {
  const Mesh scene = imageRectangle(20, 20, 30.3f, 30, kWallDepth);
  EXPECT_EQ(compare(scene, imageRectangle(20, 20, 32, 30, kWallDepth)), Counts{});
  EXPECT_EQ(compare(scene, imageRectangle(20, 20, 33, 30, kWallDepth)), (Counts{0, 0, 10, 0}));
}

// A skin from the edge of the nearer square back to the wall: false where it is more than 1.5 footprints from both.
TEST(FalseSurfaces, skinAcrossAGapIsFalseInItsMiddle) {
  const PinholeCamera camera = smallCamera();
  Mesh scene = imageRectangle(0, 0, 90, 60, kWallDepth);
  addImageRectangle(scene, 20, 10, 40, 50, 9);
  Mesh skinned = scene;
  const auto at = [&](float u, float v, float depth) { return *camera.unproject({u, v, depth}); };
  test::addQuad(skinned, at(40, 50, 9), at(48, 50, kWallDepth), at(48, 10, kWallDepth), at(40, 10, 9));
  const Counts counts = compare(scene, skinned);
  // Along a row of the skin 1/z is linear over the image; the surfaces that it joins are the wall and an edge.
  const auto falseColumns = [&] {
    size_t columns = 0;
    for (int u = 40; u < 48; ++u) {
      const float t = (static_cast<float>(u) + 0.5f - 40) / 8;
      const float z = 1 / ((1 - t) / 9 + t / kWallDepth);
      const glm::vec3 p = at(static_cast<float>(u) + 0.5f, 30, z);
      const float reach = 1.5f * z / camera.focalPixels();
      const glm::vec3 edge = at(40, 30, 9);
      columns += kWallDepth - z > reach && glm::distance(p, edge) > reach;
    }
    return columns;
  }();
  EXPECT_GT(falseColumns, 0u);
  EXPECT_EQ(counts.falseSkins, falseColumns * 40);
  EXPECT_GT(counts.wrongFronts, 0u);
  EXPECT_LE(counts.wrongFronts, counts.strict);
}

TEST(FalseSurfaces, nothingToCompareGivesNothing) {
  const Mesh wall = imageRectangle(0, 0, 90, 60, kWallDepth);
  EXPECT_EQ(compare(wall, Mesh{}), (Counts{90 * 60, 88 * 58, 0, 0}));
  Mesh behind = wall;  // the scene stands behind the eye
  for (glm::vec3& p : behind.positions) {
    p.z += 30;
  }
  EXPECT_EQ(compare(behind, behind), Counts{});
  EXPECT_EQ(compare(behind, wall), (Counts{0, 0, 90 * 60, 0}));
}

}  // namespace
}  // namespace ocelli
