#include "oc_core/ocri/layered_depth_image.h"

#include <gtest/gtest.h>

#include <optional>

#include "oc_core/base/error.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::kHeight;
using test::kWidth;
using test::sameBytes;
using test::smallCamera;

/// z of the point where the ray of (u, v) enters the box, by slabs; nothing where it misses it.
std::optional<double> entryDepth(const PinholeCamera& camera, const Box& box, double u, double v) {
  const glm::dvec3 direction((u - kWidth / 2.0) / camera.focalPixels(), -(v - kHeight / 2.0) / camera.focalPixels(),
                             -1);
  double enter = 0;
  double leave = 1e30;
  for (int axis = 0; axis < 3; ++axis) {
    double a = (box.lower[axis] - camera.eye()[axis]) / direction[axis];
    double b = (box.upper[axis] - camera.eye()[axis]) / direction[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter < leave ? std::optional(enter) : std::nullopt;
}

const std::vector<Box>& boxes() {
  static const std::vector<Box> all{
      {{-0.3f, -0.3f, 0.5f}, {0.2f, 0.3f, 0.8f}},    {{-0.6f, -0.1f, -0.1f}, {0.4f, 0.5f, 0.3f}},
      {{-0.2f, -0.7f, -0.5f}, {0.7f, 0.2f, -0.2f}},  {{-0.9f, -0.5f, -0.9f}, {0.9f, 0.5f, -0.7f}},
      {{0.71f, -0.6f, -0.6f}, {0.85f, 0.6f, 0.75f}},
  };
  return all;
}

Mesh meshOfBoxes() {
  Mesh mesh;
  for (const Box& box : boxes()) {
    append(mesh, makeBox(box.size() * 0.5f), glm::translate(glm::mat4(1), box.center()));
  }
  return mesh;
}

TEST(LayeredDepthImage, layersOfBoxesAreWhereTheRayEntersThem) {
  const PinholeCamera camera = smallCamera();
  const ReferenceImages layers = buildLayeredDepthImage(camera, meshOfBoxes(), 8);
  ASSERT_EQ(layers.size(), 4u) << "no ray meets more than four of the boxes";
  size_t checked = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      std::vector<double> expected;
      bool nearSilhouette = false;
      for (const Box& box : boxes()) {
        const auto depth = entryDepth(camera, box, x + 0.5, y + 0.5);
        // Snapping moves silhouettes by up to 1/256 pixel, and flanks seen at a slant by many times their depth.
        for (const glm::dvec2& moved : {glm::dvec2(-0.01, 0), {0.01, 0}, {0, -0.01}, {0, 0.01}}) {
          const auto other = entryDepth(camera, box, x + 0.5 + moved.x, y + 0.5 + moved.y);
          nearSilhouette |= depth.has_value() != other.has_value() || (depth && std::abs(*depth - *other) > 0.01);
        }
        if (depth) {
          expected.push_back(*depth);
        }
      }
      if (nearSilhouette) {
        continue;
      }
      std::sort(expected.begin(), expected.end());
      for (size_t i = 0; i < layers.size(); ++i) {
        ASSERT_NEAR(layers[i].t(x, y), i < expected.size() ? expected[i] : 0.0, 0.01)
            << x << " " << y << " layer " << i;
      }
      checked += expected.size();
    }
  }
  EXPECT_GT(checked, 2000u);
}

TEST(LayeredDepthImage, theFirstLayerIsTheDepthImage) {
  const Mesh scene = test::ballBeforePlane();
  const ReferenceImage first = buildLayeredDepthImage(smallCamera(), scene, 3)[0];
  const ReferenceImage image = buildDepthImage(smallCamera(), scene);
  EXPECT_TRUE(sameBytes(first.t, image.t));
  EXPECT_TRUE(sameBytes(first.color, image.color));
  EXPECT_TRUE(sameBytes(first.displacement, image.displacement));
  EXPECT_EQ(first.view, image.view);
}

TEST(LayeredDepthImage, solidsHaveNoBackAndSheetsHave) {
  // A ball has one layer, inside out too; a sheet that faces away is seen all the same.
  Mesh ball = makeSphere(32);
  EXPECT_EQ(buildLayeredDepthImage(smallCamera(), ball, 4).size(), 1u);
  for (glm::uvec3& t : ball.triangles) {
    std::swap(t.y, t.z);
  }
  const ReferenceImages insideOut = buildLayeredDepthImage(smallCamera(), ball, 4);
  ASSERT_EQ(insideOut.size(), 1u);
  EXPECT_NEAR(insideOut[0].t(kWidth / 2, kHeight / 2), 9, 0.01);

  Mesh sheets = test::wall(0.5f);
  test::addQuad(sheets, {3, -3, 0}, {-3, -3, 0}, {-3, 3, 0}, {3, 3, 0});
  const ReferenceImages layers = buildLayeredDepthImage(smallCamera(), sheets, 4);
  ASSERT_EQ(layers.size(), 2u);
  EXPECT_EQ(layers[1].sampleCount(), static_cast<size_t>(kWidth * kHeight));
}

TEST(LayeredDepthImage, samplesKeepTheirColours) {
  const ReferenceImages layers = buildLayeredDepthImage(smallCamera(), test::boxBeforeWall(), 2);
  ASSERT_EQ(layers.size(), 2u);
  EXPECT_NEAR(layers[0].color(kWidth / 2, kHeight / 2).r, 0.8f, 1e-6f) << "the box";
  EXPECT_NEAR(layers[1].color(kWidth / 2, kHeight / 2).r, 0.5f, 1e-6f) << "the wall behind it";
}

// Behind the middle of a large wall nothing is seen; behind its rim the wall behind is, as far in as the cell uncovers
// it: half a side of 0.8 at a depth step from 9 to 11 is 0.8 * (11 - 9) / 9 = 0.18 on the wall behind.
TEST(LayeredDepthImage, unseenSamplesAreDropped) {
  const PinholeCamera camera = smallCamera();
  Mesh scene = test::wall(1, 0.5f);
  test::addWall(scene, -1, 3);
  ReferenceImages layers = buildLayeredDepthImage(camera, scene, 2);
  ASSERT_EQ(layers.size(), 2u);
  const ReferenceImages all = layers;
  dropUnseenSamples(layers, scene, ViewCell{1.6f});
  EXPECT_TRUE(sameBytes(layers[0].t, all[0].t));
  // The wall in front hides |x|, |y| < 0.5 * 11 / 9 = 0.61 of the one behind. The corners of the cell that are nearest
  // to the scene, 0.8 further on, uncover a little more.
  const float hiddenHalf = 0.5f * 11 / 9;
  const float least = 0.8f * 2 / 9.0f;
  const float most = 0.8f * 2 / (9 - 0.8f) + 0.5f * (10.2f / 8.2f - 11 / 9.0f);
  const float pixel = 11 / camera.focalPixels();
  size_t dropped = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      if (!all[1].holds(x, y)) {
        EXPECT_EQ(layers[1].t(x, y), 0);
        continue;
      }
      const glm::vec3 p = *camera.unproject(all[1].undistorted(x, y));
      const float fromRim = hiddenHalf - std::max(std::abs(p.x), std::abs(p.y));
      if (fromRim < least - 3 * pixel) {
        EXPECT_EQ(layers[1].t(x, y), all[1].t(x, y)) << x << " " << y;
      } else if (fromRim > most + 3 * pixel) {
        EXPECT_EQ(layers[1].t(x, y), 0) << x << " " << y;
        ++dropped;
      }
    }
  }
  EXPECT_GT(dropped, 100u);
}

TEST(LayeredDepthImage, unseenSamplesOfNothingAreNone) {
  ReferenceImages none;
  dropUnseenSamples(none, {}, ViewCell{});
  EXPECT_TRUE(none.empty());
  ReferenceImages single = buildLayeredDepthImage(smallCamera(), test::wall(0), 1);
  dropUnseenSamples(single, test::wall(0), ViewCell{});
  EXPECT_EQ(single[0].sampleCount(), static_cast<size_t>(kWidth * kHeight));
}

TEST(LayeredDepthImage, refusesNoLayersAndTooMany) {
  for (const int layers : {-1, 0, kMaxLayers + 1}) {
    EXPECT_THROW(buildLayeredDepthImage(smallCamera(), test::wall(0), layers), InputError);
  }
}

TEST(LayeredDepthImage, anEmptySceneGivesOneEmptyLayer) {
  const ReferenceImages layers = buildLayeredDepthImage(smallCamera(), {}, 4);
  ASSERT_EQ(layers.size(), 1u);
  EXPECT_EQ(layers[0].sampleCount(), 0u);
}

}  // namespace
}  // namespace ocelli
