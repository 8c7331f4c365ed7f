#include "oc_core/ocri/sample_pairs.h"

#include <cmath>

#include "oc_core/ocri/sample_join.h"

namespace ocelli {

void pairsByThemselves(const UndistortedRow& a, size_t firstA, const UndistortedRow& b, size_t firstB, size_t count,
                       float focalPixels, const ImageMeshOptions& options, int* said) {
  const float* const ua = a.u.data() + firstA;
  const float* const va = a.v.data() + firstA;
  const float* const ta = a.t.data() + firstA;
  const float* const ub = b.u.data() + firstB;
  const float* const vb = b.v.data() + firstB;
  const float* const tb = b.t.data() + firstB;
  const float longest = options.longestStepPixels;
  const float depthStep = options.depthStepFootprints;
  for (size_t i = 0; i < count; ++i) {
    const float du = ub[i] - ua[i];
    const float dv = vb[i] - va[i];
    const float distance = std::sqrt(du * du + dv * dv);
    const float footprint = (tb[i] < ta[i] ? tb[i] : ta[i]) / focalPixels;
    const float atLeast = distance < 1.0f ? 1.0f : distance;
    const float steps = kLongestScaledStep < atLeast ? kLongestScaledStep : atLeast;
    const int near = static_cast<int>(ta[i] > 0) & static_cast<int>(tb[i] > 0) & static_cast<int>(distance <= longest);
    const int joined = static_cast<int>(std::abs(ta[i] - tb[i]) <= depthStep * footprint * steps);
    said[i] = near * (kNeighboursDecide - joined);
  }
}

}  // namespace ocelli
