#include "oc_core/shade/shaded_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/worlds/builtin_scenes.h"
#include "tests/base/temporary_folder.h"
#include "tests/shade/small_shaded_scene.h"

namespace ocelli {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(ShadedScene, builtinsComeWithTheirRoles) {
  for (const auto& [source, mirrors, lenses] :
       {std::tuple("builtin:mirror", 1u, 0u), std::tuple("builtin:lens", 0u, 1u)}) {
    const ShadedScene scene = loadShadedScene(source, rolesFor(source, ""));
    EXPECT_EQ(scene.mirrors.size(), mirrors);
    EXPECT_EQ(scene.lenses.size(), lenses);
    EXPECT_GT(scene.cast.triangles.size(), 5000u);
    EXPECT_LT(scene.billboards.triangles.size(), 2000u);
    EXPECT_TRUE(scene.surroundings.empty());
    size_t triangles = scene.cast.triangles.size() + scene.billboards.triangles.size();
    for (const std::vector<SpecularObject>* objects : {&scene.mirrors, &scene.lenses}) {
      for (const SpecularObject& object : *objects) {
        triangles += object.mesh.triangles.size();
        EXPECT_EQ(object.normals.size(), object.mesh.positions.size());
      }
    }
    EXPECT_EQ(triangles, loadScene(source).triangles.size()) << "every triangle has one place";
  }
}

TEST(ShadedScene, takesObjectsThatComeToAScene) {
  const ShadedScene scene = loadShadedScene(
      "builtin:teapot",
      {{.object = 0, .roles = kCasts},
       {.roles = kMirrors, .source = "builtin:sphere,segments=16", .center = {0, 0, 2}, .radius = 0.5}});
  const Box ball = boundsOf(scene.mirrors);
  // The poles are vertices, and so are points of the equator.
  EXPECT_LT(glm::distance(ball.center(), {0, 0, 2}), 1e-5f);
  EXPECT_NEAR(ball.size().y, 1, 1e-5f);
}

TEST(ShadedScene, hasTheLightOfItsPanel) {
  const ShadedScene scene = loadShadedScene("builtin:lamp", rolesFor("builtin:lamp", ""));
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_FALSE(scene.lights[0].isDisc);
  EXPECT_GT(scene.lights[0].width, 0.1f);
  EXPECT_NEAR(scene.lights[0].width, scene.lights[0].height, 1e-4f);
  EXPECT_LT(scene.lights[0].direction().y, -0.3f);
  EXPECT_EQ(scene.surroundings.triangles.size(), 2u) << "its panel";
  const size_t others = scene.cast.triangles.size() + scene.billboards.triangles.size();
  ASSERT_EQ(scene.receives.size(), others + 2);
  EXPECT_EQ(std::count(scene.receives.begin(), scene.receives.end(), 1), static_cast<std::ptrdiff_t>(others));
}

TEST(ShadedScene, takesLightsThatComeToAScene) {
  const AreaLight light = areaLightTowards({0, 3, 1}, {0, 0, 0}, 1, 1, true, 0, "test");
  const ShadedScene scene = loadShadedScene(
      "builtin:teapot", {{.object = 0, .roles = kCasts | kReceives}, {.roles = kShines, .light = light}});
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.lights[0].center, light.center);
  EXPECT_TRUE(scene.lights[0].isDisc);
  EXPECT_FALSE(scene.surroundings.empty());
}

TEST(ShadedScene, saysWhatRolesLack) {
  const auto load = [](const std::vector<RoledObject>& roles) { loadShadedScene("builtin:teapot", roles); };
  EXPECT_THAT([&] { load({{.object = 3, .roles = kCasts}}); }, ThrowsMessage<InputError>(HasSubstr("has no object 3")));
  EXPECT_THAT([&] { requireCast(loadShadedScene("builtin:teapot", {{.object = 0, .roles = kMirrors}})); },
              ThrowsMessage<InputError>(HasSubstr("has the role \"cast\"")));
}

TEST(ShadedScene, looksForRolesBesideTheScene) {
  EXPECT_EQ(rolesFileBeside("a/b.obj"), "a/b.roles.json");
  const test::TemporaryFolder folder;
  const std::string scene = folder.write("b.obj", "");
  EXPECT_THAT([&] { rolesFor(scene, ""); }, ThrowsMessage<InputError>(HasSubstr("b.roles.json")));
  EXPECT_THAT([&] { rolesFor("builtin:teapot", ""); }, ThrowsMessage<InputError>(HasSubstr("--roles")));
  const std::string text = R"({"objects": [{"object": 0, "roles": ["cast"]}]})";
  folder.write("b.roles.json", text);
  EXPECT_EQ(rolesFor(scene, "").size(), 1u);
  EXPECT_EQ(rolesFor("builtin:teapot", folder.write("other.json", text)).front().roles, kCasts);
}

TEST(ReferenceView, holdsWhatIsCast) {
  const ShadedScene scene = test::mirrorBeforeBox();
  const PinholeCamera camera(referenceView(scene.cast, boundsOf(scene.mirrors), 90, 60), 90, 60);
  float nearestToBorder = 60;
  for (const glm::vec3& position : scene.cast.positions) {
    const auto q = camera.project(position);
    ASSERT_TRUE(q);
    nearestToBorder = std::min({nearestToBorder, q->u, 90 - q->u, q->v, 60 - q->v});
  }
  EXPECT_GT(nearestToBorder, 0);
  EXPECT_LT(nearestToBorder, 4) << "and little else";
}

TEST(PlaneView, isNoneOfWhatLiesAround) {
  Mesh around = test::wall(1, 1);
  append(around, test::wall(-1, 1));
  const auto viewFrom = [&](const glm::vec3& at) {
    Box senders;
    senders.add(at);
    return planeView(around, senders, 90, 60);
  };
  EXPECT_FALSE(viewFrom({0, 0, 0}));
  EXPECT_FALSE(viewFrom({0, 0, 0.1f}));
  ASSERT_TRUE(viewFrom({0, 0, 3}));
  Box senders;
  senders.add({0, 0, 0.1f});
  const PinholeCamera ahead(aroundView(around, senders), 90, 60);
  EXPECT_TRUE(ahead.project({0, 0, 1})) << "what lies to the front";
}

TEST(ReferenceView, refusesWhatLiesAround) {
  Mesh around = test::wall(1, 1);
  append(around, test::wall(-1, 1));
  const auto view = [&](const glm::vec3& at) {
    Box senders;
    senders.add(at);
    referenceView(around, senders, 90, 60);
  };
  EXPECT_THAT([&] { view({0, 0, 0}); }, ThrowsMessage<InputError>(HasSubstr("stand around")));
  EXPECT_THAT([&] { view({0, 0, 0.1f}); }, ThrowsMessage<InputError>(HasSubstr("no image plane holds them")));
  EXPECT_NO_THROW(view({0, 0, 3}));
}

}  // namespace
}  // namespace ocelli
