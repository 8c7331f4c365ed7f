#include "display_sim/quilt/quilt_images.h"

#include <gtest/gtest.h>

#include "display_sim/quilt/color_and_depth.h"
#include "display_sim/quilt/quilt_errors.h"
#include "display_sim/quilt/quilt_render.h"
#include "display_sim/quilt/quilt_ways.h"
#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/render/raycast.h"
#include "oc_core/render/scene_renderer.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

// Small tiles, whose pixels are not square: 120 x 120 for an aspect of 0.75.
const QuiltDisplay kSmall{"small", 3, 3, 360, 360, 0.75, 30};

Mesh sceneFor(const QuiltViews& views, const std::string& name, double sampling = 1) {
  Mesh scene = loadScene(name);
  views.stretchScene(scene, views.stretch() * sampling);
  return scene;
}

/// Both show a sample of the same colour, or none: what was filled in does not count.
bool isAlike(const QuiltPicture& a, size_t i, const QuiltPicture& b, size_t k, int levels) {
  if (a.inverseZ[i] == 0 || b.inverseZ[k] == 0) {
    return a.inverseZ[i] == b.inverseZ[k];
  }
  bool alike = true;
  for (int c = 0; c < 3; ++c) {
    alike = alike && std::abs(a.color[i][c] - b.color[k][c]) <= levels;
  }
  return alike;
}

/// Share of the pixels whose colours differ by more than `levels` in a channel, or of which only one shows anything.
double differing(const QuiltPicture& a, const QuiltPicture& b, int levels) {
  size_t count = 0;
  for (size_t i = 0; i < a.color.size(); ++i) {
    count += isAlike(a, i, b, i, levels) ? 0 : 1;
  }
  return static_cast<double>(count) / static_cast<double>(a.color.size());
}

/// Whether the pixels around one all show the same surface, in both pictures.
bool isInside(const QuiltViews& views, const QuiltPicture& a, const QuiltPicture& b, int x, int y) {
  constexpr float kFootprints = 5;
  const float w = a.inverseZ(x, y);
  const float step = w * kFootprints / views.camera(0).focalPixels();  // of 1/z, for so many z / f
  for (const QuiltPicture* picture : {&a, &b}) {
    for (int k = 0; k < 9; ++k) {
      if (!(std::abs(picture->inverseZ(x - 1 + k % 3, y - 1 + k / 3) - w) <= step)) {
        return false;
      }
    }
  }
  return w > 0;
}

/// Of the pixels inside of surfaces, the share whose colours differ by more than `levels`.
double differingInside(const QuiltViews& views, const QuiltPicture& a, const QuiltPicture& b, int levels) {
  size_t inside = 0;
  size_t different = 0;
  for (int y = 1; y + 1 < a.color.height(); ++y) {
    for (int x = 1; x + 1 < a.color.width(); ++x) {
      if (isInside(views, a, b, x, y)) {
        ++inside;
        different += isAlike(a, a.color.index(x, y), b, b.color.index(x, y), levels) ? 0 : 1;
      }
    }
  }
  EXPECT_GT(inside, 1000u);
  return static_cast<double>(different) / static_cast<double>(inside);
}

/// The images of both sides drawn by their meshes, each for its own views.
QuiltPicture byMeshes(const QuiltViews& views, const Mesh& scene, int images) {
  const double stretch = views.stretch();
  const PinholeCamera middle = views.middle(stretch, views.display().tileWidth());
  const glm::vec3 left = views.eyeIn(stretch, 0);
  const glm::vec3 right = views.eyeIn(stretch, views.count() - 1);
  if (images == 1) {
    return quiltFromMesh(views, {buildEocImage(middle, {left, right}, scene)}, stretch, QuiltDepths::kKept);
  }
  QuiltPicture whole =
      quiltFromMesh(views, {buildEocImage(middle, {middle.eye(), right}, scene)}, stretch, QuiltDepths::kKept);
  const QuiltPicture other =
      quiltFromMesh(views, {buildEocImage(middle, {middle.eye(), left}, scene)}, stretch, QuiltDepths::kKept);
  for (int view = 0; view < views.count() / 2; ++view) {
    const glm::ivec2 origin = views.tileOrigin(view);
    for (int y = 0; y < views.display().tileHeight(); ++y) {
      for (int x = 0; x < views.display().tileWidth(); ++x) {
        whole.color(origin.x + x, origin.y + y) = other.color(origin.x + x, origin.y + y);
        whole.inverseZ(origin.x + x, origin.y + y) = other.inverseZ(origin.x + x, origin.y + y);
      }
    }
  }
  return whole;
}

class QuiltFromLines : public testing::TestWithParam<const char*> {};

/// The samples of `a` that `b` lacks, by the measure of coverage.h: 3x3 pixels, 1.5 footprints.
double lacking(const QuiltViews& views, const QuiltPicture& a, const QuiltPicture& b) {
  MissingSamples missing;
  for (int view = 0; view < views.count(); ++view) {
    missing += countMissing(
        compareFrames(views.camera(view), tileFrame(views, a, view).points, tileFrame(views, b, view).points));
  }
  EXPECT_GT(missing.truth, 0u);
  return missing.strictRatio();
}

// The same surfaces by rows and by triangles. They differ by a pixel where a surface ends: the mesh closes it by the
// samples of two rows, and a line by its own; two of a thousand samples lie where that leaves no neighbour.
TEST_P(QuiltFromLines, areTheViewsOfTheMesh) {
  const QuiltViews views(kSmall, View{});
  const Mesh scene = sceneFor(views, GetParam());
  for (const int images : {1, 2}) {
    QuiltImageOptions options;
    options.images = images;
    const QuiltPicture lines = quiltFromLines(views, quiltLines(views, scene, options), QuiltDepths::kKept);
    const QuiltPicture mesh = byMeshes(views, scene, images);
    EXPECT_LT(lacking(views, lines, mesh), 0.002) << images;
    EXPECT_LT(lacking(views, mesh, lines), 0.002) << images;
  }
}

// Inside of surfaces without a texture: where a texel is as large as a pixel, which of two samples a pixel shows is
// rounding, and at rims the two end surfaces each in their own way.
TEST(QuiltImages, colorsAreThoseOfTheMesh) {
  const QuiltViews views(kSmall, View{});
  const Mesh scene = sceneFor(views, "builtin:teapot");
  for (const int images : {1, 2}) {
    QuiltImageOptions options;
    options.images = images;
    const QuiltPicture lines = quiltFromLines(views, quiltLines(views, scene, options), QuiltDepths::kKept);
    const QuiltPicture mesh = byMeshes(views, scene, images);
    EXPECT_LT(differingInside(views, lines, mesh, 2), 0.001) << images;
  }
}

TEST_P(QuiltFromLines, missesFarLessThanColorAndDepth) {
  const QuiltViews views(kSmall, View{});
  const Mesh scene = sceneFor(views, GetParam());
  const QuiltPicture eoc = quiltFromLines(views, quiltLines(views, scene), QuiltDepths::kKept);
  const QuiltPicture pair = quiltFromDepthImage(views, middleDepthImage(views, scene), QuiltDepths::kKept);
  const QuiltPicture truth = quiltByRender(views, scene, QuiltDepths::kKept);
  const std::vector<FrameErrors> errors = quiltErrors(views, scene, {&eoc, &pair, &truth});
  EXPECT_EQ(errors[2].strict, 0u);
  EXPECT_EQ(errors[2].meanFlip(), 0);
  EXPECT_GT(errors[1].strict, 0u);
  EXPECT_LT(errors[0].strictRatio(), errors[1].strictRatio() / 3);
  EXPECT_LE(errors[0].thick * 5, errors[1].thick);  // the fence has no thick holes at this size
}

// What the scene does not cover stays black, also beyond the borders of the image: nothing is filled in there. Within a
// pixel of the scene it may differ.
TEST_P(QuiltFromLines, showNothingBesideTheScene) {
  const QuiltViews views(kSmall, View{});
  const Mesh scene = sceneFor(views, GetParam());
  const QuiltPicture truth = quiltByRender(views, scene, QuiltDepths::kKept);
  for (const int images : {1, 2}) {
    QuiltImageOptions options;
    options.images = images;
    const QuiltPicture quilt = quiltFromLines(views, quiltLines(views, scene, options));
    size_t wrong = 0;
    for (int y = 1; y + 1 < quilt.color.height(); ++y) {
      for (int x = 1; x + 1 < quilt.color.width(); ++x) {
        bool isBeside = quilt.color(x, y) != Rgb8(0);
        for (int k = 0; k < 9 && isBeside; ++k) {
          isBeside = truth.inverseZ(x - 1 + k % 3, y - 1 + k / 3) == 0;
        }
        wrong += isBeside ? 1 : 0;
      }
    }
    EXPECT_LT(static_cast<double>(wrong), 0.001 * static_cast<double>(quilt.color.size())) << images;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, QuiltFromLines, testing::Values("builtin:fence,gap=24", "builtin:statues"));

TEST(QuiltImages, raysGiveTheSameQuilt) {
  const QuiltViews views(kSmall, View{});
  const Mesh scene = sceneFor(views, "builtin:teapot");
  const RayScene rays(scene);
  const RayRenderer renderer(scene, rays);
  const QuiltPicture drawn = quiltFromLines(views, quiltLines(views, scene), QuiltDepths::kKept);
  const QuiltPicture cast = quiltFromLines(views, quiltLines(views, scene, {}, &renderer), QuiltDepths::kKept);
  EXPECT_LT(differing(drawn, cast, 2), 0.005);
}

TEST(QuiltImages, theSameBytesWithAnyNumberOfThreads) {
  const QuiltViews views(kSmall, View{});
  const Mesh scene = sceneFor(views, "builtin:fence,gap=24");
  setThreadCount(1);
  const QuiltPicture one = quiltFromLines(views, quiltLines(views, scene));
  setThreadCount(4);
  const QuiltPicture four = quiltFromLines(views, quiltLines(views, scene));
  setThreadCount(0);
  EXPECT_EQ(one.color, four.color);
}

TEST(QuiltImages, moreSamplesGiveTheSameViewsSharper) {
  const QuiltViews views(kSmall, View{});
  const Mesh scene = sceneFor(views, "builtin:teapot");
  const QuiltPicture truth = quiltByRender(views, scene, QuiltDepths::kKept);
  QuiltImageOptions options;
  options.sampling = 2;
  const Mesh wider = sceneFor(views, "builtin:teapot", 2);
  const QuiltPicture plain = quiltFromLines(views, quiltLines(views, scene), QuiltDepths::kKept);
  const QuiltPicture sharp = quiltFromLines(views, quiltLines(views, wider, options), QuiltDepths::kKept);
  EXPECT_LT(differing(sharp, truth, 8), differing(plain, truth, 8));
}

TEST(QuiltImages, anImageOfTheSameViewIsTakenByItsRows) {
  const QuiltDisplay square{"square", 3, 1, 300, 120, 100.0 / 120, 30};
  const QuiltViews views(square, View{});
  const Mesh scene = sceneFor(views, "builtin:teapot");
  const PinholeCamera middle = views.middle(1, 100);
  const ReferenceImage image = buildEocImage(middle, {views.eyeIn(1, 0), views.eyeIn(1, 2)}, scene);
  const std::optional<QuiltLines> lines = quiltLinesOf(views, image);
  ASSERT_TRUE(lines);
  const QuiltPicture byRows = quiltFromLines(views, {*lines}, QuiltDepths::kKept);
  const QuiltPicture byMesh = quiltFromMesh(views, {image}, 1, QuiltDepths::kKept);
  EXPECT_LT(differing(byRows, byMesh, 2), 0.01);
  EXPECT_GT(byRows.filled, 0u);  // the file does not say what is empty

  EXPECT_FALSE(
      quiltLinesOf(views, buildEocImage(PinholeCamera(View{}, 90, 77), {views.eyeIn(1, 0), views.eyeIn(1, 2)}, scene)));
  EXPECT_TRUE(quiltLinesOf(views, buildDepthImage(middle, scene)));
}

TEST(QuiltWays, eachMakesAQuiltOfTheScene) {
  const QuiltViews views(kSmall, View{});
  const Mesh scene = sceneFor(views, "builtin:teapot");
  const QuiltPicture truth = quiltByRender(views, scene, QuiltDepths::kKept);
  const auto seen = static_cast<double>(std::ranges::count_if(truth.inverseZ, [](float w) { return w > 0; }));
  for (const QuiltWay& way : quiltWays()) {
    const QuiltPicture quilt = way.make({views, scene, QuiltImageOptions{}, QuiltDepths::kKept, {}});
    EXPECT_GT(static_cast<double>(std::ranges::count_if(quilt.inverseZ, [](float w) { return w > 0; })), 0.85 * seen)
        << way.name;
  }
  EXPECT_THROW(quiltWayNamed("magic", "--by"), InputError);
}

}  // namespace
}  // namespace ocelli
