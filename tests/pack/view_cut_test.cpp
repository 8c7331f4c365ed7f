#include "oc_core/render/view_cut.h"

#include <gtest/gtest.h>

#include "oc_core/render/rasterize.h"
#include "tests/base/temporary_folder.h"
#include "tests/pack/packed_meshes.h"

namespace ocelli {
namespace {

using test::TemporaryFolder;

struct Difference {
  size_t covered = 0;     ///< pixels that show the scene itself
  size_t onlyOne = 0;     ///< that only one of the two covers
  size_t otherDepth = 0;  ///< that differ by more than the allowed error at that depth
};

/// What `camera` sees of the scene itself and of the cut.
Difference difference(const Mesh& full, const Mesh& cut, const PinholeCamera& camera, float pixels) {
  const FragmentImage wanted = rasterize(camera, full);
  const FragmentImage got = rasterize(camera, cut);
  Difference found;
  for (size_t i = 0; i < wanted.size(); ++i) {
    found.covered += wanted[i].covered() ? 1 : 0;
    found.onlyOne += wanted[i].covered() != got[i].covered() ? 1 : 0;
    if (wanted[i].covered() && got[i].covered()) {
      // A surface that is off by e and seen at a grazing angle is off by more along the ray: three times is seldom.
      const float allowed = 3 * pixels * wanted[i].t / camera.focalPixels();
      found.otherDepth += std::abs(wanted[i].t - got[i].t) > allowed ? 1 : 0;
    }
  }
  return found;
}

TEST(ViewCut, LooksAsTheSceneItself) {
  const TemporaryFolder folder;
  const Mesh ball = test::bumpyBall(200'000);
  const PackedScene scene = test::packed(ball, folder / "ball.opack");
  for (const glm::vec3& eye : {glm::vec3(0, 0, 10), glm::vec3(4, 3, 1.5f), glm::vec3(0, -1.8f, 0.3f)}) {
    View view;
    view.eye = eye;
    view.fovVerticalDegrees = 30;
    const PinholeCamera camera(view, 360, 240);
    const Mesh cut = meshOf(scene, viewCut(scene, camera));
    EXPECT_LT(cut.triangles.size(), ball.triangles.size() / 2);
    const Difference found = difference(ball, cut, camera, kPackedErrorPixels);
    ASSERT_GT(found.covered, 3000U);
    // A quarter of a pixel at the silhouette, some 600 pixels long, and where bumps hide each other.
    EXPECT_LT(found.onlyOne, 300U);
    EXPECT_LT(found.otherDepth, found.covered / 50);
  }
}

TEST(ViewCut, TheScenesOwnTrianglesWhereNoErrorIsAllowed) {
  const TemporaryFolder folder;
  const Mesh ball = test::bumpyBall(20'000);
  const PackedScene scene = test::packed(ball, folder / "ball.opack");
  const PinholeCamera camera(View{}, 360, 240);
  const Difference found =
      difference(ball, meshOf(scene, viewCut(scene, camera, {.maxErrorPixels = 1e-12f})), camera, 0);
  EXPECT_EQ(found.onlyOne, 0U);
  EXPECT_EQ(found.otherDepth, 0U);
}

TEST(ViewCut, LeavesOutWhatIsBesideTheFrustum) {
  const TemporaryFolder folder;
  const PackedScene scene = test::packed(test::bumpyBall(60'000), folder / "ball.opack");
  View view;
  view.target = {0.5f, 0, 0};
  view.fovVerticalDegrees = 2;
  const size_t narrow = viewCut(scene, PinholeCamera(view, 300, 300)).size();
  view.fovVerticalDegrees = 20;
  const size_t wide = viewCut(scene, PinholeCamera(view, 3000, 3000)).size();
  EXPECT_LT(narrow, wide / 4);
  view.target = {0, 0, 20};
  EXPECT_TRUE(viewCut(scene, PinholeCamera(view, 300, 300)).empty());
}

/// What displaced samples and moved eyes see is there, too.
TEST(ViewCut, TheMarginHoldsWhatMovedEyesSee) {
  const TemporaryFolder folder;
  const Mesh ball = test::bumpyBall(60'000);
  const PackedScene scene = test::packed(ball, folder / "ball.opack");
  View view;
  view.fovVerticalDegrees = 4;
  const PinholeCamera camera(view, 300, 300);
  const Mesh cut = meshOf(scene, viewCut(scene, camera, {.reach = 1}));
  const PinholeCamera moved(
      [&] {
        View aside = view;
        aside.eye += glm::vec3(0.7f, 0.5f, 0.5f);
        aside.target += glm::vec3(0.7f, 0.5f, 0.5f);
        return aside;
      }(),
      300, 300);
  const Difference found = difference(ball, cut, moved, kPackedErrorPixels);
  EXPECT_LT(found.onlyOne, 300U);
}

}  // namespace
}  // namespace ocelli
