#include "display_sim/viewer/camera_rays.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

constexpr int kWidth = 180;
constexpr int kHeight = 120;

const Mesh& scene() {
  static const Mesh mesh = loadScene("builtin:boxes");
  return mesh;
}

float distanceToSegment(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b) {
  const float length2 = glm::dot(b - a, b - a);
  const float t = length2 > 0 ? glm::clamp(glm::dot(p - a, b - a) / length2, 0.0f, 1.0f) : 0;
  return glm::distance(p, a + (b - a) * t);
}

class CameraRays : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Cameras, CameraRays,
                         testing::Values("di", "di-wide", "corners-4", "ldi-4", "rppc", "spoc", "di+spoc", "ddoc",
                                         "eoc-h", "eoc-v", "eoc-forward", "eoc-hv", "eoc-hv+ddoc", "cell"));

// Every sample lies on the ray of its pixel: that is what the rays are.
TEST_P(CameraRays, goThroughTheSamplesOfTheirPixels) {
  const CameraChoice choice = cameraChoice(GetParam());
  const PinholeCamera reference(View{}, kWidth, kHeight);
  const ReferenceImages images = buildReferenceImages(choice, reference, scene());
  const std::vector<RayFunction> rays = cameraRays(choice, reference, scene(), images);
  ASSERT_EQ(rays.size(), images.size());
  size_t samples = 0;
  size_t beside = 0;
  size_t without = 0;
  for (size_t i = 0; i < images.size(); ++i) {
    const PinholeCamera own = images[i].reference();
    for (int y = 1; y < images[i].height(); y += 5) {
      for (int x = 1; x < images[i].width(); x += 3) {
        if (!images[i].holds(x, y)) {
          continue;
        }
        const ImagePoint undistorted = images[i].undistorted(x, y);
        const glm::vec3 point = own.worldFromCamera(own.cameraFromImage(undistorted));
        const RayPath ray = rays[i]({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
        float nearest = 1e30f;
        for (size_t k = 0; k + 1 < ray.size(); ++k) {
          nearest = std::min(nearest, distanceToSegment(point, ray[k], ray[k + 1]));
        }
        ++samples;
        without += ray.empty();
        beside += !ray.empty() && nearest > undistorted.t / own.focalPixels();
      }
    }
  }
  EXPECT_GT(samples, 100U);
  // A sample may lie up to a pixel beside the ray of its pixel's centre where a map folds or jumps.
  // A cell camera stores some samples twice, to close seams: those have no ray of their own.
  EXPECT_LE(without, choice.name == "cell" ? samples / 8 : 0);
  EXPECT_LE(static_cast<double>(beside), 0.02 * static_cast<double>(samples)) << beside << " of " << samples;
}

TEST(CameraRays, meshesWithoutImagesHaveNone) {
  const PinholeCamera reference(View{}, kWidth, kHeight);
  EXPECT_TRUE(cameraRays(cameraChoice("geometry"), reference, scene(), {}).empty());
}

TEST(RayBetween, cutsARayAtDepths) {
  const PinholeCamera camera(View{}, 10, 10);  // at (0, 0, 10), looking along -z
  const RayPath ray{{0, 0, 9}, {0, 0, 5}, {1, 0, 1}};
  const std::vector<glm::vec3> part = rayBetween(ray, camera, 2, 7);
  ASSERT_EQ(part.size(), 3U);
  EXPECT_LT(glm::distance(part[0], glm::vec3(0, 0, 8)), 1e-5f);
  EXPECT_LT(glm::distance(part[1], glm::vec3(0, 0, 5)), 1e-5f);
  EXPECT_LT(glm::distance(part[2], glm::vec3(0.5f, 0, 3)), 1e-5f);
  EXPECT_TRUE(rayBetween(ray, camera, 20, 30).empty());
  EXPECT_TRUE(rayBetween({}, camera, 0, 30).empty());
}

TEST(IsBent, straightLinesAreNot) {
  EXPECT_FALSE(isBent({}, 0.01f));
  EXPECT_FALSE(isBent({{0, 0, 0}, {0, 0, 1}}, 0.01f));
  EXPECT_FALSE(isBent({{0, 0, 0}, {0, 0.005f, 1}, {0, 0, 2}}, 0.01f));
  EXPECT_TRUE(isBent({{0, 0, 0}, {0, 0.02f, 1}, {0, 0, 2}}, 0.01f));
}

}  // namespace
}  // namespace ocelli
