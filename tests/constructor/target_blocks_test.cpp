// How often a target among 700 blocks is in sight of a pinhole, and of the curved ray camera that looks for it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "oc_core/base/conventions.h"
#include "oc_core/base/random.h"
#include "oc_core/constructor/target_constructor.h"
#include "oc_core/render/raycast.h"

namespace ocelli {
namespace {

/// The share of the target's pixels that nothing hides, by rays and real triangles instead of boxes.
class SeenShare {
 public:
  explicit SeenShare(const GuidedScene& scene)
      : scene_(scene), target_(onlyTarget(scene)), all_(scene.mesh), alone_(target_) {}

  template <Camera C>
  double of(const C& camera) const {
    size_t seen = 0;
    for (const Fragment& fragment : raycast(camera, scene_.mesh, all_)) {
      seen += fragment.covered() && scene_.objectOfTriangle[fragment.triangle] == scene_.guides.target->object;
    }
    size_t whole = 0;
    for (const Fragment& fragment : raycast(camera, target_, alone_)) {
      whole += fragment.covered();
    }
    return whole == 0 ? 0 : static_cast<double>(seen) / static_cast<double>(whole);
  }

 private:
  static Mesh onlyTarget(const GuidedScene& scene) {
    Mesh mesh;
    mesh.positions = scene.mesh.positions;
    for (size_t i = 0; i < scene.objectOfTriangle.size(); ++i) {
      if (scene.objectOfTriangle[i] == scene.guides.target->object) {
        mesh.triangles.push_back(scene.mesh.triangles[i]);
      }
    }
    return mesh;
  }

  const GuidedScene& scene_;
  Mesh target_;
  RayScene all_;
  RayScene alone_;
};

TEST(TargetBlocks, theCurvedRayCameraShowsTheTargetMoreOften) {
  const GuidedScene scene = loadGuidedScene("builtin:boxes,count=700,floor=1");
  const Box target = scene.guides.target->box;
  const SeenShare seenShare(scene);
  Random random(1);
  for (const double elevation : {15.0, 25.0, 35.0}) {
    constexpr int kViews = 100;
    int pinholes = 0;
    int cameras = 0;
    int bent = 0;
    int bentInVain = 0;
    for (int i = 0; i < kViews; ++i) {
      const double azimuth = static_cast<double>(random.inRange(0, 1)) * 2 * kPi;
      const double up = radiansFromDegrees(elevation);
      View view;
      view.target = target.center();
      view.eye = view.target + glm::vec3(glm::dvec3(std::cos(up) * std::cos(azimuth), std::sin(up),
                                                    std::cos(up) * std::sin(azimuth)));
      view.fovVerticalDegrees = 50;
      const PinholeCamera reference(view, 320, 180);
      const CurvedRayCamera camera = buildTargetCamera({}, scene, reference);
      const double seen = seenShare.of(camera);
      pinholes += seenShare.of(reference) >= 0.5;
      cameras += seen >= 0.5;
      bent += !camera.bends().empty();
      bentInVain += !camera.bends().empty() && seen < 0.5;
    }
    std::printf(
        "%2.0f degrees up, of %d views: half of the target in sight of the pinhole in %d, of the camera in %d; "
        "bent in %d, of which in vain in %d\n",
        elevation, kViews, pinholes, cameras, bent, bentInVain);
    EXPECT_GE(cameras, pinholes + 10);
    // Boxes are larger than what is in them; but the target's box, too, of which half is not half of the target.
    EXPECT_LE(bentInVain, bent / 4);
  }
}

}  // namespace
}  // namespace ocelli
