// When an acceleration structure whose boxes followed moving triangles has become so bad that it is built anew.
//
// The expected cost of a ray grows with the areas of the boxes that it may meet, in relation to the box around
// everything (the surface area heuristic: J. Goldsmith and J. Salmon, Automatic creation of object hierarchies for ray
// tracing, 1987). What is measured here are boxes around small groups of triangles that were neighbours when the
// structure was built: while these stay neighbours, it stays as good as it was, however far they move; where they
// part, the boxes of the structure grow as those of the groups do.
#pragma once

#include <cstdint>
#include <vector>

#include "oc_core/scene/mesh.h"

namespace ocelli {

class RefitQuality {
 public:
  /// Built anew from here on: twice the cost of a new structure.
  static constexpr double kMaxRatio = 2;

  /// Groups the triangles as they stand now. The mesh must outlive it, and have the same triangles.
  explicit RefitQuality(const Mesh& mesh);

  /// The mean area of the boxes of the groups, as a share of the area of the box around the mesh, now and in relation
  /// to that at the begin. 1 where the mesh is empty. Looks at a part of the triangles: the same ones each time.
  double ratio() const;

 private:
  double meanShare() const;

  const Mesh* mesh_;
  std::vector<uint32_t> triangles_;  ///< kGroup of each group that is looked at, one group after the other
  double atBegin_ = 0;
};

}  // namespace ocelli
