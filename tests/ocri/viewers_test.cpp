#include "oc_core/ocri/viewers.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "oc_core/base/parallel.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/coverage.h"
#include "oc_core/ocri/union_mesh.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::kHeight;
using test::kWidth;

std::vector<ReferenceImages> imagesOf(const std::string& camera, const std::vector<View>& views, const Mesh& scene) {
  std::vector<ReferenceImages> images;
  for (const View& view : views) {
    images.push_back(buildReferenceImages(cameraChoice(camera), {view, kWidth, kHeight}, scene));
  }
  return images;
}

// Turns of coordinates of ten are rounded to about 1e-6.
TEST(ViewsAround, areTurnedAboutTheAxisInEqualSteps) {
  View first;
  first.eye = {2, 3, 9};
  first.target = {0.5f, 0, 0};
  for (const int count : {1, 2, 3, 4, 5, 6}) {
    const std::vector<View> views = viewsAround(first, count);
    ASSERT_EQ(views.size(), static_cast<size_t>(count));
    EXPECT_EQ(views[0], first);
    const float step = 2 * static_cast<float>(kPi) / static_cast<float>(count);
    for (int i = 0; i < count; ++i) {
      const View& view = views[static_cast<size_t>(i)];
      const View& next = views[static_cast<size_t>((i + 1) % count)];
      EXPECT_EQ(view.eye.y, first.eye.y);
      EXPECT_NEAR(glm::distance(view.eye, view.target), glm::distance(first.eye, first.target), 1e-5);
      const glm::vec2 here(view.eye.x, -view.eye.z);  // seen from above, x to the right and z towards the reader
      const glm::vec2 there(next.eye.x, -next.eye.z);
      EXPECT_NEAR(there.x, std::cos(step) * here.x - std::sin(step) * here.y, 1e-5);
      EXPECT_NEAR(there.y, std::sin(step) * here.x + std::cos(step) * here.y, 1e-5);
    }
  }
}

TEST(ViewsAround, theSecondOfFourStandsToTheRight) {
  const std::vector<View> views = viewsAround(View{}, 4);
  EXPECT_NEAR(glm::distance(views[1].eye, {10, 0, 0}), 0, 1e-5);
  EXPECT_NEAR(glm::distance(views[2].eye, {0, 0, -10}), 0, 1e-5);
}

TEST(MergeViewers, aViewerAloneStaysAsHeIs) {
  std::vector<ReferenceImages> images = imagesOf("ddoc", {View{}}, test::boxBeforeWall(0.9f));
  const Image<float> z = images[0][0].t;
  const MergedViewers merged = mergeViewers(std::move(images));
  ASSERT_EQ(merged.images.size(), 1u);
  EXPECT_EQ(merged.images[0].t, z);
  EXPECT_EQ(merged.shares[0].built, merged.shares[0].kept);
}

TEST(MergeViewers, aViewerGivenTwiceAddsNothing) {
  for (const char* camera : {"di", "ddoc", "eoc-hv"}) {
    const MergedViewers merged = mergeViewers(imagesOf(camera, {View{}, View{}}, test::boxBeforeWall(0.9f)));
    EXPECT_GT(merged.shares[0].kept, 0u);
    EXPECT_EQ(merged.shares[1].built, merged.shares[0].built);
    EXPECT_EQ(merged.shares[1].kept, 0u) << camera;
  }
}

// From behind, a wall without a thickness is the same surface.
TEST(MergeViewers, whatAnEarlierViewerSeesHeadOnIsNotStoredAgain) {
  const MergedViewers merged = mergeViewers(imagesOf("di", viewsAround(View{}, 2), test::wall(0, 0.5f)));
  EXPECT_GT(merged.shares[1].built, 100u);
  EXPECT_EQ(merged.shares[1].kept, 0u);
}

// Its normal is 84 degrees from the first viewer's direction: his samples lie ten footprints apart.
TEST(MergeViewers, whatAnEarlierViewerSeesAtAGrazingAngleIsSampledAgain) {
  Mesh wall = test::wall(0, 0.5f);
  const float angle = static_cast<float>(radiansFromDegrees(84));
  for (glm::vec3& p : wall.positions) {
    p = {p.x * std::cos(angle), p.y, p.x * std::sin(angle)};
  }
  const MergedViewers merged = mergeViewers(imagesOf("di", viewsAround(View{}, 4), wall));
  EXPECT_GT(merged.shares[1].kept, merged.shares[1].built / 2);
  EXPECT_LT(merged.shares[3].kept, merged.shares[3].built / 10);  // the second one has seen it head on
}

// Each viewer's own samples are there, from his place: seen by him the merged mesh lacks none of them, but for those
// that are nearer to a mesh of others than a footprint. The strict measure calls a sample present within 1.5.
TEST(MergeViewers, aViewerLacksNothingThatHisOwnImageHas) {
  const Mesh scene = test::boxBeforeWall(0.9f);
  for (const int count : {2, 3, 4, 5, 6}) {
    const std::vector<View> views = viewsAround(View{}, count);
    const std::vector<ReferenceImages> own = imagesOf("ddoc", views, scene);
    const Mesh merged = unionMesh(mergeViewers(own).images);
    for (size_t i = 0; i < views.size(); ++i) {
      const PinholeCamera camera(views[i], kWidth, kHeight);
      const Image<glm::vec4> truth = positionImage(camera, scene);
      const auto missing = [&](const Mesh& mesh) {
        return countMissing(compareFrames(camera, truth, positionImage(camera, mesh)));
      };
      const MissingSamples before = missing(unionMesh(own[i]));
      const MissingSamples after = missing(merged);
      EXPECT_LE(after.strict, before.strict) << count << " viewers, viewer " << i;
    }
  }
}

TEST(MergeViewers, isTheSameWithAnyNumberOfThreads) {
  const auto merge = [](int threads) {
    setThreadCount(threads);
    MergedViewers merged = mergeViewers(imagesOf("ddoc", viewsAround(View{}, 3), test::boxBeforeWall(0.9f)));
    setThreadCount(0);
    return merged;
  };
  const MergedViewers one = merge(1);
  const MergedViewers three = merge(3);
  ASSERT_EQ(one.images.size(), three.images.size());
  for (size_t i = 0; i < one.images.size(); ++i) {
    EXPECT_EQ(one.images[i].t, three.images[i].t);
    EXPECT_EQ(one.images[i].displacement, three.images[i].displacement);
  }
}

}  // namespace
}  // namespace ocelli
