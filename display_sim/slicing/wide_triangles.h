// The triangles that need more samples than their corners, and which: a loop like those of slicer_kernels.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "display_sim/slicing/slicer_kernels.h"

namespace ocelli {

/// The triangles of a chunk that may need more than their corners.
struct WideTriangles {
  static constexpr int32_t kFoundExactly = -1;
  static constexpr int32_t kCornersSuffice = -2;

  explicit WideTriangles(size_t most);
  size_t count = 0;
  std::vector<uint16_t> number;  ///< of the triangle, in its chunk
  std::vector<SweepPoint> corners[3];
  std::vector<int32_t> pattern;  ///< of TriangleStrips, or one of the constants
  std::vector<int32_t> order;    ///< of the corners, for the pattern
};

/// `corners` are as in SliceMesh, their vertices the points'.
void findWideTriangles(const SliceKernelSetup& setup, const SweepPoint* points, const uint16_t* corners,
                       size_t triangles, WideTriangles& wide);

}  // namespace ocelli
