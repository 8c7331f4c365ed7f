#include "oc_core/shade/cast_objects.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "oc_core/base/error.h"
#include "tests/shade/small_shaded_scene.h"

namespace ocelli {
namespace {

TEST(CastObjects, areThoseOfTheSceneWhereNoMirrorIsCast) {
  const ShadedScene scene = test::mirrorBeforeBox();
  const CastObjects cast = castObjects(scene, &scene.mirrors[0]);
  EXPECT_EQ(cast.mesh.get(), &scene.cast) << "not a copy";
  EXPECT_TRUE(cast.mirrorNormals.empty());
}

TEST(CastObjects, holdMirrorsButTheSender) {
  ShadedScene scene = test::mirrorBeforeBox();
  for (const float z : {5.0f, 7.0f}) {
    scene.mirrors.push_back(test::specularObject(test::wall(z, 0.5f)));
    scene.mirrors.back().isCast = true;
  }
  const size_t box = scene.cast.positions.size();
  const size_t wall = scene.mirrors[1].mesh.positions.size();
  const CastObjects forFirst = castObjects(scene, &scene.mirrors[0]);
  ASSERT_EQ(forFirst.mesh->positions.size(), box + 2 * wall);
  ASSERT_EQ(forFirst.mirrorNormals.size(), box + 2 * wall);
  EXPECT_FALSE(metMirror(forFirst.mirrorNormals[0])) << "the box does not mirror";
  EXPECT_EQ(metMirror(forFirst.mirrorNormals[box])->mirror, 1u);
  EXPECT_EQ(metMirror(forFirst.mirrorNormals.back())->mirror, 2u);
  EXPECT_NEAR(std::abs(metMirror(forFirst.mirrorNormals.back())->normal.z), 1, 1e-6f);
  const CastObjects forSecond = castObjects(scene, &scene.mirrors[1]);
  ASSERT_EQ(forSecond.mesh->positions.size(), box + wall);
  EXPECT_EQ(metMirror(forSecond.mirrorNormals.back())->mirror, 2u);
}

// Neighbouring samples of a curved mirror have normals at an angle, and what lies between is shorter than they are.
TEST(CastObjects, mirrorsAreToldApartBetweenNormals) {
  for (uint32_t mirror = 0; mirror < kMaxCastMirrors; ++mirror) {
    const glm::vec3 a = glm::normalize(glm::vec3(1, 0, 0)) * std::exp2(static_cast<float>(mirror));
    const glm::vec3 b = glm::normalize(glm::vec3(1, 1, 0)) * std::exp2(static_cast<float>(mirror));
    const auto met = metMirror((a + b) / 2.0f);
    ASSERT_TRUE(met) << mirror;
    EXPECT_EQ(met->mirror, mirror);
    EXPECT_NEAR(glm::length(met->normal), 1, 1e-6f);
  }
  EXPECT_FALSE(metMirror(glm::vec3(0)));
  EXPECT_FALSE(metMirror(glm::vec3(std::numeric_limits<float>::quiet_NaN())));
}

TEST(CastObjects, tooManyMirrorsAreAnError) {
  ShadedScene scene = test::mirrorBeforeBox();
  scene.source = "hall.obj";
  for (size_t i = 0; i < kMaxCastMirrors; ++i) {
    scene.mirrors.push_back(scene.mirrors[0]);
    scene.mirrors.back().isCast = true;
  }
  EXPECT_THAT([&] { castObjects(scene, nullptr); }, testing::ThrowsMessage<InputError>(testing::HasSubstr("hall.obj")));
}

TEST(CastObjects, mirrorsReflectFromBothSides) {
  const glm::vec3 down = glm::normalize(glm::vec3(1, -1, 0));
  const glm::vec3 up = glm::normalize(glm::vec3(1, 1, 0));
  EXPECT_LT(glm::distance(reflectedAt({0, {0, 1, 0}}, down), up), 1e-6f);
  EXPECT_LT(glm::distance(reflectedAt({0, {0, -1, 0}}, down), up), 1e-6f);
}

}  // namespace
}  // namespace ocelli
