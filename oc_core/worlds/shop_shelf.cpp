#include "oc_core/worlds/shop_shelf.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "oc_core/base/random.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/placement.h"
#include "oc_core/worlds/surface_noise.h"

namespace ocelli {
namespace {

constexpr float kShelfBoard = 0.035f;
constexpr std::array kShelfHeights{0.12f, 0.56f, 0.98f, 1.4f, 1.82f};  ///< heights of what stands on them
constexpr std::array kShelfRoom{0.38f, 0.36f, 0.36f, 0.36f, 0.4f};     ///< over each

glm::vec3 packageColor(float choice) {
  const std::array colors{palette::vermilion(), palette::skyBlue(), palette::green(),  palette::yellow(),
                          palette::purple(),    palette::blue(),    palette::orange(), palette::ivory(),
                          palette::brick(),     palette::slate()};
  return colors[std::min(colors.size() - 1, static_cast<size_t>(choice * static_cast<float>(colors.size())))];
}

/// Fronts of packages of one height side by side: a few of each kind, with a label.
SurfaceTexture packagesTexture(float height, float width, uint32_t seed) {
  return [=](const glm::vec2& p) {
    const float at = p.x / width;
    const int package = static_cast<int>(std::floor(at));
    const int kind = static_cast<int>(std::floor(at / 4));
    const glm::vec3 color = packageColor(latticeNoise(kind, 1, seed)) * (0.85f + 0.15f * latticeNoise(kind, 2, seed));
    const glm::vec3 label = packageColor(latticeNoise(kind, 3, seed)) * 0.35f + glm::vec3(0.5f);
    const float x = at - static_cast<float>(package);
    const float y = p.y / height;
    const bool isLabel = x > 0.16f && x < 0.84f && y > 0.3f && y < 0.72f;
    const float gap = smoothEdge(0, 0.09f, std::min(x, 1 - x)) * smoothEdge(1, 0.94f, y);
    const float sheen = 1 + 0.12f * layeredNoise(p * 6.0f, 2, seed + 7);
    return (isLabel ? label : color) * (0.25f + 0.75f * gap) * sheen;
  };
}

}  // namespace

void addShopShelf(PlaceBuilder& place, float length, const glm::mat4& worldFromShelf, uint32_t seed) {
  Random random(seed);
  const SurfaceTexture metal = metalTexture(palette::fromSrgbBytes(178, 180, 184), seed);
  const auto box = [&](const glm::vec3& size, const glm::vec3& middle, const BoxLook& look) {
    place.addBox(size, worldFromShelf * placedAt(middle), look);
  };
  box({length - 0.01f, kShopShelfHeight, 0.04f}, {length / 2, kShopShelfHeight / 2, -kShopShelfDepth + 0.02f},
      BoxLook(metal).plain(BoxFace::kBack).plain(BoxFace::kBottom).noShadow());
  for (const float x : {0.014f, length - 0.014f}) {
    box({0.028f, kShopShelfHeight + 0.02f, kShopShelfDepth - 0.005f},
        {x, kShopShelfHeight / 2 + 0.01f, -kShopShelfDepth / 2},
        BoxLook(metalTexture(palette::fromSrgbBytes(206, 202, 192), seed + 1)).plain(BoxFace::kBottom).noShadow());
  }
  for (size_t level = 0; level < kShelfHeights.size(); ++level) {
    const float top = kShelfHeights[level];
    const float thick = level == 0 ? top : kShelfBoard;  // the lowest stands on the floor
    const float front = level == 0 ? 0.0f : -0.03f;
    box({length - 0.056f, thick, kShopShelfDepth - 0.05f + front},
        {length / 2, top - thick / 2, (-kShopShelfDepth + 0.04f + front) / 2},
        BoxLook(metal).plain(BoxFace::kBottom).noShadow());
    for (float x = 0.04f; x < length - 0.35f;) {
      const float width = std::min(random.inRange(0.7f, 1.3f), length - 0.04f - x);
      const float height = kShelfRoom[level] * random.inRange(0.62f, 0.97f);
      const float deep = 0.3f;
      const SurfaceTexture packages =
          packagesTexture(height, random.inRange(0.08f, 0.2f), static_cast<uint32_t>(random.next() >> 33));
      box({width - 0.012f, height, deep}, {x + width / 2, top + height / 2 - 0.003f, front - 0.05f - deep / 2},
          BoxLook(packages)
              .with(BoxFace::kTop, plasticTexture(palette::fromSrgbBytes(150, 140, 124), seed + 3))
              .plain(BoxFace::kBack)
              .plain(BoxFace::kBottom)
              .plain(BoxFace::kLeft)
              .plain(BoxFace::kRight)
              .noShadow());
      x += width;
    }
  }
}

}  // namespace ocelli
