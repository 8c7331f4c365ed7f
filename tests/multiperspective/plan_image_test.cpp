#include "oc_core/multiperspective/plan_image.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "oc_core/base/error.h"
#include "tests/base/temporary_folder.h"
#include "tests/camera/test_graph_cameras.h"

namespace ocelli {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

CameraPlan examplePlan() {
  return planOf(test::crossroads(), test::boxBeforeWall(), {.rays = 8, .groundPixels = 60});
}

size_t countOf(const Figure& figure, const std::string& part) {
  const std::vector<Shape>& shapes = figure.drawing.shapes();
  return static_cast<size_t>(
      std::count_if(shapes.begin(), shapes.end(), [&](const Shape& shape) { return shape.part == part; }));
}

TEST(PlanImage, drawsEachPart) {
  const CameraPlan plan = examplePlan();
  const Figure figure = planFigure(plan);
  size_t pieces = 0;
  size_t hits = 0;
  for (const CameraPlan::Ray& ray : plan.rays) {
    pieces += ray.pieces.size();
    hits += ray.meetsSurface ? 1 : 0;
  }
  EXPECT_EQ(countOf(figure, "ray"), pieces);
  EXPECT_EQ(countOf(figure, "hit"), hits);
  EXPECT_EQ(countOf(figure, "ground"), 1U);
  EXPECT_EQ(countOf(figure, "legend"), 2 * plan.parts.size()) << "a square and a name each";
  EXPECT_EQ(countOf(planFigure(plan, {.maxLegendLines = 1}), "legend"), 3U) << "and how many more there are";
}

TEST(PlanImage, textStaysWithinIt) {
  CameraPlan plan = examplePlan();
  plan.parts[1].name = std::string(300, 'w');
  const Figure figure = planFigure(plan, {.title = "A plan", .planPixels = 300});
  for (const Shape& shape : figure.drawing.shapes()) {
    if (std::holds_alternative<TextShape>(shape.what)) {
      EXPECT_TRUE(PlotBox({0, 0, figure.width, figure.height}).contains(boxOf(shape)))
          << std::get<TextShape>(shape.what).text;
    }
  }
}

TEST(PlanImage, svgIsOne) {
  const test::TemporaryFolder folder;
  writePlan(folder / "plan.svg", examplePlan(), {.title = "a <title> & more"});
  const std::string svg = test::fileBytes(folder / "plan.svg");
  EXPECT_THAT(svg, StartsWith("<?xml"));
  EXPECT_THAT(svg, HasSubstr("</svg>"));
}

TEST(PlanImage, pngShowsTheColoursOfTheParts) {
  const test::TemporaryFolder folder;
  CameraPlan plan = examplePlan();
  writePlan(folder / "plan.png", plan, {.planPixels = 300});
  const Image<Rgb8> with = readPng(folder / "plan.png");
  const auto isRed = [](const Rgb8& p) { return p.x > 180 && p.y < 100 && p.z < 60; };
  EXPECT_TRUE(std::any_of(with.begin(), with.end(), isRed)) << "the root";
  plan.parts.clear();
  plan.rays.clear();
  writePlan(folder / "empty.png", plan, {.planPixels = 300});
  const Image<Rgb8> without = readPng(folder / "empty.png");
  EXPECT_FALSE(std::any_of(without.begin(), without.end(), isRed));
}

TEST(PlanImage, namesOfAnyLengthAndScriptFit) {
  const test::TemporaryFolder folder;
  CameraPlan plan = examplePlan();
  plan.parts[1].name = std::string(300, 'w');
  plan.parts[2].name.clear();
  for (int i = 0; i < 100; ++i) {
    plan.parts[2].name += "\u00e4\u8def\u2192";
  }
  for (int i = 0; i < 100; ++i) {
    plan.parts.push_back(plan.parts[2]);
  }
  writePlan(folder / "plan.png", plan);
  EXPECT_GT(readPng(folder / "plan.png").width(), 1000);
}

TEST(PlanImage, refusesOtherFiles) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(writePlan(folder / "plan.pdf", examplePlan()), InputError);
  EXPECT_THROW(writePlan(folder / "large.png", examplePlan(), {.planPixels = 100'000}), WorkError);
  EXPECT_THROW(writePlan(folder / "nowhere" / "plan.svg", examplePlan()), WorkError);
  EXPECT_THROW(writePlan(folder / "nowhere" / "plan.png", examplePlan()), WorkError);
}

}  // namespace
}  // namespace ocelli
