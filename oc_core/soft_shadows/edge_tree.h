// A hierarchy of bounds over edges of occluders: which of them can change what points of a box see of a light.
//
// Edges are sorted along a curve that fills space, and nodes are groups of neighbours on it: that is made in the time
// of a sort, needs no pointers, and takes any edges. A node knows the box of its edges and, of folds, a cone around the
// normals of their triangles: where all points of a box of receivers are on one side of all of these, no fold is seen
// as an outline.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "oc_core/soft_shadows/light_shaft.h"
#include "oc_core/soft_shadows/occluder_edges.h"

namespace ocelli {

class EdgeTree {
 public:
  /// Sorts `edges`. Their planes are `planes`; both must outlive it.
  EdgeTree(std::vector<OccluderEdge>& edges, const std::vector<glm::vec4>& planes);

  /// Appends the edges that can come over the light, and change their weight or have one, for points of the box of
  /// receivers: all that do, and a few more. Returns how many nodes and edges were looked at.
  uint64_t find(const LightShaft& shaft, std::vector<const OccluderEdge*>& found) const;

 private:
  static constexpr size_t kEdgesALeaf = 8;
  static constexpr size_t kChildren = 4;

  struct Node {
    glm::vec3 lower{0};
    glm::vec3 upper{0};
    glm::vec3 axis{0};  ///< of the cone of normals, up to sign
    float sine = 1;     ///< of half its angle; 1: they lie anywhere
    float cosine = 0;
  };

  Node leafOf(size_t first, size_t end) const;
  Node over(size_t level, size_t first, size_t end) const;
  static bool isOneSided(const Node& node, const Box& receivers);
  uint64_t visit(size_t level, size_t index, const LightShaft& shaft, std::vector<const OccluderEdge*>& found) const;

  const std::vector<OccluderEdge>& edges_;
  const std::vector<glm::vec4>& planes_;
  std::vector<std::vector<Node>> levels_;  ///< from the leaves up
};

}  // namespace ocelli
