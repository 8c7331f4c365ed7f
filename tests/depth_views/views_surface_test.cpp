#include "oc_core/depth_views/views_surface.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "oc_core/base/parallel.h"
#include "oc_core/depth_views/views_scene.h"
#include "oc_core/evaluation/evaluation.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/render/raycast.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/depth_views/test_views.h"

namespace ocelli {
namespace {

/// Samples of the views that lie farther from the surface than `footprints` of their own.
size_t lostSamples(const std::vector<DepthView>& views, const Mesh& surface, float footprints) {
  const RayScene rays(surface);
  size_t lost = 0;
  for (const DepthView& view : views) {
    const PinholeCamera camera = view.image.reference();
    for (int y = 0; y < view.image.height(); ++y) {
      for (int x = 0; x < view.image.width(); ++x) {
        const auto point = view.image.pointOf(x, y, camera);
        lost += point && !rays.closestSurface(*point, footprints * view.image.t(x, y) / camera.focalPixels());
      }
    }
  }
  return lost;
}

Mesh occluders() {
  Mesh scene;
  test::addWall(scene, -0.6f, 3, {0.2f, 0.4f, 0.8f});
  test::addWall(scene, 0.4f, 0.3f, {0.8f, 0.3f, 0.1f});
  return scene;
}

// The slow reference asks for the closest point of the whole surface for each sample that there was. A dropped sample
// has one that stays within three quarters of a space between samples, and that may be dropped for another one: a
// grazing surface has spaces of several footprints, these scenes of less than two.
TEST(ViewsSurface, nothingThatAViewShowsIsLost) {
  for (const Mesh& scene : {test::tiltedPlane(0.5f), occluders()}) {
    const std::vector<DepthView> views = test::cornerViews(scene, 8);
    const ViewsSurface surface = surfaceOfViews(views);
    EXPECT_EQ(surface.samples, sampleCount(views));
    EXPECT_EQ(lostSamples(views, surface.mesh, 2), 0u);
  }
}

TEST(ViewsSurface, aViewThatIsLeftOutIsMissed) {
  const std::vector<DepthView> views = test::cornerViews(occluders(), 8);
  const ViewsSurface middle = surfaceOfViews({views[0]});
  EXPECT_GT(lostSamples(views, middle.mesh, 2), 100u);
}

TEST(ViewsSurface, samplesOfOnePlaceStayOnce) {
  const Mesh scene = test::tiltedPlane(0.3f);
  const std::vector<DepthView> views = test::cornerViews(scene, 8);
  const ViewsSurface all = surfaceOfViews(views, {.keepsAll = true});
  EXPECT_EQ(all.keptSamples(), sampleCount(views));
  const ViewsSurface once = surfaceOfViews(views);
  // Nine views of a plane: that of one view, and around it what others see beyond its border.
  EXPECT_LT(once.keptSamples(), 2 * views[0].image.sampleCount());
  EXPECT_GE(once.keptSamples(), views[0].image.sampleCount());
  EXPECT_EQ(once.kept[0], views[0].image.sampleCount());
  EXPECT_TRUE(once.mesh.isPart);
  EXPECT_TRUE(once.mesh.isSampled);
}

TEST(ViewsSurface, theViewThatSeesMostSharplyStays) {
  const Mesh scene = test::wall(0, 0.4f);
  View far;
  View near;
  near.eye = {0, 0, 2};
  near.fovVerticalDegrees = far.resolvedFovVerticalDegrees() * 5;
  std::vector<DepthView> views;
  for (const View& view : {far, near}) {
    const PinholeCamera camera(view, test::kWidth, test::kHeight);
    views.push_back({"v" + std::to_string(views.size()), buildDepthImage(camera, scene)});
  }
  near.fovVerticalDegrees = 20;
  views.push_back({"sharp", buildDepthImage({near, test::kWidth, test::kHeight}, scene)});
  const ViewsSurface surface = surfaceOfViews(views);
  EXPECT_EQ(surface.kept[2], views[2].image.sampleCount());
  // Of the others what it does not see, and a seam.
  EXPECT_LT(surface.kept[0], views[0].image.sampleCount());
}

TEST(ViewsSurface, isTheSameWithAnyNumberOfThreads) {
  const std::vector<DepthView> views = test::cornerViews(occluders(), 8);
  setThreadCount(1);
  const ViewsSurface one = surfaceOfViews(views);
  setThreadCount(4);
  const ViewsSurface four = surfaceOfViews(views);
  setThreadCount(0);
  EXPECT_EQ(one.kept, four.kept);
  EXPECT_EQ(one.mesh.positions, four.mesh.positions);
  EXPECT_EQ(one.mesh.triangles, four.mesh.triangles);
}

// The image of the middle view is made of samples that are at the middles of its pixels: rounding of 10 units apart. At
// rims squares of other views may stand half a pixel before what is behind.
TEST(ViewsSurface, imagesOfViewsAreThoseOfTheScene) {
  const Mesh scene = occluders();
  const PinholeCamera reference = test::smallCamera();
  const std::vector<DepthView> views = test::cornerViews(scene, 8, reference);
  const ViewsSurface surface = surfaceOfViews(views);
  const ReferenceImage truth = buildDepthImage(reference, scene);
  const auto differing = [&](const Mesh& mesh) {
    const ReferenceImage image = buildDepthImage(reference, mesh);
    size_t count = 0;
    for (size_t i = 0; i < truth.t.size(); ++i) {
      count += truth.held[i] != image.held[i] || std::abs(truth.t[i] - image.t[i]) > 1e-3f ||
               glm::distance(truth.color[i], image.color[i]) > 1e-3f;
    }
    return count;
  };
  const size_t samples = truth.sampleCount();
  EXPECT_LE(differing(surface.mesh), samples / 100);
  // Views of another scene give another image.
  EXPECT_GT(differing(surfaceOfViews(test::cornerViews(test::wall(-0.6f), 8, reference)).mesh), samples / 50);
}

TEST(ViewsSurface, camerasSeeAroundThingsAsOfTheScene) {
  const Mesh scene = occluders();
  const PinholeCamera reference = test::smallCamera();
  const ViewsSurface surface = surfaceOfViews(test::cornerViews(scene, 8, reference));
  for (const char* name : {"ddoc", "ldi-2", "eoc-hv"}) {
    const auto samples = [&](const Mesh& mesh) {
      size_t count = 0;
      for (const ReferenceImage& image : buildReferenceImages(cameraChoice(name), reference, mesh)) {
        count += image.sampleCount();
      }
      return static_cast<double>(count);
    };
    EXPECT_NEAR(samples(surface.mesh), samples(scene), 0.05 * samples(scene)) << name;
  }
}

// Behind the wall there is nothing: what overlaps of the views is no second layer.
TEST(ViewsSurface, overlapsAreNoLayers) {
  const PinholeCamera reference = test::smallCamera();
  const Mesh scene = test::tiltedPlane(0.3f);
  ViewsSurface surface = surfaceOfViews(test::cornerViews(scene, 8, reference), {.keepsAll = true});
  const auto layers = [&] { return buildReferenceImages(cameraChoice("ldi-4"), reference, surface.mesh); };
  EXPECT_EQ(layers().size(), 1u);
  surface.mesh.isSampled = false;
  EXPECT_GT(layers().size(), 1u);
}

TEST(ViewsScene, isMeasuredAgainstTheSceneItself) {
  // All of it is in the image, from wherever it is seen.
  Mesh scene;
  test::addWall(scene, -0.6f, 0.7f, {0.2f, 0.4f, 0.8f});
  test::addWall(scene, 0.4f, 0.3f, {0.8f, 0.3f, 0.1f});
  EvaluationOptions options;
  options.width = test::kWidth;
  options.height = test::kHeight;
  options.interiorViews = 2;
  const PinholeCamera reference(View{}, options.width, options.height);
  const auto missing = [&](const Mesh& surface) {
    const ViewsScene measured(scene, surface);
    return Evaluator(measured, options).measure(cameraChoice("ldi-2")).edges.strictRatio();
  };
  const std::vector<DepthView> views = test::cornerViews(scene, 8, reference);
  const double ofAll = missing(surfaceOfViews(views).mesh);
  EXPECT_LT(ofAll, 0.02);
  EXPECT_GT(missing(surfaceOfViews({views[0]}).mesh), 2 * ofAll + 0.01);
}

}  // namespace
}  // namespace ocelli
