// The outlines that a block of neighbouring receivers shares, projected onto the light for one of them after the other.
// For .cpp files.
#pragma once

#include <vector>

#include "oc_core/soft_shadows/edge_tree.h"
#include "oc_core/soft_shadows/light_cover.h"

namespace ocelli {

/// Edges as arrays of numbers, so that loops over them become vector instructions.
class OutlineBlock {
 public:
  /// `folds` and `rims` of `edges` that the block shares. `receivers` is their box, in the frame of the light.
  void take(const std::vector<const OccluderEdge*>& shared, const std::vector<glm::vec4>& planes, const Box& receivers);
  bool empty() const { return edges_.empty(); }
  size_t size() const { return edges_.size(); }

  struct Projected {
    size_t edges = 0;  ///< that came over the light
    /// The sum over them of what they are off by on the light, of its mean side; each at most 1.
    float shift = 0;
  };
  /// Adds those that come over the light, as `receiver` sees them, to `cover`. They are off by `shiftPerDistance` of
  /// their distance from the light, of the light's mean side, before projection enlarges that.
  Projected project(const glm::vec3& receiver, const LightGrid& grid, const std::vector<glm::vec4>& planes,
                    float shiftPerDistance, LightCover& cover);

 private:
  struct Ends {
    std::vector<float> x, y, z;
    void clear();
    void push(const glm::vec3& p);
  };

  void projectCut(uint32_t i, const glm::vec3& receiver, const glm::vec2& middle, const glm::vec2& scale,
                  float nearest);
  size_t overLight(float rows);

  std::vector<const OccluderEdge*> edges_;
  Ends a_;
  Ends b_;
  std::vector<int8_t> weight_;            ///< of edges whose weight is the same for all receivers; kVaries for others
  std::vector<uint32_t> cut_;             ///< edges that may reach behind the plane of a receiver
  std::vector<float> ax_, ay_, bx_, by_;  ///< projected, grid coordinates
  std::vector<int32_t> isOver_;
  std::vector<uint32_t> over_;
  static constexpr int8_t kVaries = 127;
};

}  // namespace ocelli
