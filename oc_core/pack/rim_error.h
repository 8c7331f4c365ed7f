// How far the rims of coarser triangles are off. A rim that is cut short is no farther from the surface than it was
// where the surface is flat; so rims are measured against rims.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "oc_core/pack/open_edges.h"

namespace ocelli {

/// Rims that hang together, in a finer and in a coarser form.
class RimErrors {
 public:
  /// `fine`, `coarse`: open edges between `positions`; coarser ones join places of finer ones. All must outlive this.
  RimErrors(std::span<const glm::vec3> positions, std::span<const OpenEdge> fine, std::span<const OpenEdge> coarse);

  /// Of a place of the finer rims: how far it lies from what has become of its rim; where nothing has, as a hole was
  /// closed, the radius of that. 0 of other places.
  float errorAt(uint32_t place) const;

 private:
  struct Rim {
    std::vector<OpenEdge> coarse;
    float radius = 0;  ///< of the finer one
  };
  static constexpr uint32_t kNone = 0xffffffffu;

  std::span<const glm::vec3> positions_;
  std::vector<uint32_t> rimOf_;  ///< of each place
  std::vector<Rim> rims_;
};

}  // namespace ocelli
