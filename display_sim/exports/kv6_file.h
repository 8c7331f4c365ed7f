// KV6 voxel models (`.kv6`) as bytes: the format of SLAB6 and Voxlap (Ken Silverman, advsys.net/ken), which Voxon's
// volumetric displays load.
//
// A file, all numbers little-endian:
//   "Kvxl", int32 sizes x, y, z, float32 pivot x, y, z (in voxels), int32 n
//   n voxels of 8 bytes: blue, green, red, 128, uint16 z, uint8 visible faces, uint8 normal
//   int32 voxels of each x, then uint16 voxels of each (x, y), y fastest
//   optional: "SPal" and 768 bytes, the palette that its editor suggests
// Voxels stand column after column (x slowest, then y), in a column by growing z. The axes: x to the right, y towards
// the viewer, z down.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "oc_core/image/png_file.h"

namespace ocelli {

/// A face is visible where the neighbour behind it is empty: bits of Kv6Voxel::faces.
inline constexpr uint8_t kKv6LowX = 1;
inline constexpr uint8_t kKv6HighX = 2;
inline constexpr uint8_t kKv6LowY = 4;
inline constexpr uint8_t kKv6HighY = 8;
inline constexpr uint8_t kKv6LowZ = 16;  ///< above
inline constexpr uint8_t kKv6HighZ = 32;
inline constexpr uint8_t kKv6Faces = 63;

struct Kv6Voxel {
  Rgb8 color{0};
  uint16_t z = 0;
  uint8_t faces = 0;
  uint8_t normal = 0;  ///< kv6Normal()

  bool operator==(const Kv6Voxel&) const = default;
};

struct Kv6Model {
  int sizeX = 0;
  int sizeY = 0;
  int sizeZ = 0;
  glm::vec3 pivot{0};
  std::vector<Kv6Voxel> voxels;
  std::vector<uint16_t> voxelsOfColumn;  ///< at x * sizeY + y

  bool operator==(const Kv6Model&) const = default;
};

inline constexpr int kMaxKv6Side = 65535;

/// `model` is one that kv6FromBytes() would give.
std::string kv6Bytes(const Kv6Model& model);

/// Trusts nothing; a palette is passed over. Throws InputError, naming `where`, for what is no model: sizes out of
/// range, counts that contradict each other, voxels outside of the grid or out of order, bytes that are missing or too
/// many.
Kv6Model kv6FromBytes(std::string_view bytes, const std::string& where);

/// The table of normals: 255 directions on a spiral around the z axis, and the zero vector at kKv6NoNormal. They point
/// into the solid: Voxlap lights a voxel where its normal points away from the lamp.
glm::dvec3 kv6Normal(uint8_t index);
inline constexpr uint8_t kKv6NoNormal = 255;
/// The nearest of the table to a direction of any length; kKv6NoNormal for the zero vector.
uint8_t kv6NormalIndex(const glm::dvec3& direction);

}  // namespace ocelli
