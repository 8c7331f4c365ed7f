#include "oc_core/shade/shade_comparison.h"

#include <gtest/gtest.h>

#include "oc_core/evaluation/error_image.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::smallCamera;

/// What rays meet, from the eye of the small camera along its view direction.
struct Rays {
  SecondaryRays rays{Image<glm::vec3>(8, 1), {}};
  ShadedPicture truth;
  ShadedPicture picture;

  void add(const ProxyHit& traced, const ProxyHit& seen) {
    const auto pixel = static_cast<uint32_t>(rays.rays.size());
    rays.rays.push_back({{0, 0, 10}, {0, 0, -1}, pixel});
    truth.hits.push_back(traced);
    picture.hits.push_back(seen);
    picture.stepsOfRay.push_back(pixel);
  }
};

ProxyHit cast(float distance) {
  return {{}, distance, true};
}

TEST(ShadeComparison, countsRaysThatSeeSomethingElse) {
  Rays r;
  r.truth.color = r.picture.color = Image<glm::vec3>(8, 1);
  const auto add = [&](const ProxyHit& p, const ProxyHit& q, size_t differing) {
    r.truth.color[r.rays.rays.size()] = p.color;
    r.picture.color[r.rays.rays.size()] = q.color;
    r.add(p, q);
    EXPECT_EQ(differingRays(r.rays, r.truth, r.picture), differing);
    EXPECT_EQ(differingRays(r.rays, r.picture, r.truth), differing);
  };
  add(cast(10), cast(10), 0);
  add(cast(10), cast(10.0009f), 0);
  add(cast(10), cast(10.002f), 1);
  add(cast(10), {{}, 10.0f, false}, 2);
  add(cast(10), {}, 3);
  add({glm::vec3(0.5f)}, {glm::vec3(0.5f, 0.5f, 0.503f)}, 3);
  add({glm::vec3(0.5f)}, {glm::vec3(0.5f, 0.5f, 0.505f)}, 4);
  add({}, {}, 4);
}

TEST(ShadeComparison, sortsFirstHits) {
  const float near = 1.5f * 10 / smallCamera().focalPixels();
  const ProxyHit nothing;
  const ProxyHit billboard{{}, 20.0f, false};
  Rays r;
  r.add(cast(10), cast(10 + 0.9f * near));
  r.add(cast(10), cast(10 + 1.2f * near));
  r.add(cast(10), nothing);
  r.add(cast(10), billboard);
  r.add(cast(10), cast(5));
  r.add(billboard, cast(10));
  r.add(nothing, cast(10));
  r.add(billboard, billboard);
  r.truth.color = r.picture.color = Image<glm::vec3>(8, 1);
  const std::vector<HitState> states = compareHits(r.rays, r.truth, r.picture, {{smallCamera()}});
  using enum HitState;
  EXPECT_EQ(states, (std::vector{kRight, kOff, kMissing, kMissing, kFalse, kFalse, kFalse, kElsewhere}));

  class NoProxy final : public SceneProxy {
    ProxyHit hit(const SecondaryRay&, RayCost&) const override { return {}; }
  };
  const BuiltProxy built{.name = "di", .proxy = std::make_unique<NoProxy>()};
  const ShadeFigures figures = figuresOf(built, r.rays, r.truth, r.picture, {{smallCamera()}});
  EXPECT_EQ(figures.castRays, 5u);
  EXPECT_EQ(figures.lost, 4u);
  EXPECT_EQ(figures.missing, 2u);
  EXPECT_EQ(figures.falseHits, 3u);
  EXPECT_DOUBLE_EQ(figures.lostRatio(), 0.8);
  EXPECT_DOUBLE_EQ(figures.falseRatio(), 3.0 / 8);
  EXPECT_EQ(figures.maxSteps, 7u);

  const Image<Rgb8> errors = hitErrorImage(r.rays, r.truth, states);
  EXPECT_EQ(errors[0], Rgb8(0));
  EXPECT_EQ(errors[1], kFalseSkinColor);
  EXPECT_EQ(errors[2], kMissingColor);
  EXPECT_EQ(errors[4], kWrongFrontColor);
}

TEST(ShadeComparison, measuresThePixelsOfRaysAlone) {
  Rays r;
  r.add(cast(10), cast(10));
  r.truth.color = Image<glm::vec3>(8, 1, glm::vec3(0));
  r.picture.color = Image<glm::vec3>(8, 1, glm::vec3(1));
  r.picture.color[0] = glm::vec3(0);
  class NoProxy final : public SceneProxy {
    ProxyHit hit(const SecondaryRay&, RayCost&) const override { return {}; }
  };
  const BuiltProxy built{.name = "di", .proxy = std::make_unique<NoProxy>()};
  EXPECT_TRUE(std::isinf(figuresOf(built, r.rays, r.truth, r.picture, {{smallCamera()}}).psnrDecibels));
  r.picture.color[0] = glm::vec3(1);
  EXPECT_DOUBLE_EQ(figuresOf(built, r.rays, r.truth, r.picture, {{smallCamera()}}).psnrDecibels, 0);
}

TEST(ShadeComparison, stepsShowFromDarkToBright) {
  Rays r;
  r.add(cast(10), cast(10));
  r.add(cast(10), cast(10));
  r.picture.stepsOfRay = {0, 48};
  r.picture.color = Image<glm::vec3>(8, 1);
  const Image<Rgb8> image = stepImage(r.rays, r.picture, 48);
  EXPECT_LT(image[0].x + image[0].y, 20);
  EXPECT_EQ(image[1], Rgb8(255));
  EXPECT_EQ(image[2], Rgb8(200)) << "no ray";
}

}  // namespace
}  // namespace ocelli
