#include "display_sim/viewer/scene_lines.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "display_sim/viewer/viewer_colors.h"

namespace ocelli {
namespace {

struct Built {
  ViewerState state;
  Mesh mesh;
  Box bounds;
  BuiltCamera camera;
  std::vector<RayFunction> rays;
};

Built build(const std::string& name) {
  const CameraChoice choice = cameraChoice(name);
  const PinholeCamera reference(View{}, 240, 160);
  Built built{viewerState("builtin:boxes", {}, choice, View{}, 240, 160, "test"),
              loadScene("builtin:boxes"),
              {},
              {choice, reference, {}, {}},
              {}};
  built.bounds = boundsOf(built.mesh);
  built.camera.representation = buildRepresentation(choice, reference, built.mesh);
  built.rays = cameraRays(choice, reference, built.mesh, built.camera.representation.images);
  return built;
}

size_t countColored(const std::vector<ColoredLine>& lines, GuiColor color) {
  return static_cast<size_t>(std::count_if(
      lines.begin(), lines.end(), [&](const ColoredLine& line) { return glm::vec3(line.color) == rgb(color); }));
}

TEST(SceneLines, aPinholeHasStraightRaysOnly) {
  const Built built = build("di");
  const RayGrid grid = rayGrid(built.camera, built.rays, built.bounds, 12, 8);
  EXPECT_TRUE(grid.bent.empty());
  EXPECT_GT(grid.straight.size(), 10U);
  for (const SampledRay& sampled : grid.straight) {
    const std::vector<glm::vec3>& ray = sampled.toSample;
    EXPECT_LT(glm::distance(ray.front(), glm::vec3(0, 0, 10)), 0.02f);  // zNear is 0.01
    EXPECT_LT(glm::length(ray.back()), 1.01f);                          // ends in the scene
  }
}

TEST(SceneLines, occlusionCamerasBendSome) {
  for (const char* name : {"ddoc", "eoc-h"}) {
    const Built built = build(name);
    const RayGrid grid = rayGrid(built.camera, built.rays, built.bounds, 24, 16);
    EXPECT_GT(grid.bent.size(), 3U) << name;
    for (const SampledRay& ray : grid.bent) {
      std::vector<glm::vec3> whole = ray.toSample;
      whole.insert(whole.end(), ray.beyond.begin(), ray.beyond.end());
      EXPECT_TRUE(isBent(whole, 1e-3f)) << name;
    }
  }
}

TEST(SceneLines, manyBentRaysAreNotMadeMore) {
  const Built built = build("spoc");  // bends most
  const RayGrid grid = rayGrid(built.camera, built.rays, built.bounds, 24, 16);
  EXPECT_GE(grid.bent.size(), kFewBent);
  EXPECT_LE(grid.bent.size() + grid.straight.size(), 24U * 16U);
}

TEST(SceneLines, aSampledRayEndsAtItsSample) {
  const Built built = build("ddoc");
  const ReferenceImage& image = built.camera.representation.images[0];
  size_t checked = 0;
  for (int x = 0; x < image.width(); x += 7) {
    const int y = image.height() / 2;
    const SampledRay ray = sampledRay(built.camera, built.rays, built.bounds, {0, {x, y}});
    EXPECT_EQ(ray.toSample.empty(), !image.holds(x, y));
    if (!ray.toSample.empty()) {
      EXPECT_NEAR(built.camera.reference.cameraFromWorld(ray.toSample.back()).z, image.t(x, y), 1e-3f);
      ++checked;
    }
  }
  EXPECT_GT(checked, 5U);
  EXPECT_TRUE(
      sampledRay(built.camera, built.rays, built.bounds, {7, {0, 0}}).beyond.empty());  // there is no such image
}

TEST(SceneLines, whatIsSwitchedOffIsNotDrawn) {
  Built built = build("ddoc");
  const RayGrid grid = rayGrid(built.camera, built.rays, built.bounds, 24, 16);
  const auto linesNow = [&] { return sceneLines(built.state, built.camera, grid, built.bounds, 1).lines; };
  EXPECT_EQ(countColored(linesNow(), kCellColor), 12U);
  EXPECT_GT(countColored(linesNow(), kBentRayColor), 0U);
  EXPECT_GT(countColored(linesNow(), kEyeColor), 0U);
  built.state.scene.cell = false;
  built.state.scene.rays = false;
  built.state.scene.frustum = false;
  EXPECT_EQ(countColored(linesNow(), kCellColor), 0U);
  EXPECT_EQ(countColored(linesNow(), kBentRayColor), 0U);
  EXPECT_EQ(countColored(linesNow(), kReferenceColor), 0U);
  EXPECT_EQ(countColored(linesNow(), kEyeColor), linesNow().size());
}

TEST(SceneLines, theCellHasItsSize) {
  const Built built = build("ddoc");
  for (const ColoredLine& line : sceneLines(built.state, built.camera, {}, built.bounds, 1).lines) {
    if (glm::vec3(line.color) == rgb(kCellColor)) {
      EXPECT_NEAR(glm::distance(line.from, line.to), 1.6f, 1e-5f);
    }
  }
}

TEST(SceneLines, aSegmentCameraShowsItsSegment) {
  const Built built = build("eoc-h");
  const auto lines = sceneLines(built.state, built.camera, {}, built.bounds, 1).lines;
  ASSERT_EQ(countColored(lines, kCellColor), 1U);
  for (const ColoredLine& line : lines) {
    if (glm::vec3(line.color) == rgb(kCellColor)) {
      EXPECT_LT(glm::distance(line.from, glm::vec3(-0.8f, 0, 10)), 1e-5f);
      EXPECT_LT(glm::distance(line.to, glm::vec3(0.8f, 0, 10)), 1e-5f);
    }
  }
}

TEST(ColoredLine, aBoxHasTwelveEdges) {
  std::vector<glm::vec3> corners;
  for (unsigned i = 0; i < 8; ++i) {
    corners.emplace_back(i & 1, i >> 1 & 1, i >> 2);
  }
  std::vector<ColoredLine> lines;
  addBoxEdges(lines, corners, glm::vec4(1), 1);
  EXPECT_EQ(lines.size(), 12U);
  for (const ColoredLine& line : lines) {
    EXPECT_EQ(glm::distance(line.from, line.to), 1);
  }
}

}  // namespace
}  // namespace ocelli
