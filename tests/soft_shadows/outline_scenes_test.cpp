// Outlines of whole scenes and of reference images, against the slow reference and against traced rays.
#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/union_mesh.h"
#include "oc_core/soft_shadows/light_shadow_map.h"
#include "oc_core/soft_shadows/outline_visibility.h"
#include "oc_core/soft_shadows/traced_visibility.h"
#include "oc_core/soft_shadows/visibility_reference.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/soft_shadows/light_scenes.h"

namespace ocelli {
namespace {

double rmseOf(const std::vector<float>& found, const std::vector<float>& truth) {
  double squares = 0;
  for (size_t i = 0; i < found.size(); ++i) {
    squares += std::pow(static_cast<double>(found[i] - truth[i]), 2);
  }
  return std::sqrt(squares / static_cast<double>(found.size()));
}

/// The teapot, fitted to the unit sphere, one unit over the floor.
Mesh floatingTeapot() {
  Mesh mesh;
  append(mesh, loadScene("builtin:teapot"), glm::translate(glm::mat4(1), {0, 1.2f, 0}));
  mesh.colors.clear();
  return mesh;
}

// Thousands of small triangles that share edges: what the fast way says is what each sample by itself says.
TEST(OutlineScenes, ofATeapotIsThatOfTheSlowReference) {
  const Mesh mesh = floatingTeapot();
  const AreaLight light = test::lightAbove(false, 1, 1);
  const std::vector<ShadowReceiver> receivers = test::floorGrid(5, 1.4f);
  const LightVisibility found = OutlineVisibility(mesh, light).of(receivers);
  for (size_t i = 0; i < receivers.size(); ++i) {
    EXPECT_NEAR(found.share[i], visibilitySlowly(mesh, light, receivers[i]), 3.01f / 1024) << i;
  }
}

// A reference image at the light: what it is off by is what its estimate says, but for what the image does not hold.
TEST(OutlineScenes, ofReferenceImagesAreAsGoodAsTheySay) {
  const Mesh mesh = floatingTeapot();
  const AreaLight light = test::lightAbove(false, 1, 1);
  const std::vector<ShadowReceiver> receivers = test::floorGrid(60, 2.2f);
  const std::vector<float> truth = TracedVisibility(mesh, light, 1024).of(receivers).share;
  ViewCell cell;
  cell.shape = ViewCell::Shape::kSphere;
  cell.sideRadii = 1.42f;
  double last = 1;
  for (const int height : {20, 40, 80}) {
    const PinholeCamera reference(lightView(light, mesh, height * 3 / 2, height, "test"), height * 3 / 2, height);
    const Mesh sampled = unionMesh(buildReferenceImages(cameraChoice("ldi-4", cell), reference, mesh));
    OutlineOptions options;
    options.footprintPerDistance = 1 / reference.focalPixels();
    options.lift.perDistance = 1.5f / reference.focalPixels();
    const LightVisibility found = OutlineVisibility(sampled, light, options).of(receivers);
    const double rmse = rmseOf(found.share, truth);
    double expected = 0;
    for (const float each : found.estimatedError) {
      expected += static_cast<double>(each) * static_cast<double>(each);
    }
    expected = std::sqrt(expected / static_cast<double>(receivers.size()));
    EXPECT_LT(rmse, 1.3 * expected) << height;
    EXPECT_GT(rmse, expected / 12) << height << ": an estimate that says nothing";
    EXPECT_LT(rmse, last) << height;
    last = rmse;
  }
  EXPECT_LT(last, 0.008);
}

}  // namespace
}  // namespace ocelli
