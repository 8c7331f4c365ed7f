// The figures that the depth discontinuity occlusion camera must reach on the scenes of section 3.5.5.7, at the size of
// the published measurements. The scenes come from the meshes in $OCELLI_DATA_DIR.
#include <gtest/gtest.h>

#include <cstdlib>

#include "oc_core/evaluation/evaluation_table.h"
#include "oc_core/ocri/ddoc_builder.h"
#include "oc_core/ocri/image_mesh.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

struct Goal {
  const char* scene;
  double strictRatio;
  double thickRatio;
};

bool meshesAreAtHand() {
  return std::getenv("OCELLI_DATA_DIR") != nullptr;
}

void expectFigures(const Goal& goal) {
  if (!meshesAreAtHand()) {
    GTEST_SKIP() << "OCELLI_DATA_DIR is not set: the meshes of the published scenes are not at hand";
  }
  EvaluationOptions options;
  options.width = kDefaultWidth;
  options.height = kDefaultHeight;
  options.interiorViews = 4;
  const auto figures = evaluate(loadScene(goal.scene),
                                {cameraChoice("di"), cameraChoice("ddoc"), cameraChoice("ddoc-constant")}, options);
  const RepresentationFigures& di = figures[0];
  const RepresentationFigures& ddoc = figures[1];
  EXPECT_LE(ddoc.strictRatioToDi, goal.strictRatio);
  EXPECT_LE(ddoc.thickRatioToDi, goal.thickRatio);
  EXPECT_LE(ddoc.triangles, di.triangles);
  EXPECT_LE(di.reference.strictRatio(), 0.0005);
  EXPECT_LE(ddoc.reference.strictRatio(), 0.002);
  EXPECT_LT(ddoc.interior.strictRatio(), di.interior.strictRatio());
  // The text's own construction helps as well, though less.
  EXPECT_LT(figures[2].strictRatioToDi, 1);
  EXPECT_LT(ddoc.strictRatioToDi, figures[2].strictRatioToDi);
  std::printf("%s\n%s", goal.scene, evaluationTable(figures).c_str());
}

// A single object in a room: a fifth of the depth image's error and a twentieth of its wide holes.
TEST(PublishedScenes, bunny) {
  expectFigures({"builtin:room,mesh=bunny.obj", 0.20, 0.05});
}

TEST(PublishedScenes, dragon) {
  expectFigures({"builtin:room,mesh=dragon.obj", 0.20, 0.05});
}

TEST(PublishedScenes, armadillo) {
  expectFigures({"builtin:room,mesh=armadillo.ply", 0.20, 0.05});
}

// Statues that hide each other.
TEST(PublishedScenes, fourBuddhas) {
  expectFigures({"builtin:statues,mesh=buddha.obj", 0.39, 0.15});
}

/// From the reference viewpoint to the cell's border along several directions: an occlusion camera that helps far away
/// may do next to no harm nearby.
void expectNoHarmNearby(const char* scene) {
  if (!meshesAreAtHand()) {
    GTEST_SKIP() << "OCELLI_DATA_DIR is not set: the meshes of the published scenes are not at hand";
  }
  const Mesh mesh = loadScene(scene);
  const View view;
  const PinholeCamera reference(view, kDefaultWidth, kDefaultHeight);
  const Mesh depth = imageMesh(buildDepthImage(reference, mesh));
  const Mesh ddoc = imageMesh(buildDdocImage(reference, mesh, DdocOptions{}));
  const float halfSide = ViewCell{}.sideRadii / 2;
  for (const float share : {0.0f, 0.02f, 0.05f, 0.1f, 0.2f, 0.5f, 1.0f}) {
    for (const glm::vec3 direction : {glm::vec3(1, 0, 0), glm::vec3(0, -1, 0), glm::vec3(0, 0, 1),
                                      glm::vec3(-0.7f, 0.7f, 0), glm::vec3(0.6f, 0.6f, -0.6f)}) {
      const PinholeCamera camera(movedEye(view, direction * share * halfSide), kDefaultWidth, kDefaultHeight);
      const Image<glm::vec4> truth = positionImage(camera, mesh);
      const auto missing = [&](const Mesh& shown) {
        return countMissing(compareFrames(camera, truth, positionImage(camera, shown))).strictRatio();
      };
      // A tenth of the side is a fifth of the half side. Nearer, the depth image itself lacks up to 0.8 % where its
      // pixels fall beside the eye's by a part of a pixel: that much on top is allowed.
      const double allowed = share < 0.2f ? 0.002 : 0;
      EXPECT_LE(missing(ddoc), missing(depth) + allowed)
          << scene << ", " << share << " along " << direction.x << " " << direction.y << " " << direction.z;
    }
  }
}

TEST(PublishedScenes, noHarmNearbyBunny) {
  expectNoHarmNearby("builtin:room,mesh=bunny.obj");
}

TEST(PublishedScenes, noHarmNearbyDragon) {
  expectNoHarmNearby("builtin:room,mesh=dragon.obj");
}

TEST(PublishedScenes, noHarmNearbyArmadillo) {
  expectNoHarmNearby("builtin:room,mesh=armadillo.ply");
}

TEST(PublishedScenes, noHarmNearbyFourBuddhas) {
  expectNoHarmNearby("builtin:statues,mesh=buddha.obj");
}

}  // namespace
}  // namespace ocelli
