// Materials of places to walk through, as functions of a point on a surface in metres: wood, plaster, stone, carpet.
// Each has detail at several scales, from a metre to a centimetre, follows its seed, and repeats nowhere.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace ocelli {

/// The linear colour at a point of a surface: metres to the right and up from its lower left corner, seen from outside.
using SurfaceTexture = std::function<glm::vec3(const glm::vec2& metres)>;

SurfaceTexture plasterTexture(const glm::vec3& color, uint32_t seed);
/// Boards with grain along `u`.
SurfaceTexture woodTexture(const glm::vec3& color, uint32_t seed);
/// The same with grain along `v`.
SurfaceTexture uprightWoodTexture(const glm::vec3& color, uint32_t seed);
/// Squares of five planks each, turned by turns.
SurfaceTexture parquetTexture(const glm::vec3& color, uint32_t seed);
SurfaceTexture marbleTexture(const glm::vec3& color, uint32_t seed);
/// Marble in tiles of `tile` metres with grout between.
SurfaceTexture marbleTilesTexture(const glm::vec3& color, float tile, uint32_t seed);
/// Tiles of carpet half a metre wide, in the mixed yarns of an office.
SurfaceTexture carpetTexture(const glm::vec3& color, uint32_t seed);
/// A woven rug of a size, with a border and medallions.
SurfaceTexture rugTexture(const glm::vec2& size, const glm::vec3& ground, const glm::vec3& figure, uint32_t seed);
/// Mineral tiles of 0.6 m in a hung ceiling.
SurfaceTexture ceilingTexture(const glm::vec3& color, uint32_t seed);
SurfaceTexture brickTexture(const glm::vec3& color, uint32_t seed);
SurfaceTexture clothTexture(const glm::vec3& color, uint32_t seed);
SurfaceTexture metalTexture(const glm::vec3& color, uint32_t seed);
SurfaceTexture plasticTexture(const glm::vec3& color, uint32_t seed);
SurfaceTexture leafTexture(const glm::vec3& color, uint32_t seed);
/// A plain light, as of a lamp's cover or a bright sky, which hardly varies.
SurfaceTexture glowTexture(const glm::vec3& color, uint32_t seed);

}  // namespace ocelli
