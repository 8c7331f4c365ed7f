#include "oc_core/worlds/surface_textures.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "oc_core/worlds/surface_noise.h"

namespace ocelli {
namespace {

/// How near `x` is to a border of its cell of a width: 0 there, up to half a cell.
float toCellBorder(float x, float cell) {
  const float within = x - std::floor(x / cell) * cell;
  return std::min(within, cell - within);
}

glm::vec3 grained(const glm::vec3& color, const glm::vec2& p, uint32_t seed) {
  const float bend = layeredNoise({p.x * 0.9f, p.y * 2.5f}, 3, seed);
  const float rings = std::sin(p.y * 55 + 11 * bend);
  const float fine = layeredNoise({p.x * 5, p.y * 70}, 3, seed + 1);
  const float wide = layeredNoise(p * 1.3f, 3, seed + 2);
  const float dark = 1 + 0.10f * rings + 0.20f * fine + 0.14f * wide;
  return color * glm::vec3(dark, dark * (1 + 0.05f * wide), dark * (1 - 0.10f * rings));
}

glm::vec3 veined(const glm::vec3& color, const glm::vec2& p, uint32_t seed) {
  const glm::vec2 warped = p + 0.35f * glm::vec2(layeredNoise(p * 1.7f, 4, seed), layeredNoise(p * 1.7f, 4, seed + 9));
  const float ridge = 1 - std::abs(layeredNoise(warped * 2.2f, 4, seed + 3));
  const float vein = std::pow(ridge, 14.0f);
  const float cloud = layeredNoise(p * 3.0f, 4, seed + 4);
  const float grit = layeredNoise(p * 40.0f, 2, seed + 5);
  return color * (1 + 0.12f * cloud + 0.05f * grit) * glm::mix(glm::vec3(1), glm::vec3(0.55f, 0.57f, 0.62f), vein);
}

}  // namespace

SurfaceTexture plasterTexture(const glm::vec3& color, uint32_t seed) {
  return [=](const glm::vec2& p) {
    const float mottle = layeredNoise(p * 0.9f, 4, seed);
    const float trowel = layeredNoise({p.x * 7 + 2 * mottle, p.y * 11}, 3, seed + 1);
    const float grain = layeredNoise(p * 45.0f, 2, seed + 2);
    const float scuff = smoothEdge(0.45f, 0.75f, layeredNoise(p * 2.3f, 4, seed + 3));
    const float value = 1 + 0.11f * mottle + 0.10f * trowel + 0.085f * grain - 0.10f * scuff;
    return color * glm::vec3(value, value * (1 - 0.02f * mottle), value * (1 - 0.05f * mottle));
  };
}

SurfaceTexture woodTexture(const glm::vec3& color, uint32_t seed) {
  return [=](const glm::vec2& p) { return grained(color, p, seed); };
}

SurfaceTexture uprightWoodTexture(const glm::vec3& color, uint32_t seed) {
  return [=](const glm::vec2& p) { return grained(color, {p.y, p.x}, seed); };
}

SurfaceTexture parquetTexture(const glm::vec3& color, uint32_t seed) {
  constexpr float kSquare = 0.45f;
  constexpr float kPlank = kSquare / 5;
  return [=](const glm::vec2& p) {
    const auto column = static_cast<int>(std::floor(p.x / kSquare));
    const auto row = static_cast<int>(std::floor(p.y / kSquare));
    const glm::vec2 q = (column + row) % 2 == 0 ? p : glm::vec2(p.y, p.x);
    const auto plank = static_cast<int>(std::floor(q.y / kPlank));
    const uint32_t own = seed + static_cast<uint32_t>(column * 131 + row * 7919 + plank * 17);
    const float tint = latticeNoise(column * 31 + plank, row * 57 + plank, seed);
    const float joint = std::min(smoothEdge(0.0f, 0.007f, toCellBorder(q.y, kPlank)),
                                 smoothEdge(0.0f, 0.008f, toCellBorder(q.x, kSquare)));
    const float wear = layeredNoise(p * 0.7f, 4, seed + 77);
    const glm::vec3 wood = grained(color * (0.72f + 0.5f * tint), q + glm::vec2(tint * 9, tint * 5), own);
    return wood * (0.45f + 0.55f * joint) * (1 + 0.14f * wear);
  };
}

SurfaceTexture marbleTexture(const glm::vec3& color, uint32_t seed) {
  return [=](const glm::vec2& p) { return veined(color, p, seed); };
}

SurfaceTexture marbleTilesTexture(const glm::vec3& color, float tile, uint32_t seed) {
  return [=](const glm::vec2& p) {
    const auto column = static_cast<int>(std::floor(p.x / tile));
    const auto row = static_cast<int>(std::floor(p.y / tile));
    const float tint = latticeNoise(column, row, seed);
    const float grout = std::min(smoothEdge(0.001f, 0.009f, toCellBorder(p.x, tile)),
                                 smoothEdge(0.001f, 0.009f, toCellBorder(p.y, tile)));
    const glm::vec3 base = (column + row) % 2 == 0 ? color : color * glm::vec3(0.62f, 0.60f, 0.58f);
    const glm::vec3 stone = veined(base * (0.86f + 0.24f * tint), p + glm::vec2(tint * 13, tint * 29), seed + 1);
    const float dust = layeredNoise(p * 0.8f, 4, seed + 8);
    return stone * (0.5f + 0.5f * grout) * (1 + 0.10f * dust);
  };
}

SurfaceTexture carpetTexture(const glm::vec3& color, uint32_t seed) {
  constexpr float kTile = 0.5f;
  return [=](const glm::vec2& p) {
    const auto column = static_cast<int>(std::floor(p.x / kTile));
    const auto row = static_cast<int>(std::floor(p.y / kTile));
    const float tint = latticeNoise(column, row, seed) - 0.5f;
    const glm::vec2 q = (column + row) % 2 == 0 ? p : glm::vec2(p.y, -p.x);
    const float ribs = layeredNoise({q.x * 4, q.y * 32}, 2, seed + 1);
    const float yarn = layeredNoise(p * 42.0f, 2, seed + 2);
    const float mixed = layeredNoise(p * 21.0f, 3, seed + 3);
    const float trodden = layeredNoise(p * 0.9f, 4, seed + 4);
    const float joint = smoothEdge(0.0f, 0.008f, std::min(toCellBorder(p.x, kTile), toCellBorder(p.y, kTile)));
    const glm::vec3 flecks =
        glm::mix(color, color * glm::vec3(1.6f, 1.5f, 1.35f), 0.5f * smoothEdge(0.25f, 0.55f, mixed));
    return flecks * (1 + 0.14f * tint + 0.14f * ribs + 0.22f * yarn + 0.14f * mixed + 0.16f * trodden) *
           (0.75f + 0.25f * joint);
  };
}

SurfaceTexture rugTexture(const glm::vec2& size, const glm::vec3& ground, const glm::vec3& figure, uint32_t seed) {
  return [=](const glm::vec2& at) {
    // Woven by hand: no line is quite straight.
    const glm::vec2 p = at + 0.012f * glm::vec2(layeredNoise(at * 5.0f, 2, seed), layeredNoise(at * 5.0f, 2, seed + 1));
    const float border = std::min(std::min(p.x, size.x - p.x), std::min(p.y, size.y - p.y));
    const glm::vec2 c = p - size * 0.5f;
    glm::vec3 color = ground;
    const auto mixIn = [&](const glm::vec3& other, float part) { color = glm::mix(color, other, part); };
    const float diamond = std::abs(c.x) / (0.36f * size.x) + std::abs(c.y) / (0.36f * size.y);
    mixIn(figure, 0.8f * smoothEdge(0.25f, 0.0f, std::abs(diamond - 0.8f)));
    mixIn(glm::vec3(0.62f, 0.52f, 0.36f), smoothEdge(0.06f, 0.02f, std::abs(diamond - 0.45f)));
    const float flowers = std::cos(c.x * 34 + layeredNoise(p * 3.0f, 2, seed + 2)) * std::cos(c.y * 31 + 2 * p.x);
    mixIn(glm::vec3(0.66f, 0.48f, 0.28f), 0.7f * smoothEdge(0.55f, 0.8f, flowers));
    mixIn(figure * 0.4f, smoothEdge(-0.6f, -0.85f, flowers));
    if (border < 0.24f) {
      const float along = border == p.x || border == size.x - p.x ? p.y : p.x;
      color = figure * (0.6f + 0.4f * smoothEdge(-0.2f, 0.2f, std::sin(along * 40 + 1.5f * std::sin(border * 90))));
      mixIn(ground * 1.4f, smoothEdge(0.03f, 0.01f, std::abs(border - 0.2f)));
      mixIn(glm::vec3(0.65f, 0.57f, 0.42f), smoothEdge(0.03f, 0.01f, std::abs(border - 0.06f)));
    }
    const float knots = layeredNoise({at.x * 50, at.y * 42}, 2, seed + 3);
    return color * (1 + 0.2f * knots + 0.16f * layeredNoise(at * 1.6f, 4, seed + 4));
  };
}

SurfaceTexture ceilingTexture(const glm::vec3& color, uint32_t seed) {
  constexpr float kTile = 0.6f;
  return [=](const glm::vec2& p) {
    const float border = std::min(toCellBorder(p.x, kTile), toCellBorder(p.y, kTile));
    const auto column = static_cast<int>(std::floor(p.x / kTile));
    const auto row = static_cast<int>(std::floor(p.y / kTile));
    const float tint = latticeNoise(column, row, seed);
    const float pits = smoothEdge(0.2f, 0.6f, layeredNoise(p * 24.0f, 2, seed + 1));
    const float stain = layeredNoise(p * 0.8f, 4, seed + 2);
    const float rail = smoothEdge(0.012f, 0.03f, border);
    return color * (0.93f + 0.1f * tint - 0.16f * pits + 0.06f * stain) * (0.78f + 0.22f * rail);
  };
}

SurfaceTexture brickTexture(const glm::vec3& color, uint32_t seed) {
  constexpr float kLong = 0.25f;
  constexpr float kHigh = 0.075f;
  return [=](const glm::vec2& at) {
    const glm::vec2 p =
        at + 0.004f * glm::vec2(layeredNoise(at * 14.0f, 2, seed), layeredNoise(at * 14.0f, 2, seed + 1));
    const auto row = static_cast<int>(std::floor(p.y / kHigh));
    const float shifted = p.x + (row % 2 == 0 ? 0 : kLong / 2);
    const auto brick = static_cast<int>(std::floor(shifted / kLong));
    const float tint = latticeNoise(brick, row, seed);
    const float warm = latticeNoise(brick, row, seed + 7);
    const float inside = std::min(smoothEdge(0.003f, 0.009f, toCellBorder(shifted, kLong)),
                                  smoothEdge(0.003f, 0.009f, toCellBorder(p.y, kHigh)));
    const float rough = layeredNoise(at * 28.0f, 3, seed + 2);
    const glm::vec3 clay =
        color * glm::vec3(1, 0.82f + 0.36f * warm, 0.8f + 0.3f * warm) * (0.7f + 0.55f * tint + 0.2f * rough);
    const glm::vec3 mortar = glm::vec3(0.46f, 0.43f, 0.38f) * (1 + 0.15f * rough);
    return glm::mix(mortar, clay, inside) * (1 + 0.12f * layeredNoise(at, 4, seed + 3));
  };
}

SurfaceTexture clothTexture(const glm::vec3& color, uint32_t seed) {
  return [=](const glm::vec2& p) {
    const float weave = std::sin(p.x * 260 + layeredNoise(p * 6.0f, 2, seed)) * std::sin(p.y * 240);
    const float fluff = layeredNoise(p * 38.0f, 3, seed + 1);
    const float crease = layeredNoise({p.x * 3, p.y * 8}, 4, seed + 2);
    return color * (1 + 0.06f * weave + 0.14f * fluff + 0.18f * crease);
  };
}

SurfaceTexture metalTexture(const glm::vec3& color, uint32_t seed) {
  return [=](const glm::vec2& p) {
    const float brushed = layeredNoise({p.x * 3, p.y * 80}, 3, seed);
    const float tarnish = layeredNoise(p * 4.0f, 4, seed + 1);
    return color * (1 + 0.16f * brushed + 0.16f * tarnish);
  };
}

SurfaceTexture plasticTexture(const glm::vec3& color, uint32_t seed) {
  return [=](const glm::vec2& p) {
    return color * (1 + 0.08f * layeredNoise(p * 36.0f, 2, seed) + 0.1f * layeredNoise(p * 3.0f, 3, seed + 1));
  };
}

SurfaceTexture leafTexture(const glm::vec3& color, uint32_t seed) {
  return [=](const glm::vec2& p) {
    const float spots = layeredNoise(p * 30.0f, 3, seed);
    const float age = layeredNoise(p * 5.0f, 3, seed + 1);
    return color * glm::vec3(1 + 0.5f * age, 1 + 0.25f * spots, 1 + 0.2f * spots) * (1 + 0.15f * age);
  };
}

SurfaceTexture glowTexture(const glm::vec3& color, uint32_t seed) {
  return [=](const glm::vec2& p) {
    return color * (0.97f + 0.03f * layeredNoise(p * 3.0f, 3, seed) + 0.015f * layeredNoise(p * 30.0f, 2, seed + 1));
  };
}

}  // namespace ocelli
