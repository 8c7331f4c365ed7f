// Simulated subjects: figures of boxes with legs and arms that move, who walk along the ways of a place.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "oc_core/scene/mesh.h"

namespace ocelli {

/// Where one can walk: straight ways between places (x, z), on a floor at height 0.
struct WalkWays {
  std::vector<glm::dvec2> places;
  std::vector<std::vector<size_t>> neighbours;
  double halfWidth = 0.5;  ///< how far beside the ways walkers keep
};

struct WalkerState {
  glm::dvec2 place{0};  ///< x, z
  double heading = 0;   ///< radians about y; 0 looks towards +z
  double phase = 0;     ///< of the steps, radians
};

class Walkers {
 public:
  /// `count` walkers of other looks, speeds and ways, by the seed.
  Walkers(const WalkWays& ways, size_t count, double seconds, uint64_t seed);

  size_t count() const { return walks_.size(); }
  WalkerState at(size_t walker, double seconds) const;
  /// All of them at a time, in world coordinates. `walkerOfTriangle` has their indices.
  Mesh meshAt(double seconds, std::vector<uint8_t>& walkerOfTriangle) const;

 private:
  struct Walk {
    double speed = 1;  ///< metres a second
    glm::dvec2 beside{0};
    double height = 1.75;
    std::vector<glm::dvec2> points;
    std::vector<double> lengths;  ///< from the beginning to each point
    glm::vec3 shirt{1};
    glm::vec3 trousers{1};
  };

  glm::dvec2 placeAlong(const Walk& walk, double length) const;
  std::vector<Walk> walks_;
};

}  // namespace ocelli
