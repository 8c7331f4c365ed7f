// Which quads of a ray map (ray_map_quad.h) a point can lie in: a pyramid over the image, whose nodes each bound the
// rays of a square of pixels by a chain of tapered capsules.
//
// The chain has corners at a few parameters, the same for all nodes. At each of them a ball holds the points of all
// rays there; between two of them the point of a ray at parameter t lies in the ball whose centre and radius are
// interpolated, and which is larger by what rays that bend deviate from their chords. Nodes of a pinhole are cones,
// those of a push-broom camera are sheets.
#pragma once

#include <vector>

#include "oc_core/camera/ray_map.h"

namespace ocelli {

class RayMapSearch {
 public:
  explicit RayMapSearch(const RayMap& map);

  /// Blocks of quads: squares of kBlockSide of them, but for those at the right and lower borders.
  static constexpr int kBlockSide = 4;
  /// Those that may hold a ray through the point, with no order.
  std::vector<glm::ivec2> blocksNear(const glm::dvec3& point) const;

 private:
  struct Level {
    glm::ivec2 size{0};
    size_t first = 0;  ///< node
  };
  struct Ball {
    glm::vec3 centre{0};
    float radius = -1;  ///< none where no ray is there
  };

  size_t corners() const { return parameters_.size(); }
  size_t nodeOf(size_t level, const glm::ivec2& at) const {
    return levels_[level].first + static_cast<size_t>(at.y) * static_cast<size_t>(levels_[level].size.x) +
           static_cast<size_t>(at.x);
  }
  void boundBlock(const RayMap& map, const glm::ivec2& block);
  void boundChildren(size_t level, const glm::ivec2& at);
  bool mayHold(size_t node, const glm::dvec3& point) const;

  std::vector<float> parameters_;  ///< of the corners of chains
  std::vector<Level> levels_;      ///< blocks first
  std::vector<Ball> balls_;        ///< a node's corners one after the other
  std::vector<float> deviations_;  ///< a node's, between its corners
};

}  // namespace ocelli
