// Steps along the pieces of a ray, as many at once as the machine's vectors hold: the inner loop of VolumeRenderer. For
// .cpp files.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <string>

#include "oc_core/volume/gradient_light.h"
#include "oc_core/volume/scalar_volume.h"
#include "oc_core/volume_render/optical_table.h"
#include "oc_core/volume_render/ray_pieces.h"

namespace ocelli {

/// What all rays have in common.
struct MarchSetup {
  const ScalarVolume* volume = nullptr;
  /// Entries are at (number in the voxel - firstNumber) * entriesByNumber.
  double firstNumber = 0;
  float entriesByNumber = 0;
  const OpticalTable::Entry* entries = nullptr;

  const uint8_t* distances = nullptr;  ///< of VolumeOccupancy; null: no sample is left out
  glm::ivec3 bricks{0};

  float step = 0;  ///< in the unit of length of pieces
  float endTransmittance = 0;
  float depthOpacity = 0;

  bool isShaded = false;
  GradientLight<float> light{};  ///< of gradients of numbers in voxels
};

struct MarchResult {
  std::array<float, 3> color{};  ///< premultiplied
  float transmittance = 1;
  float t = 0;          ///< where the opacity reaches depthOpacity, if it does
  bool isDeep = false;  ///< whether it does
  uint32_t samples = 0;
};

/// Writes the pieces of a ray, by its number, and returns how many they are.
using PiecesOfRay = std::function<size_t(size_t ray, VolumeExtent::Pieces& pieces)>;

/// One result a ray, which do not depend on each other. `stopsAtDepth`: what lies beyond t has no part in the result.
void march(const MarchSetup& setup, const PiecesOfRay& piecesOfRay, bool stopsAtDepth, std::span<MarchResult> results);

/// Of the vectors that march() uses on this machine: "AVX3".
std::string marchInstructionSet();

}  // namespace ocelli
