#include "oc_core/shade/shadow_effect.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "oc_core/base/error.h"
#include "oc_core/shade/shadow_figures.h"
#include "oc_core/shade/shadow_ways.h"
#include "oc_core/worlds/solids.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

/// A light over a box that casts, over a floor of billboards that receives.
ShadedScene boxUnderLight(float side = 0.6f) {
  ShadedScene scene;
  scene.source = "test";
  Mesh box = makeBox(glm::vec3(0.2f));
  paint(box, {0.8f, 0.1f, 0.1f});
  append(scene.cast, box, glm::translate(glm::mat4(1), {0, 0.1f, 0}));
  Mesh floor;
  floor.positions = {{-1, -0.4f, 1}, {1, -0.4f, 1}, {1, -0.4f, -1}, {-1, -0.4f, -1}};
  floor.triangles = {{0, 1, 2}, {0, 2, 3}};
  paint(floor, glm::vec3(0.7f));
  append(scene.billboards, floor);
  scene.receives.assign(scene.cast.triangles.size(), 0);
  scene.receives.insert(scene.receives.end(), 2, 1);
  scene.lights.push_back(areaLightTowards({0.1f, 1.4f, 0.1f}, {0, -0.4f, 0}, side, side, false, 0, "test"));
  return scene;
}

StageInputs shadowInputs(ShadedScene scene = boxUnderLight()) {
  return {.scene = std::make_shared<const ShadedScene>(std::move(scene)), .referenceSize = {90, 60}};
}

PinholeCamera defaultCamera(const StageInputs& inputs) {
  return {shadowEffect().defaultView(*inputs.scene), 60, 40};
}

size_t columnOf(const char* field) {
  const std::vector<FigureColumn> columns = shadowColumns();
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&](const FigureColumn& column) { return std::string(column.field) == field; });
  return static_cast<size_t>(found - columns.begin());
}

TEST(ShadowEffect, takesItsWaysAlone) {
  for (const char* way : {"traced", "traced-16", "outlines", "pcss", "backprojection", "di", "cell", "eoc-h"}) {
    EXPECT_NO_THROW(checkShadowName(way)) << way;
  }
  EXPECT_THAT([] { checkShadowName("pccs"); }, ThrowsMessage<InputError>(HasSubstr("backprojection")));
  for (const char* way : {"traced-0", "traced-", "traced-7x", "traced-5000", "environment"}) {
    EXPECT_THROW(checkShadowName(way), InputError) << way;
  }
}

TEST(ShadowEffect, saysWhatAShadowNeeds) {
  const Effect effect = shadowEffect();
  EXPECT_NO_THROW(effect.requireObjects(boxUnderLight()));
  ShadedScene scene = boxUnderLight();
  scene.lights.clear();
  EXPECT_THAT([&] { effect.requireObjects(scene); }, ThrowsMessage<InputError>(HasSubstr("has no light")));
  scene = boxUnderLight();
  scene.lights.push_back(scene.lights.front());
  EXPECT_THAT([&] { effect.requireObjects(scene); }, ThrowsMessage<InputError>(HasSubstr("more than one light")));
  scene = boxUnderLight();
  scene.receives.assign(scene.receives.size(), 0);
  EXPECT_THAT([&] { effect.requireObjects(scene); }, ThrowsMessage<InputError>(HasSubstr("\"receive\"")));
  scene = boxUnderLight();
  scene.cast = {};
  EXPECT_THAT([&] { effect.requireObjects(scene); }, ThrowsMessage<InputError>(HasSubstr("\"cast\"")));

  const StageInputs inputs = shadowInputs();
  const auto stage = effect.stage(inputs);
  EXPECT_NO_THROW(stage->checkView(defaultCamera(inputs)));
  View away;
  away.target = {0, 0, 20};
  EXPECT_THAT([&] { stage->checkView(PinholeCamera(away, 60, 40)); },
              ThrowsMessage<InputError>(HasSubstr("receives light")));
}

TEST(ShadowEffect, measuresEveryWay) {
  const StageInputs inputs = shadowInputs();
  const auto stage = shadowEffect().stage(inputs);
  const PinholeCamera camera = defaultCamera(inputs);
  const size_t rmse = columnOf("rmse");
  const ShadedWay traced = stage->measure("traced", camera, 1);
  EXPECT_EQ(*traced.figures[rmse], 0);
  EXPECT_TRUE(traced.maps.empty());
  EXPECT_GT(*traced.figures[columnOf("in_penumbra")], 100);
  // What each has reason to be off by: 16 rays in strata up to 0.06 in the penumbra; 1,024 samples of the light and of
  // the truth some 0.004; texels and samples of 1 / 60 of the view up to 0.1 in the penumbra, a third of the receivers.
  const std::vector<std::pair<const char*, double>> expected{
      {"traced-16", 0.05}, {"outlines", 0.005}, {"pcss", 0.06}, {"backprojection", 0.05}, {"di", 0.05}, {"cell", 0.05}};
  for (const auto& [name, most] : expected) {
    const ShadedWay way = stage->measure(name, camera, 1);
    EXPECT_EQ(way.name, name);
    EXPECT_EQ(way.figures.size(), shadowColumns().size());
    EXPECT_LT(*way.figures[rmse], most) << name;
    EXPECT_GT(*way.figures[rmse], 0) << name;
    ASSERT_EQ(way.maps.size(), 1u) << name;
    // A way that was built draws what is measured, after its stage, too.
    const Image<glm::vec3> drawn = stage->build(name)->draw(camera);
    EXPECT_TRUE(std::equal(drawn.begin(), drawn.end(), way.picture.begin())) << name;
  }
  for (const ShadeFact& fact : stage->facts(camera)) {
    EXPECT_TRUE(nlohmann::json::accept(fact.json)) << fact.field;
  }
}

// A point of light throws hard shadows: nothing sees it in part.
TEST(ShadowEffect, ofAPointIsHard) {
  const StageInputs inputs = shadowInputs(boxUnderLight(0));
  const auto stage = shadowEffect().stage(inputs);
  const ShadedWay way = stage->measure("outlines", defaultCamera(inputs), 1);
  // A light of 2e-5 units is one edge's width for one pixel in thousands.
  EXPECT_LE(*way.figures[columnOf("in_penumbra")], 2);
  EXPECT_LT(*way.figures[columnOf("rmse")], 0.02);
}

// Reference images of one pixel still give a picture.
TEST(ShadowEffect, takesImagesOfOnePixel) {
  StageInputs inputs = shadowInputs();
  inputs.referenceSize = {1, 1};
  const auto stage = shadowEffect().stage(inputs);
  for (const char* name : {"pcss", "backprojection", "di"}) {
    const ShadedWay way = stage->measure(name, defaultCamera(inputs), 1);
    EXPECT_LE(*way.figures[columnOf("rmse")], 1) << name;
  }
}

TEST(ShadowFigures, areThoseOfWhatIsMeasured) {
  ShadowPixels pixels{Image<glm::vec3>(2, 2), {}, {}};
  pixels.pixels = {{0, true, {}, 1}, {1, true, {}, 1}, {2, false, {}, 1}, {3, true, {}, 1}};
  pixels.receivers.resize(4);
  pixels.receivers[1].isSampled = true;
  const std::vector<float> truth{1, 0.5f, 0.5f, 0};
  LightVisibility found;
  found.share = {1, 0.75f, 0, 0.05f};
  found.estimatedError = {0, 0.3f, 1, 0};
  const ShadowFigures figures = shadowFigures(pixels, truth, found);
  EXPECT_EQ(figures.receivers, 3u);
  EXPECT_EQ(figures.inPenumbra, 1u);
  EXPECT_NEAR(figures.rmse, std::sqrt((0.0625 + 0.0025) / 3), 1e-6);
  EXPECT_NEAR(figures.penumbraRmse, 0.25, 1e-6);
  EXPECT_EQ(figures.onOthers, 2u);
  EXPECT_NEAR(figures.onOthersRmse, std::sqrt(0.0025 / 2), 1e-6);
  EXPECT_NEAR(figures.wrong, 1.0 / 3, 1e-6);
  EXPECT_NEAR(figures.signedMean, 0.1, 1e-6);
  EXPECT_NEAR(*figures.estimate, std::sqrt(0.09 / 3), 1e-6);
  const Image<Rgb8> map = shadowErrorImage(pixels, truth, found.share, 0.2);
  EXPECT_EQ(map(0, 0), Rgb8(255));
  EXPECT_EQ(map(1, 0), kTooLightColor);
  EXPECT_EQ(map(0, 1), Rgb8(190));
}

}  // namespace
}  // namespace ocelli
