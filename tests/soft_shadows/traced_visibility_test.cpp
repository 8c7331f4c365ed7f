#include "oc_core/soft_shadows/traced_visibility.h"

#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/soft_shadows/visibility_reference.h"
#include "tests/soft_shadows/light_scenes.h"

namespace ocelli {
namespace {

TEST(TracedVisibility, ofAHalfPlaneIsLinear) {
  const Mesh half = test::plate(-100, 0, -100, 100, 2);
  const TracedVisibility traced(half, test::lightAbove(), 1024);
  for (const float x : {-1.2f, -0.7f, -0.2f, 0.0f, 0.4f, 0.9f, 1.1f}) {
    const LightVisibility found = traced.of(std::vector<ShadowReceiver>{test::onFloor(x, 0.1f)});
    // One stratum a row is decided by chance, with a variance of at most 1/4: four sigma of 32 such rows.
    EXPECT_NEAR(found.share[0], std::clamp((1 + x) / 2, 0.0f, 1.0f), 4 * std::sqrt(32 / 4.0f) / 1024) << x;
    EXPECT_EQ(found.work.rays, 1024u);
  }
}

// More rays come closer to the samples of the slow reference.
TEST(TracedVisibility, comesCloserWithMoreRays) {
  const Mesh mesh = test::randomBoxes(12, 11);
  const std::vector<ShadowReceiver> receivers = test::floorGrid(8, 1.5f);
  std::vector<float> slow;
  for (const ShadowReceiver& receiver : receivers) {
    slow.push_back(visibilitySlowly(mesh, test::lightAbove(), receiver));
  }
  double last = 1;
  for (const int rays : {4, 64, 1024}) {
    const LightVisibility found = TracedVisibility(mesh, test::lightAbove(), rays).of(receivers);
    double squares = 0;
    for (size_t i = 0; i < receivers.size(); ++i) {
      squares += std::pow(static_cast<double>(found.share[i] - slow[i]), 2);
    }
    const double rmse = std::sqrt(squares / static_cast<double>(receivers.size()));
    EXPECT_LT(rmse, 0.5 * last) << rays;
    last = rmse;
  }
  EXPECT_LT(last, 0.008);  // both have 1,024 samples
}

TEST(TracedVisibility, fillsADiscEvenly) {
  const LightFrame frame(test::lightAbove(true, 2, 2));
  int inside = 0;
  int within = 0;
  constexpr int kSide = 64;
  for (int i = 0; i < kSide * kSide; ++i) {
    const glm::vec2 unit((static_cast<float>(i % kSide) + 0.5f) / kSide,
                         (static_cast<float>(i / kSide) + 0.5f) / kSide);
    const float radius = glm::length(TracedVisibility::onLight(frame, unit));
    inside += radius <= 1.0001f;
    within += radius <= 0.5f;
  }
  EXPECT_EQ(inside, kSide * kSide);
  EXPECT_NEAR(within, kSide * kSide / 4, 2 * kSide);  // a fourth of the area, to a stratum around it
}

TEST(TracedVisibility, isNoneWhereTheLightDoesNotShine) {
  const TracedVisibility traced({}, test::lightAbove(), 16);
  const LightVisibility found =
      traced.of(std::vector<ShadowReceiver>{{{0, 5, 0}, {0, 1, 0}}, {{0, 0, 0}, {0, -1, 0}}, {{0, 0, 0}, {0, 1, 0}}});
  EXPECT_EQ(found.share, (std::vector<float>{0, 0, 1}));
  EXPECT_EQ(found.work.rays, 16u);
}

}  // namespace
}  // namespace ocelli
