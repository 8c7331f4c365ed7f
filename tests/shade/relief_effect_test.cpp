#include "oc_core/shade/relief_effect.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "oc_core/base/error.h"
#include "tests/shade/small_shaded_scene.h"

namespace ocelli {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

StageInputs parkingInputs() {
  const char* const source = "builtin:parking,tiles=4";
  return {.scene = std::make_shared<const ShadedScene>(loadShadedScene(source, rolesFor(source, ""))),
          .referenceSize = {128, 128}};
}

std::map<std::string, std::optional<double>> figuresOf(const ShadedWay& way) {
  const Effect effect = reliefEffect();
  std::map<std::string, std::optional<double>> figures;
  for (size_t i = 0; i < effect.columns.size(); ++i) {
    figures[effect.columns[i].field] = way.figures.at(i);
  }
  return figures;
}

TEST(ReliefEffect, measuresWaysAgainstTheTracedPicture) {
  const StageInputs inputs = parkingInputs();
  const Effect effect = reliefEffect();
  effect.requireObjects(*inputs.scene);
  const PinholeCamera camera(effect.defaultView(*inputs.scene), 150, 100);
  const auto stage = effect.stage(inputs);
  stage->checkView(camera);
  const ShadedWay traced = stage->measure(kTraced, camera, 1);
  const ShadedWay field = stage->measure("height-field", camera, 1);
  const ShadedWay cell = stage->measure("cell", camera, 1);
  EXPECT_EQ(traced.figures.size(), effect.columns.size());
  EXPECT_FALSE(figuresOf(traced)["wrong"]);
  EXPECT_EQ(traced.maps.size(), 1u);
  EXPECT_EQ(cell.maps.size(), 2u);
  // The box fits the picture, so that cars take much of it.
  EXPECT_GT(*figuresOf(traced)["tile_pixels"], 150 * 100 / 6);
  EXPECT_LT(*figuresOf(cell)["wrong"], *figuresOf(field)["wrong"] / 2);
  EXPECT_LT(*figuresOf(cell)["false_surface"], *figuresOf(field)["false_surface"] / 5);
  EXPECT_GT(*figuresOf(cell)["psnr_db"], *figuresOf(field)["psnr_db"]);
  EXPECT_LE(*figuresOf(cell)["texels"], 1.2 * 128 * 128);
  for (const ShadeFact& fact : stage->facts(camera)) {
    EXPECT_TRUE(nlohmann::json::accept(fact.json)) << fact.field;
    EXPECT_TRUE(fact.field != "tiles" || fact.json == "4");
  }
}

TEST(ReliefEffect, waysDrawWhatIsMeasuredAndOutliveTheirStage) {
  const StageInputs inputs = parkingInputs();
  const Effect effect = reliefEffect();
  const PinholeCamera camera(effect.defaultView(*inputs.scene), 75, 50);
  auto stage = effect.stage(inputs);
  for (const char* name : {"traced", "height-field", "spoc"}) {
    const std::unique_ptr<EffectWay> way = stage->build(name);
    const ShadedWay measured = stage->measure(name, camera, 1);
    const Image<glm::vec3> drawn = way->draw(camera);
    EXPECT_TRUE(std::equal(drawn.begin(), drawn.end(), measured.picture.begin())) << name;
  }
  const std::unique_ptr<EffectWay> traced = stage->build(kTraced);
  const Image<glm::vec3> before = traced->draw(camera);
  stage.reset();
  const Image<glm::vec3> after = traced->draw(camera);
  EXPECT_TRUE(std::equal(before.begin(), before.end(), after.begin()));
}

TEST(ReliefEffect, saysWhatItLacks) {
  const Effect effect = reliefEffect();
  EXPECT_THAT([&] { effect.requireObjects(test::mirrorBeforeBox()); },
              ThrowsMessage<InputError>(HasSubstr("has the role \"relief\"")));
  EXPECT_THAT([&] { effect.checkWay("environment"); }, ThrowsMessage<InputError>(HasSubstr("for relief tiles")));
  const auto stage = effect.stage(parkingInputs());
  View away;
  away.target = {0, 0, 20};
  EXPECT_THAT([&] { stage->checkView(PinholeCamera(away, 30, 20)); },
              ThrowsMessage<InputError>(HasSubstr("shows no relief tile")));
}

}  // namespace
}  // namespace ocelli
