// Pairs of neighbouring samples along rows and columns of a reference image, judged many at a time.
#pragma once

#include <cstddef>
#include <vector>

#include "oc_core/ocri/image_mesh.h"

namespace ocelli {

/// What two neighbouring samples say alone (samplesJoinByThemselves()).
inline constexpr int kApart = 0;
inline constexpr int kJoined = 1;
inline constexpr int kNeighboursDecide = 2;

/// A row of undistorted samples: z = 0 where there is none.
struct UndistortedRow {
  std::vector<float> u;
  std::vector<float> v;
  std::vector<float> t;

  explicit UndistortedRow(int width)
      : u(static_cast<size_t>(width)), v(static_cast<size_t>(width)), t(static_cast<size_t>(width)) {}
};

/// samplesJoinByThemselves() for `count` pairs of samples side by side, of a from `firstA` on with b from `firstB` on.
/// Loops without branches, several pairs at a time; a test compares it with one pair at a time.
void pairsByThemselves(const UndistortedRow& a, size_t firstA, const UndistortedRow& b, size_t firstB, size_t count,
                       float focalPixels, const ImageMeshOptions& options, int* said);

}  // namespace ocelli
