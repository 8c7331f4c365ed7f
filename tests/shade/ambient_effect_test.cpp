#include "oc_core/shade/ambient_effect.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "oc_core/base/error.h"
#include "oc_core/shade/ambient_ways.h"
#include "oc_core/shade/effects.h"
#include "tests/base/temporary_folder.h"
#include "tests/shade/small_shaded_scene.h"

namespace ocelli {
namespace {

using test::smallCamera;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// The box (triangles from 2 on) before the wall.
std::shared_ptr<const ShadedScene> boxBeforeWall(uint32_t wallRoles = 0, uint32_t boxRoles = 0) {
  ShadedScene scene;
  scene.source = "box before wall";
  scene.whole.mesh = test::boxBeforeWall();
  for (size_t i = 0; i < scene.whole.mesh.triangles.size(); ++i) {
    scene.whole.objectOfTriangle.push_back(i < 2 ? 0 : 1);
    scene.rolesOfTriangle.push_back(i < 2 ? wallRoles : boxRoles);
  }
  return std::make_shared<const ShadedScene>(scene);
}

size_t figure(const char* field) {
  const std::vector<FigureColumn>& columns = shadeEffect("ambient").columns;
  return static_cast<size_t>(
      std::find_if(columns.begin(), columns.end(),
                   [&](const FigureColumn& column) { return column.field == std::string(field); }) -
      columns.begin());
}

PinholeCamera fromAside() {
  View view;
  view.eye = {3, 2, 9};
  return {view, 90, 60};
}

TEST(AmbientEffect, measuresAllItsWays) {
  const auto stage = shadeEffect("ambient").stage({.scene = boxBeforeWall(), .options = {{"radius", "0.9"}}});
  for (const char* name : {"traced", "traced-16", "horizon", "horizon-wide", "graph", "graph-rays", "di", "cell",
                           "occluder", "occluder:horizon"}) {
    EXPECT_NO_THROW(checkAmbientWay(name)) << name;
    const bool hasObject = std::string(name).find("occluder") == std::string::npos;
    if (!hasObject) {
      continue;  // it takes object 1, whose name a file gives
    }
    const ShadedWay way = stage->measure(name, fromAside(), 1);
    ASSERT_EQ(way.figures.size(), shadeEffect("ambient").columns.size()) << name;
    EXPECT_LT(*way.figures[figure("rmse")], 0.12) << name;
    EXPECT_EQ(way.maps.size(), std::string(name) == "traced" ? 0u : 1u);
    EXPECT_GT(*way.figures[figure("points")], 1000);
  }
  EXPECT_EQ(*stage->measure("traced", fromAside(), 2).figures[figure("rmse")], 0);
  // The rays of two numbers differ by noise alone.
  EXPECT_LT(*stage->measure("traced-1024", fromAside(), 1).figures[figure("rmse")], 0.01);
  for (const ShadeFact& fact : stage->facts(fromAside())) {
    EXPECT_TRUE(nlohmann::json::accept(fact.json)) << fact.field << " " << fact.json;
  }
}

TEST(AmbientEffect, takesGraphCamerasFromFiles) {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("around.json", R"({"camera": "occluder", "object": 1})");
  const auto stage = shadeEffect("ambient").stage({.scene = boxBeforeWall(), .options = {{"radius", "0.9"}}});
  View view;
  view.eye = {0, 1.5f, 9};
  const PinholeCamera camera(view, 90, 60);
  for (const std::string& name : {file, file + ":horizon"}) {
    EXPECT_NO_THROW(checkAmbientWay(name));
    const ShadedWay way = stage->measure(name, camera, 1);
    EXPECT_LT(*way.figures[figure("rmse")], 0.15) << name;
  }
  const std::string curved = folder.write("curved.json", R"({"camera": "curved", "turns": []})");
  EXPECT_THROW(stage->measure(curved + ":horizon", camera, 1), InputError);
}

// A way that has been built stands for itself, and draws what is measured.
TEST(AmbientEffect, waysDrawWhatIsMeasured) {
  auto stage = shadeEffect("ambient").stage({.scene = boxBeforeWall()});
  for (const char* name : {"traced", "horizon", "graph", "di"}) {
    const std::unique_ptr<EffectWay> way = stage->build(name);
    const Image<glm::vec3> measured = stage->measure(name, fromAside(), 1).picture;
    const Image<glm::vec3> drawn = way->draw(fromAside());
    ASSERT_EQ(drawn.size(), measured.size());
    EXPECT_TRUE(std::equal(drawn.data(), drawn.data() + drawn.size(), measured.data())) << name;
  }
}

TEST(AmbientEffect, measuresOnWhatReceives) {
  const auto points = [](const std::shared_ptr<const ShadedScene>& scene) {
    return *shadeEffect("ambient")
                .stage({.scene = scene})
                ->measure("horizon", fromAside(), 1)
                .figures[figure("points")];
  };
  const double all = points(boxBeforeWall());
  const double onWall = points(boxBeforeWall(kReceives, kCasts));
  const double onBox = points(boxBeforeWall(kCasts, kReceives));
  EXPECT_GT(onBox, 50);
  EXPECT_EQ(all, onWall + onBox);
}

TEST(AmbientEffect, hidesNothingWithinNoRadius) {
  const auto stage = shadeEffect("ambient").stage({.scene = boxBeforeWall(), .options = {{"radius", "0"}}});
  for (const char* name : {"traced", "horizon", "graph", "di"}) {
    const ShadedWay way = stage->measure(name, fromAside(), 1);
    EXPECT_NEAR(*way.figures[figure("mean_light")], 1, 1e-9) << name;
    EXPECT_FALSE(way.figures[figure("unseen_rmse")]) << "nothing is hidden by what is not seen";
  }
}

TEST(AmbientEffect, saysWhatItCannotDo) {
  const Effect& effect = shadeEffect("ambient");
  EXPECT_FALSE(effect.needsRoles);
  EXPECT_THROW(effect.requireObjects(ShadedScene{}), InputError);
  for (const char* name : {"traced-0", "traced-many", "traced-9999", "cell:horizon", "geometry", "nothing.json"}) {
    EXPECT_THROW(checkAmbientWay(name), Error) << name;
  }
  const auto stage = effect.stage({.scene = boxBeforeWall()});
  View away;
  away.target = {0, 0, 20};
  EXPECT_THAT([&] { stage->checkView(PinholeCamera(away, 90, 60)); },
              ThrowsMessage<InputError>(HasSubstr("nothing on which light is measured")));
  EXPECT_NO_THROW(stage->checkView(fromAside()));
  View down;
  down.eye = {0, 10, 0};
  down.up = {0, 0, -1};
  EXPECT_THAT([&] { stage->measure("graph", PinholeCamera(down, 90, 60), 1); },
              ThrowsMessage<InputError>(HasSubstr("straight up or down")));
  EXPECT_NO_THROW(stage->measure("horizon", PinholeCamera(down, 90, 60), 1));
}

TEST(AmbientEffect, checksItsOptions) {
  for (const EffectOption& option : shadeEffect("ambient").options) {
    EXPECT_NO_THROW(option.check(option.initial)) << option.name;
    EXPECT_NO_THROW(option.check("0.5")) << option.name;
    for (const char* text : {"", "x", "1x", "-2", "nan", "1e9"}) {
      EXPECT_THAT([&] { option.check(text); }, ThrowsMessage<InputError>(HasSubstr(std::string("--") + option.name)))
          << option.name << " " << text;
    }
  }
}

}  // namespace
}  // namespace ocelli
