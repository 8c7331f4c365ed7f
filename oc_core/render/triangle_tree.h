// A bounding volume hierarchy of the triangles of a mesh, as simple as it can be: what rays are cast with where the
// toolkit is built without Embree, and what tests compare Embree with.
//
// Nodes are split at the median of their longest side. Intersections are signed volumes in double precision: triangles
// that share an edge get the same number with the other sign, so no ray passes between them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "oc_core/scene/box.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

class TriangleTree {
 public:
  /// The mesh must outlive it.
  explicit TriangleTree(const Mesh& mesh);

  /// The vertices of the mesh stand elsewhere now; its triangles are the same. Boxes follow from the leaves up; nodes
  /// keep their triangles.
  void refit();

  struct Meeting {
    uint32_t triangle = 0;
    double share = 0;  ///< of the way from the origin, 1 being `origin + step`
    float b1 = 0;      ///< barycentric weights of the second and third vertex
    float b2 = 0;
  };
  /// The first triangle on the way from `origin` to `origin + step * reach`, seen from either side; of triangles that
  /// are met at the same distance the one with the lowest index.
  std::optional<Meeting> meet(const glm::vec3& origin, const glm::vec3& step, double reach) const;

  struct Nearest {
    uint32_t triangle = 0;
    glm::vec3 position{0};
  };
  /// The closest point of the mesh within `reach` of `point`; of triangles that are equally close the first.
  std::optional<Nearest> nearest(const glm::vec3& point, float reach) const;

  /// Around all triangles.
  Box bounds() const { return nodes_.empty() ? Box{} : nodes_.front().box; }

 private:
  /// A leaf holds triangles, another node has its first child right behind it.
  struct Node {
    Box box;
    uint32_t begin = 0;  ///< of a leaf, in order_
    uint32_t count = 0;  ///< 0: no leaf
    uint32_t second = 0;
  };

  void build(std::vector<glm::vec3>& centers, uint32_t begin, uint32_t end);

  const Mesh& mesh_;
  std::vector<uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace ocelli
