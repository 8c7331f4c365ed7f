#include "oc_core/scene/import/uv_transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>

namespace ocelli {
namespace {

constexpr float kUvStep = 1e-6f;  // a few roundings of numbers around 1

/// `uv` has its origin at the top left and v downwards, as in a glTF file, and so has what is returned.
glm::vec2 moved(const TextureTransform& transform, const glm::vec2& uv) {
  const glm::vec3 up = matrixOf(transform) * glm::vec3(uv.x, 1 - uv.y, 1);
  return {up.x, 1 - up.y};
}

void expectNear(const glm::vec2& got, const glm::vec2& wanted) {
  EXPECT_NEAR(got.x, wanted.x, kUvStep);
  EXPECT_NEAR(got.y, wanted.y, kUvStep);
}

TEST(TextureTransform, ScalesThenAddsTheOffset) {
  expectNear(moved({{0.25f, 0.5f}, 0, {0.5f, 2}}, {1, 0.25f}), {0.75f, 1});
}

// The example of the extension: "only the lower left quadrant of the source image, rotated clockwise 90 degrees".
TEST(TextureTransform, TakesTheLowerLeftQuadrantTurnedByAQuarter) {
  const TextureTransform example{{0, 1}, glm::half_pi<float>(), {0.5f, 0.5f}};
  expectNear(moved(example, {0, 0}), {0, 1});
  expectNear(moved(example, {1, 0}), {0, 0.5f});
  expectNear(moved(example, {1, 1}), {0.5f, 0.5f});
  expectNear(moved(example, {0, 1}), {0.5f, 1});
}

TEST(TextureTransform, ScalesBeforeItTurns) {
  // (1, 1) becomes (2, 3), and a quarter counter-clockwise with v downwards (3, -2).
  expectNear(moved({{0, 0}, glm::half_pi<float>(), {2, 3}}, {1, 1}), {3, -2});
}

// What glTF2Importer.cpp of Assimp makes of the extension.
AssimpTransform asAssimpWritesIt(const TextureTransform& t) {
  const float c = std::cos(t.rotation);
  const float s = std::sin(t.rotation);
  return {{0.5f * t.scale.x * (-c + s + 1) + t.offset.x, 0.5f * t.scale.y * (s + c - 1) + 1 - t.scale.y - t.offset.y},
          -t.rotation,
          t.scale};
}

TEST(TextureTransform, ComesBackFromAssimp) {
  const TextureTransform wanted{{0.3f, -0.7f}, 0.6f, {1.5f, -0.25f}};
  const TextureTransform back = textureTransform(asAssimpWritesIt(wanted));
  expectNear(back.offset, wanted.offset);
  expectNear(back.scale, wanted.scale);
  EXPECT_NEAR(back.rotation, wanted.rotation, kUvStep);
}

}  // namespace
}  // namespace ocelli
