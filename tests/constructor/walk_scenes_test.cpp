// Cameras of the walk maps that are found in built-in scenes (oc_core/walkable).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <vector>

#include "oc_core/constructor/walk_camera.h"
#include "oc_core/constructor/walk_comprehensive.h"
#include "oc_core/walkable/walkable.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/constructor/walk_checks.h"

namespace ocelli {
namespace {

/// What must be seen of a scene, by ray casting: a little less than it is (1, 1 and 1), so that a change for
/// the worse shows.
struct SeenShare {
  const char* scene;
  double cells;  ///< of those that are connected
};

/// Of each cell the pixels that show the floor in its middle, by ray casting: what stands before it hides it.
std::vector<size_t> pixelsOnFloors(const WalkMap& map, const GraphCamera& camera, const Mesh& mesh) {
  constexpr float kOnFloor = 0.3f;  // metres: kerbs and rugs are floor
  const FragmentImage image = raycast(camera, mesh, RayScene(mesh));
  std::vector<size_t> pixels(map.cells.size());
  for (const Fragment& fragment : image) {
    if (!fragment.covered()) {
      continue;
    }
    const glm::vec3 point = positionOf(fragment, mesh);
    for (size_t i = 0; i < pixels.size(); ++i) {
      const WalkCell& cell = map.cells[i];
      const glm::vec3 from = point - cell.center;
      const float half = std::min(cell.halfLength, cell.halfWidth) / 2;
      const float along = glm::dot(from, cell.axis);
      const float above = from.y - cell.floorRise * along / (2 * cell.halfLength);
      pixels[i] += std::abs(along) <= half && std::abs(glm::dot(from, cell.right())) <= half &&
                           std::abs(above) <= kOnFloor + std::abs(cell.floorRise) / 10
                       ? 1
                       : 0;
    }
  }
  return pixels;
}

class WalkScenes : public testing::TestWithParam<SeenShare> {};

TEST_P(WalkScenes, areSeenInOneImage) {
  SceneOptions options;
  options.fit = false;
  const std::string name = GetParam().scene;
  const GuidedScene scene = loadGuidedScene(name, options);
  const WalkMap map = findWalkMap(scene.mesh, inUnits({}, metreOf(name, scene).units));
  const RayScene rays(scene.mesh);
  const ComprehensiveWalk walk = makeComprehensiveWalk(map, {}, 1920, 1080, &rays);
  const std::vector<size_t> pixels = pixelsOnFloors(map, walk.camera, scene.mesh);
  size_t connected = 0;
  size_t seen = 0;
  size_t seenUntold = 0;
  for (size_t i = 0; i < walk.cells.size(); ++i) {
    const WalkCellView& view = walk.cells[i];
    connected += view.unseen != WalkUnseen::kNoWay ? 1 : 0;
    seen += pixels[i] >= 4 ? 1 : 0;
    if (view.unseen != WalkUnseen::kNothing) {
      std::printf("%s, cell %zu: %s (%.2f pixels, %.2f seen, in cell %d)\n", name.c_str(), i, textOf(view.unseen),
                  view.pixels, view.seenPixels, view.hiddenIn);
      seenUntold += pixels[i] >= 4 ? 1 : 0;
    } else {
      EXPECT_GE(pixels[i], 4u) << "cell " << i << " is not seen";
    }
    EXPECT_EQ(view.hiddenIn >= 0, view.unseen == WalkUnseen::kHidden) << "cell " << i;
  }
  std::printf("%s: %zu cells, %zu connected, %zu seen\n", name.c_str(), walk.cells.size(), connected, seen);
  // Rays that come to a cell by chance are sampled: few pixels of theirs may be missed.
  EXPECT_LE(seenUntold, 1u);
  EXPECT_GE(static_cast<double>(seen), GetParam().cells * static_cast<double>(connected));
  test::keepImage(walk.camera, scene.mesh, "comprehensive_" + name.substr(8));
  // Rays of strips cross: 17 % at most of what is seen is shown twice.
  EXPECT_LT(test::shownTwiceShare(walk.camera, scene.mesh), 0.25);
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, WalkScenes,
                         testing::Values(SeenShare{"builtin:house", 0.95}, SeenShare{"builtin:house,seed=3", 0.95},
                                         SeenShare{"builtin:house,seed=7", 0.95}));

double coveredShare(const Image<Fragment>& image) {
  const auto covered = std::count_if(image.begin(), image.end(), [](const Fragment& each) { return each.covered(); });
  return static_cast<double>(covered) / static_cast<double>(image.size());
}

TEST(WalkCameraInAHouse, showsTheWallsThatThePinholeShows) {
  SceneOptions options;
  options.fit = false;
  const std::string name = "builtin:house";
  const GuidedScene scene = loadGuidedScene(name, options);
  const WalkMap map = findWalkMap(scene.mesh, inUnits({}, metreOf(name, scene).units));
  const RayScene rays(scene.mesh);
  const WalkSpace space(map);
  constexpr int kWidth = 96;
  constexpr int kHeight = 54;
  double worst = 0;
  double sum = 0;
  size_t bent = 0;
  for (const WalkCell& cell : map.cells) {
    for (int quarter = 0; quarter < 4; ++quarter) {
      const glm::dvec3 axis(cell.axis);
      const glm::dvec3 right(cell.right());
      const std::array<glm::dvec3, 4> headings{axis, right, -axis, -right};
      const WalkPose pose{glm::dvec3(cell.center) + glm::dvec3(0, 1.6, 0), headings[static_cast<size_t>(quarter)]};
      const WalkCamera camera = makeWalkCamera(space, pose, {}, kWidth, kHeight);
      if (!camera.note.empty()) {
        continue;
      }
      ++bent;
      const double before = coveredShare(raycast(walkPinhole(space, pose, {}, kWidth, kHeight), scene.mesh, rays));
      const double after = coveredShare(raycast(camera.camera, scene.mesh, rays));
      worst = std::max(worst, before - after);
      sum += before - after;
    }
  }
  std::printf("%zu images: %.4f of a pinhole's less in the mean, %.4f at most\n", bent, sum / static_cast<double>(bent),
              worst);
  // Windows are in other places of the image, and doors lead outside. Where rays end at the sides of cells, it is 0.32
  // and 1.
  EXPECT_GT(bent, 20U);
  EXPECT_LT(sum / static_cast<double>(bent), 0.01);
  EXPECT_LT(worst, 0.1);
}

}  // namespace
}  // namespace ocelli
