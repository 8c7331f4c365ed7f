// What reference images show of a scene, compared whatever their cameras do with samples.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "oc_core/ocri/reference_image.h"

namespace ocelli::test {

/// The distance from the reference's eye at each pixel of the reference that any of the images shows, 0 elsewhere.
/// Cameras put samples elsewhere when an edge moves by a pixel, and images become wider or higher; the reference sees
/// the same.
inline Image<float> seenByReference(const ReferenceImages& images, const PinholeCamera& view) {
  Image<float> seen(view.width(), view.height(), 0);
  for (const ReferenceImage& image : images) {
    const PinholeCamera own = image.reference();
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        const std::optional<glm::vec3> point = image.pointOf(x, y, own);
        const std::optional<ImagePoint> at = point ? view.project(*point) : std::nullopt;
        if (at && at->u >= 0 && at->v >= 0 && at->u < static_cast<float>(view.width()) &&
            at->v < static_cast<float>(view.height())) {
          float& t = seen(static_cast<int>(at->u), static_cast<int>(at->v));
          t = t == 0 ? at->t : std::min(t, at->t);
        }
      }
    }
  }
  return seen;
}

inline size_t samplesOf(const ReferenceImages& images) {
  size_t samples = 0;
  for (const ReferenceImage& image : images) {
    samples += image.sampleCount();
  }
  return samples;
}

/// The share of the reference's pixels that one of the two lacks, or that show something a hundredth nearer or farther.
inline double otherShare(const ReferenceImages& wanted, const ReferenceImages& got, const PinholeCamera& view) {
  const Image<float> a = seenByReference(wanted, view);
  const Image<float> b = seenByReference(got, view);
  size_t covered = 0;
  size_t others = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    covered += a[i] > 0 ? 1 : 0;
    others += (a[i] > 0) != (b[i] > 0) || std::abs(a[i] - b[i]) > 0.01f * a[i] ? 1 : 0;
  }
  return static_cast<double>(others) / static_cast<double>(covered);
}

}  // namespace ocelli::test
