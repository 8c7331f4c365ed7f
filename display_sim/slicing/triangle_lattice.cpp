#include "display_sim/slicing/triangle_lattice.h"

#include "display_sim/slicing/slice_mesh.h"

namespace ocelli {

TriangleLattices::TriangleLattices() : ranges_((kMaxParts + 1) * 8) {
  for (int parts = 2; parts <= kMaxParts; ++parts) {
    for (unsigned left = 0; left < 8; ++left) {
      Range& range = ranges_[static_cast<unsigned>(parts) * 8 + left];
      range.first = static_cast<uint32_t>(weights2_.size());
      for (int second = 0; second <= parts; ++second) {
        for (int third = 0; second + third <= parts; ++third) {
          const int first = parts - second - third;
          const bool corner = first == parts || second == parts || third == parts;
          const bool leftOut =
              (third == 0 && (left & 1u) != 0) || (first == 0 && (left & 2u) != 0) || (second == 0 && (left & 4u) != 0);
          if (!corner && !leftOut) {
            weights1_.push_back(static_cast<float>(first) / static_cast<float>(parts));
            weights2_.push_back(static_cast<float>(second) / static_cast<float>(parts));
            weights3_.push_back(static_cast<float>(third) / static_cast<float>(parts));
          }
        }
      }
      range.count = static_cast<uint32_t>(weights2_.size()) - range.first;
    }
  }
  weights1_.resize(weights1_.size() + SliceMesh::kPadding);
  weights2_.resize(weights2_.size() + SliceMesh::kPadding);
  weights3_.resize(weights3_.size() + SliceMesh::kPadding);
}

}  // namespace ocelli
