// Horizons against rays: 256 at each point of a surface of 80,000 triangles.
#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/ambient/ambient_error.h"
#include "oc_core/ambient/horizon_ambient.h"
#include "oc_core/ambient/ray_ambient.h"
#include "oc_core/ambient/three_frusta.h"
#include "tests/ambient/ambient_scenes.h"

namespace ocelli {
namespace {

TEST(HorizonAmbient, agreesWithRaysOnAHeightField) {
  // Waves that the view looks straight into, none of them hidden.
  Mesh mesh;
  constexpr int kSide = 200;
  const auto height = [](float x, float y) { return 0.12f * std::sin(6 * x) * std::cos(5 * y); };
  for (int j = 0; j < kSide; ++j) {
    for (int i = 0; i < kSide; ++i) {
      const auto corner = [&](int a, int b) {
        const float x = 4 * (static_cast<float>(a) / kSide - 0.5f);
        const float y = 4 * (static_cast<float>(b) / kSide - 0.5f);
        return glm::vec3(x, y, height(x, y));
      };
      test::addQuad(mesh, corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1));
    }
  }
  const PinholeCamera camera(View{}, 180, 120);
  const PinholeCamera wide = withBorder(camera, 60);
  const AmbientOptions options{.radius = 0.7};
  const std::vector<AmbientPoint> points = test::pointsOf(camera, mesh);
  const std::vector<float> truth = ambientByRays(points, RayScene(mesh), options, {.count = 256});
  const HorizonImage image(GraphCamera(wide), raycast(GraphCamera(wide), mesh, RayScene(mesh)), mesh);
  const AmbientError error =
      ambientError(ambientByHorizon(points, image, options, {.directions = 64, .steps = 200}).light, truth);
  EXPECT_LT(error.rmse, 0.02) << "of which 0.01 are the rays'";
  EXPECT_LT(std::abs(error.signedMean), 0.01);
  // The usual numbers of directions and steps.
  EXPECT_LT(ambientError(ambientByHorizon(points, image, options).light, truth).rmse, 0.035);
}

}  // namespace
}  // namespace ocelli
