// `builtin:particles`: clusters of very many square particles over a plain terrain, whose detail is far beyond what
// pixels hold (the scene of dissertation Figure 5.11).
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <utility>

#include "oc_core/base/conventions.h"
#include "oc_core/base/random.h"
#include "oc_core/worlds/builtin_list.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/random_places.h"

namespace ocelli {
namespace {

constexpr double kMaxClusters = 6;
constexpr double kMaxParticles = 1e6;  ///< of a cluster
/// The side of a square, over the cube root of the volume that each has.
constexpr float kSideOverSpacing = 0.75f;
constexpr glm::vec2 kTerrainHalf{1, 0.75f};
constexpr float kHeight = 0.14f;  ///< of its hills
/// The default view is level: it sees the terrain at this angle.
constexpr double kTerrainTiltDegrees = 30;

using Color = glm::vec3 (*)();
constexpr std::array<std::array<Color, 2>, 3> kColors{
    {{palette::green, palette::blue}, {palette::vermilion, palette::blue}, {palette::purple, palette::skyBlue}}};

/// Squares of random places and directions in the unit ball.
Mesh makeCluster(size_t count, const std::array<Color, 2>& colors, Random& random) {
  const float spacing = std::cbrt(static_cast<float>(4 * kPi / 3) / static_cast<float>(count));
  const float half = kSideOverSpacing * spacing / 2;
  // Each one stays whole in the ball.
  const float reach = std::max(0.0f, 1 - half * std::sqrt(2.0f));
  Mesh cluster;
  cluster.positions.reserve(count * 4);
  cluster.colors.reserve(count * 4);
  cluster.triangles.reserve(count * 2);
  for (size_t i = 0; i < count; ++i) {
    const glm::vec3 center = reach * randomInBall(random);
    const glm::vec3 normal = randomDirection(random);
    const glm::vec3 x = half * randomBeside(normal, random);
    const glm::vec3 y = glm::cross(normal, x);
    const glm::vec3 color = colors[random.below(2)]();
    const auto base = static_cast<uint32_t>(cluster.positions.size());
    cluster.positions.insert(cluster.positions.end(), {center - x - y, center + x - y, center + x + y, center - x + y});
    cluster.colors.insert(cluster.colors.end(), 4, color);
    cluster.triangles.push_back({base, base + 1, base + 2});
    cluster.triangles.push_back({base, base + 2, base + 3});
  }
  return cluster;
}

float terrainHeight(const glm::vec2& place) {
  return kHeight / 3 *
         (std::sin(3.1f * place.x + 0.8f) + std::sin(4.3f * place.y - 2.0f * place.x) +
          std::cos(5.2f * place.x - 1.7f * place.y));
}

/// Few large triangles.
Mesh makeTerrain() {
  constexpr uint32_t kColumns = 20;
  constexpr uint32_t kRows = 15;
  Mesh terrain;
  for (uint32_t row = 0; row <= kRows; ++row) {
    for (uint32_t column = 0; column <= kColumns; ++column) {
      const glm::vec2 place =
          kTerrainHalf *
          (2.0f * glm::vec2(static_cast<float>(column) / kColumns, static_cast<float>(row) / kRows) - 1.0f);
      const float height = terrainHeight(place);
      terrain.positions.push_back({place.x, height, place.y});
      terrain.colors.push_back(palette::yellow() * (0.75f + 0.25f * height / kHeight));
    }
  }
  for (uint32_t row = 0; row < kRows; ++row) {
    for (uint32_t column = 0; column < kColumns; ++column) {
      const uint32_t a = row * (kColumns + 1) + column;
      const uint32_t c = a + kColumns + 1;
      terrain.triangles.push_back({a, c, c + 1});
      terrain.triangles.push_back({a, c + 1, a + 1});
    }
  }
  return terrain;
}

Scene buildParticles(const BuiltinValues& values) {
  const size_t clusters = values.count("clusters");
  const size_t count = values.count("count");
  Random random(values.count("seed"));
  const glm::mat4 tilt =
      glm::rotate(glm::mat4(1), static_cast<float>(radiansFromDegrees(kTerrainTiltDegrees)), glm::vec3(1, 0, 0));
  Scene scene;
  scene.add(makeTerrain(), tilt);
  for (size_t i = 0; i < clusters; ++i) {
    const auto number = static_cast<float>(i);
    // Every second one is half as large, so that it needs more samples a pixel, and stands farther back.
    const float radius = static_cast<float>(values.number("radius")) * (i % 2 == 0 ? 1.0f : 0.5f);
    const glm::vec2 place = kTerrainHalf * glm::vec2(1.3f * ((number + 0.5f) / static_cast<float>(clusters) - 0.5f),
                                                     i % 2 == 0 ? 0.1f : -0.4f);
    const glm::vec3 center(place.x, terrainHeight(place) + 0.1f + radius, place.y);
    scene.add(makeCluster(count, kColors[i % kColors.size()], random),
              tilt * glm::scale(glm::translate(glm::mat4(1), center), glm::vec3(radius)));
    scene.instances.back().object = static_cast<uint32_t>(i + 1);
  }
  return scene;
}

}  // namespace

BuiltinScene particlesScene() {
  using Kind = BuiltinParameter::Kind;
  return {
      .name = "particles",
      .summary = "clusters of very many square particles over a terrain; each cluster is an object",
      .parameters = {{"clusters", "how many; every second one is half as large", Kind::kInteger, "2", 1, kMaxClusters},
                     {"count", "of the particles of each cluster, of two triangles each", Kind::kInteger, "10000", 1,
                      kMaxParticles},
                     {"radius", "of the first cluster; the terrain is 2 wide", Kind::kNumber, "0.2", 0.01, 0.3},
                     {"seed", "of the random numbers", Kind::kInteger, "1", 0, 4294967295.0}},
      .build = buildParticles};
}

}  // namespace ocelli
