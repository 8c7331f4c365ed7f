#include "oc_core/shade/specular_ways.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/shade/scene_proxies.h"
#include "tests/shade/small_shaded_scene.h"

namespace ocelli {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(SpecularWays, areANameAndWords) {
  const SpecularWayName plain = specularWay("eoc-hv+ddoc");
  EXPECT_EQ(plain.target, "eoc-hv+ddoc");
  EXPECT_FALSE(plain.isStepped());
  EXPECT_FALSE(plain.exit);
  const SpecularWayName both = specularWay("spoc:searched-exit:stepped-1/4");
  EXPECT_EQ(both.target, "spoc");
  EXPECT_EQ(both.full, "spoc:searched-exit:stepped-1/4");
  EXPECT_EQ(both.finePixels, 0.25);
  EXPECT_EQ(both.exit, BackFaceExit::kSearched);
  EXPECT_EQ(specularWay("traced:expected-exit").exit, BackFaceExit::kExpected);
  EXPECT_EQ(specularWay("C:ways/x.json:stepped").target, "C:ways/x.json");
}

TEST(SpecularWays, mistakesAreNamed) {
  EXPECT_THAT([] { specularWay("di:stepped:stepped-1/2"); }, ThrowsMessage<InputError>(HasSubstr("how rays walk")));
  EXPECT_THAT([] { specularWay("di:searched-exit:searched-exit"); },
              ThrowsMessage<InputError>(HasSubstr("where rays leave glass")));
  EXPECT_THAT([] { specularWay("environment:stepped"); }, ThrowsMessage<InputError>(HasSubstr("no image")));
  EXPECT_THAT([] { specularWay("traced:stepped"); }, ThrowsMessage<InputError>(HasSubstr("no image")));
  EXPECT_THAT([] { checkProxyName("di:steped"); }, ThrowsMessage<InputError>(HasSubstr("\"di:steped\"")));
  EXPECT_THROW(checkProxyName(":stepped"), InputError);
  EXPECT_THROW(checkProxyName(""), InputError);
}

TEST(SpecularWays, eachWordIsInHelpAndChangesAWay) {
  for (const WayWord& word : wayWords()) {
    EXPECT_THAT(wayWordsHelp(), HasSubstr(word.word));
    const SpecularWayName way = specularWay("di:" + std::string(word.word));
    EXPECT_EQ(way.target, "di");
    EXPECT_TRUE(way.isStepped() || way.exit || way.byFrusta);
  }
}

/// A ray from the mirror to the box.
struct SteppedWay {
  ShadedScene scene = test::mirrorBeforeBox();
  CastObjects cast = castObjects(scene, nullptr);
  Box box = boundsOf(scene.mirrors);
  PinholeCamera reference{referenceView(scene.cast, box, 120, 80), 120, 80};
  Progress none;

  BuiltProxy build(const std::string& way) const {
    return buildProxy(specularWay(way), {scene, cast, box.center(), reference, {.sideRadii = 1}, 32, none});
  }
};

TEST(SpecularWays, stepsMeetWhatThePyramidMeets) {
  const SteppedWay made;
  for (const char* way : {"di:stepped", "spoc:stepped-1/2", "ddoc:stepped-1/4", "eoc-h:stepped-1/4", "cell:stepped"}) {
    const BuiltProxy built = made.build(way);
    EXPECT_EQ(built.name, way);
    RayCost cost;
    const ProxyHit hit = built.proxy->hit({{0.25f, 0.2f, 0}, {0, 0, 1}}, cost);
    EXPECT_TRUE(hit.onCast) << way;
    EXPECT_NEAR(*hit.distance, 1.9f, 5e-3f) << way;
    EXPECT_LT(glm::distance(hit.color, {0.8f, 0.1f, 0.1f}), 0.05f) << way;
    EXPECT_GT(cost.steps(), 0u) << way;
    const ProxyHit beside = built.proxy->hit({{0.45f, 0.2f, 0}, {0, 0, 1}}, cost);
    EXPECT_FALSE(beside.onCast) << way;
    EXPECT_NEAR(*beside.distance, 12, 1e-4f) << way << ": the billboard behind";
  }
}

TEST(SpecularWays, whatIsNoSingleImageHasNoSteps) {
  const SteppedWay made;
  for (const char* way : {"eoc-hv:stepped", "di+spoc:stepped", "corners-4:stepped", "panorama:stepped"}) {
    EXPECT_THAT([&] { made.build(way); }, ThrowsMessage<InputError>(HasSubstr("steps along their projections"))) << way;
  }
}

}  // namespace
}  // namespace ocelli
