// Clusters: some 100 neighbouring triangles with vertices of their own, the unit in which packed scenes are read,
// chosen and drawn.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "oc_core/pack/sphere.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// Linear RGB in steps of 1/65535.
struct PackedColor {
  uint16_t red = 65535;
  uint16_t green = 65535;
  uint16_t blue = 65535;

  bool operator==(const PackedColor&) const = default;
};
PackedColor packedColor(const glm::vec3& linear);
inline glm::vec3 linearColor(const PackedColor& c) {
  return glm::vec3(c.red, c.green, c.blue) * (1.0f / 65535);
}

struct Cluster {
  static constexpr size_t kMaxTriangles = 112;
  static constexpr size_t kMaxVertices = 96;

  struct Corners {
    uint8_t a = 0;
    uint8_t b = 0;
    uint8_t c = 0;
  };

  std::vector<glm::vec3> positions;  ///< world coordinates
  std::vector<PackedColor> colors;   ///< one a vertex
  std::vector<Corners> triangles;    ///< vertices of this cluster

  Sphere bounds() const { return aroundPoints(positions); }
};

/// Triangles whose vertices are shared: those with the same position and colour, bit by bit, are one vertex. Triangles
/// without area that way (two corners in one vertex) are left out.
struct WeldedTriangles {
  std::vector<glm::vec3> positions;
  std::vector<PackedColor> colors;
  std::vector<uint32_t> indices;  ///< three a triangle

  size_t triangleCount() const { return indices.size() / 3; }
};

/// Welds triangles that come one by one.
class Welder {
 public:
  /// Room for about so many vertices.
  explicit Welder(size_t vertices);

  uint32_t vertex(const glm::vec3& position, const PackedColor& color);
  void add(uint32_t a, uint32_t b, uint32_t c);
  void add(const Cluster& cluster);
  WeldedTriangles take() { return std::move(welded_); }

 private:
  void grow();

  WeldedTriangles welded_;
  std::vector<uint32_t> table_;  ///< vertices by the hash of their bits; open addressing
};

/// Cuts triangles into clusters. Which ones depends on nothing but `welded`.
std::vector<Cluster> clustersOf(const WeldedTriangles& welded);

}  // namespace ocelli
