#include "display_sim/dither_score/dither_fields.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>

#include "display_sim/dither/diffusion.h"
#include "display_sim/dither/voxel_dither.h"

namespace ocelli {
namespace {

constexpr int kSlicesPerHalfTurn = 198;
constexpr int kFieldSide = 128;
constexpr int kSlices = 16;

/// From -1 to 1 across the field, of a voxel's centre.
glm::vec2 inField(int column, int row) {
  return (glm::vec2(column, row) + 0.5f) * (2.0f / kFieldSide) - 1.0f;
}

glm::vec3 ballColor(int column, int row, int slice) {
  const glm::vec2 p = inField(column, row) / 0.95f;
  const float inside = 1 - glm::dot(p, p);
  if (inside < 0) {
    return glm::vec3(0);
  }
  const float angle = static_cast<float>(slice) * std::numbers::pi_v<float> / kSlicesPerHalfTurn;
  const glm::vec3 toLight = glm::normalize(glm::vec3(0.6f * std::cos(angle), -0.6f, 0.7f + std::sin(angle)));
  return glm::vec3(0.04f + 0.96f * std::max(0.0f, glm::dot(glm::vec3(p.x, p.y, std::sqrt(inside)), toLight)));
}

glm::vec3 wheelColor(int column, int row, int /*slice*/) {
  const glm::vec2 p = inField(column, row) / 0.95f;
  const float saturation = glm::length(p);
  if (saturation > 1) {
    return glm::vec3(0);
  }
  const float hue = std::atan2(-p.y, p.x) * 3 * std::numbers::inv_pi_v<float>;  // -3 to 3
  const auto channel = [&](float middle) {
    const float away = std::abs(hue - middle);
    return glm::clamp(2 - std::min(away, 6 - away), 0.0f, 1.0f);
  };
  return 1.0f - saturation * (1.0f - glm::vec3(channel(0), channel(2), channel(-2)));
}

std::vector<glm::vec3> diffusedLight(const DitherField& field, int bitsPerChannel) {
  DisplayProfile profile;
  profile.slicesPerHalfTurn = kSlicesPerHalfTurn;
  profile.width = 2 * field.columns;
  profile.height = field.rows;
  profile.halfHeightRadii = static_cast<double>(field.rows) / profile.width;  // rows as high as columns are wide
  profile.colorBitsPerChannel = bitsPerChannel;
  VoxelColors colors(kSlicesPerHalfTurn);
  for (int slice = 0; slice < field.slices; ++slice) {
    for (int row = 0; row < field.rows; ++row) {
      for (int column = 0; column < field.columns; ++column) {
        colors[static_cast<size_t>(slice)].push_back(
            {static_cast<uint32_t>(row * profile.width + field.columns + column), field.color(column, row, slice)});
      }
    }
  }
  const Volume volume = diffuse(std::move(colors), profile).volume;
  std::vector<glm::vec3> light(field.voxels(), glm::vec3(0));
  for (int slice = 0; slice < field.slices; ++slice) {
    forEachLevel(volume, slice, [&](int column, int row, const Rgb8& levels) {
      light[field.index(column - field.columns, row, slice)] =
          glm::vec3(levels) / static_cast<float>(volume.fullLevel());
    });
  }
  return light;
}

}  // namespace

DitherField rampField() {
  constexpr int kColumns = 256;
  return {"ramp", kColumns, 64, kSlices,
          [](int column, int, int) { return glm::vec3((static_cast<float>(column) + 0.5f) / kColumns); }};
}

DitherField greySphereField() {
  return {"grey sphere", kFieldSide, kFieldSide, kSlices, ballColor};
}

DitherField colorWheelField() {
  return {"colour wheel", kFieldSide, kFieldSide, kSlices, wheelColor};
}

std::vector<DitherField> ditherFields() {
  return {rampField(), greySphereField(), colorWheelField()};
}

std::vector<glm::vec3> shownLight(const DitherField& field, ColorReduction colors, int bitsPerChannel) {
  if (colors == ColorReduction::kDiffusion) {
    return diffusedLight(field, bitsPerChannel);
  }
  const VoxelDither dither(colors);
  const int full = (1 << bitsPerChannel) - 1;
  std::vector<glm::vec3> light(field.voxels());
  for (int slice = 0; slice < field.slices; ++slice) {
    for (int row = 0; row < field.rows; ++row) {
      for (int column = 0; column < field.columns; ++column) {
        light[field.index(column, row, slice)] =
            glm::vec3(dither.levels(field.color(column, row, slice), full, slice, column, row)) /
            static_cast<float>(full);
      }
    }
  }
  return light;
}

}  // namespace ocelli
