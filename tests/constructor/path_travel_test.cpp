// What one sees who travels along a river with a path camera: how much consecutive images differ, beside those of the
// pinhole that travels along.
#include <gtest/gtest.h>

#include "oc_core/constructor/path_constructor.h"
#include "oc_core/render/raycast.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/constructor/image_change.h"

namespace ocelli {
namespace {

TEST(PathTravel, imagesChangeAsThePinholesDo) {
  const GuidedScene scene = loadGuidedScene("builtin:canyon", {.fit = false});
  const RayScene rays(scene.mesh);
  View view;
  view.fovVerticalDegrees = 40;
  view.zNear = 0.5f;
  view.zFar = 1500;
  const PinholeCamera reference(view, 160, 90);
  PathOptions options;
  options.preview = 0.25;
  options.turns = 4;
  options.eyeHeight = 45;
  test::ImageChange ofPinhole;
  test::ImageChange ofCamera;
  std::vector<double> ratios;
  double pinhole = 0;
  double camera = 0;
  size_t turns = 0;
  for (options.position = 0; options.position < 0.75; options.position += 1.0 / 600) {  // about 3 m
    const CurvedRayCamera curved = buildPathCamera(options, scene.guides, reference);
    turns += curved.bends().size();
    const auto one = ofPinhole.next(raycast(curved.root(), scene.mesh, rays), scene.mesh);
    const auto other = ofCamera.next(raycast(curved, scene.mesh, rays), scene.mesh);
    if (one) {
      ratios.push_back(*other / *one);
      pinhole = std::max(pinhole, *one);
      camera = std::max(camera, *other);
    }
  }
  test::report("camera / pinhole, each of the steps", ratios);
  std::printf("largest step: camera %.4f, pinhole %.4f; %.2f turns a frame\n", camera, pinhole,
              static_cast<double>(turns) / static_cast<double>(ratios.size() + 1));
  EXPECT_GT(turns, 2 * ratios.size());
  EXPECT_LE(camera, 1.1 * pinhole);
}

}  // namespace
}  // namespace ocelli
