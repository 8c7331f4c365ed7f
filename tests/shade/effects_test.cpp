#include "oc_core/shade/effects.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "oc_core/base/error.h"
#include "tests/shade/small_shaded_scene.h"

namespace ocelli {
namespace {

using test::smallCamera;
using testing::HasSubstr;
using testing::ThrowsMessage;

StageInputs smallInputs() {
  return {.scene = std::make_shared<const ShadedScene>(test::mirrorBeforeBox()),
          .referenceSize = {60, 40},
          .environmentHeight = 64};
}

TEST(Effects, areToldApart) {
  std::set<std::string> names;
  for (const Effect& effect : shadeEffects()) {
    EXPECT_TRUE(names.insert(effect.name).second) << effect.name;
    std::set<std::string> fields;
    for (const FigureColumn& column : effect.columns) {
      EXPECT_TRUE(fields.insert(column.field).second) << effect.name << ": " << column.field;
    }
    EXPECT_NO_THROW(effect.checkWay(kTraced)) << effect.name;
    EXPECT_THROW(effect.checkWay("no such way"), InputError) << effect.name;
  }
  EXPECT_THAT([] { shadeEffect("refelction"); }, ThrowsMessage<InputError>(HasSubstr("reflection, refraction")));
}

TEST(Effects, sayWhatTheyLack) {
  const StageInputs inputs = smallInputs();
  EXPECT_NO_THROW(shadeEffect("reflection").requireObjects(*inputs.scene));
  EXPECT_THAT([&] { shadeEffect("refraction").requireObjects(*inputs.scene); },
              ThrowsMessage<InputError>(HasSubstr("has the role \"refract\"")));
  const auto stage = shadeEffect("reflection").stage(inputs);
  View away;
  away.target = {0, 0, 20};
  EXPECT_THAT([&] { stage->checkView(PinholeCamera(away, 90, 60)); },
              ThrowsMessage<InputError>(HasSubstr("shows nothing of what mirrors")));
  EXPECT_NO_THROW(stage->checkView(smallCamera()));
}

// A way that has been built stands for itself, whatever becomes of its stage, and draws what is measured.
TEST(Effects, waysDrawWhatIsMeasured) {
  auto stage = shadeEffect("reflection").stage(smallInputs());
  for (const char* name : {"traced", "environment", "di"}) {
    const std::unique_ptr<EffectWay> way = stage->build(name);
    const ShadedWay measured = stage->measure(name, smallCamera(), 1);
    EXPECT_EQ(measured.name, name);
    EXPECT_EQ(measured.figures.size(), shadeEffect("reflection").columns.size());
    const Image<glm::vec3> drawn = way->draw(smallCamera());
    ASSERT_EQ(drawn.size(), measured.picture.size());
    EXPECT_TRUE(std::equal(drawn.data(), drawn.data() + drawn.size(), measured.picture.data())) << name;
  }
  const std::unique_ptr<EffectWay> way = stage->build("di");
  const Image<glm::vec3> before = way->draw(smallCamera());
  stage.reset();
  const Image<glm::vec3> after = way->draw(smallCamera());
  EXPECT_TRUE(std::equal(before.data(), before.data() + before.size(), after.data()));
}

/// Every ray hits a white point at distance 1, after three steps.
class FaultyCaster final : public DepthRayCaster {
 public:
  std::unique_ptr<Target> prepare(const DepthImageTarget& /*target*/) const override {
    return std::make_unique<FaultyTarget>();
  }
  std::string description() const override { return "a \"faulty\" caster"; }

 private:
  class FaultyTarget final : public Target {
   public:
    void hits(std::span<const RayPath> rays, std::span<std::optional<Hit>> found,
              std::span<RayCost> costs) const override {
      for (size_t i = 0; i < rays.size(); ++i) {
        costs[i] = {1, 2, 16, 4};
        found[i] = Hit{1, rays[i].front(), glm::vec3(1)};
      }
    }
  };
};

size_t columnOf(const Effect& effect, const std::string& field) {
  const auto at = std::find_if(effect.columns.begin(), effect.columns.end(),
                               [&](const FigureColumn& column) { return column.field == field; });
  return static_cast<size_t>(at - effect.columns.begin());
}

// A device casts the rays of ways with depth images, and what it casts otherwise is counted.
TEST(Effects, whatADeviceCastsOtherwiseIsCounted) {
  const Effect& effect = shadeEffect("reflection");
  EXPECT_TRUE(effect.castsOnDevice("di"));
  EXPECT_FALSE(effect.castsOnDevice(kTraced) || effect.castsOnDevice("environment"));
  const size_t differing = columnOf(effect, "gl_differing");
  const size_t steps = columnOf(effect, "steps_per_ray");
  ASSERT_LT(differing, effect.columns.size());
  StageInputs inputs = smallInputs();
  EXPECT_FALSE(effect.stage(inputs)->measure("di", smallCamera(), 1).figures[differing]);
  inputs.caster = std::make_shared<FaultyCaster>();
  const auto stage = effect.stage(inputs);
  EXPECT_FALSE(stage->measure(kTraced, smallCamera(), 1).figures[differing]);
  const ShadedWay way = stage->measure("di", smallCamera(), 2);
  // The box stands at 1.9 and the wall at 12.
  EXPECT_EQ(way.figures[differing], 1);
  EXPECT_EQ(way.figures[steps], 3);
  bool isTold = false;
  for (const ShadeFact& fact : stage->facts(smallCamera())) {
    isTold |= fact.field == "gl" && nlohmann::json::parse(fact.json) == "a \"faulty\" caster";
  }
  EXPECT_TRUE(isTold);
}

TEST(Effects, optionsTakeTheirInitialValuesAndNoOthers) {
  for (const Effect& effect : shadeEffects()) {
    for (const EffectOption& option : effect.options) {
      EXPECT_NO_THROW(option.check(option.initial)) << effect.name << ": " << option.name;
      EXPECT_THROW(option.check("no such value"), InputError) << effect.name << ": " << option.name;
      EXPECT_THROW(option.check(""), InputError) << effect.name << ": " << option.name;
    }
  }
}

std::string factOf(EffectStage& stage, const std::string& field) {
  for (const ShadeFact& fact : stage.facts(smallCamera())) {
    if (fact.field == field) {
      return fact.json;
    }
  }
  return "";
}

// Where the picture is known, images are made for its rays, for a way that is drawn as for one that is measured.
TEST(Effects, imagesAreMadeForTheRaysOfAPictureThatIsKnown) {
  StageInputs inputs = smallInputs();
  const auto middle = shadeEffect("reflection").stage(inputs);
  inputs.picture = smallCamera();
  const auto rays = shadeEffect("reflection").stage(inputs);
  EXPECT_EQ(factOf(*middle, "reference"), "\"middle\"");
  EXPECT_EQ(factOf(*rays, "reference"), "\"rays\"");
  EXPECT_NE(factOf(*middle, "reference_views"), factOf(*rays, "reference_views"));
  const Image<glm::vec3> drawn = rays->build("di")->draw(smallCamera());
  const ShadedWay measured = rays->measure("di", smallCamera(), 1);
  EXPECT_TRUE(std::equal(drawn.data(), drawn.data() + drawn.size(), measured.picture.data()));
  inputs.options["reference"] = "middle";
  EXPECT_EQ(factOf(*shadeEffect("reflection").stage(inputs), "reference_views"), factOf(*middle, "reference_views"));
}

TEST(Effects, wordsOfGlassAreNotOfMirrors) {
  EXPECT_NO_THROW(shadeEffect("refraction").checkWay("traced:searched-exit"));
  EXPECT_THAT([] { shadeEffect("reflection").checkWay("di:searched-exit"); },
              ThrowsMessage<InputError>(HasSubstr("do not pass a mirror")));
  EXPECT_NO_THROW(shadeEffect("reflection").checkWay("di:stepped-1/2"));
}

TEST(Effects, measureOneViewAfterAnother) {
  const auto stage = shadeEffect("reflection").stage(smallInputs());
  const size_t rays = 0;
  const ShadedWay first = stage->measure("di", smallCamera(), 1);
  View nearer = smallCamera().view();
  nearer.eye.z -= 2;
  const ShadedWay second = stage->measure("di", PinholeCamera(nearer, 60, 40), 1);
  const ShadedWay again = stage->measure("di", smallCamera(), 1);
  EXPECT_NE(first.figures[rays], second.figures[rays]);
  EXPECT_EQ(first.figures[rays], again.figures[rays]);
  for (const ShadeFact& fact : stage->facts(smallCamera())) {
    EXPECT_TRUE(nlohmann::json::accept(fact.json)) << fact.field;
    if (fact.field == "rays") {
      EXPECT_EQ(fact.json, std::to_string(static_cast<size_t>(*first.figures[rays])));
    }
  }
}

}  // namespace
}  // namespace ocelli
