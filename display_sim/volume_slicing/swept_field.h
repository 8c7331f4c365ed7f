// The field of a volume in single precision, sampled where the display has its voxels.
#pragma once

#include <algorithm>
#include <cstddef>
#include <glm/vec3.hpp>

#include "oc_core/volume/scalar_volume.h"

namespace ocelli {

/// Of voxels of one type: values, and the gradient along the index axes of what is interpolated.
template <class Voxel>
class SweptField {
 public:
  /// `volume` must outlive it, and `first` is its first voxel.
  SweptField(const ScalarVolume& volume, const Voxel* first)
      : first_(first),
        last_(volume.grid().size - 1),
        rowStride_(static_cast<size_t>(volume.grid().size.x)),
        layerStride_(rowStride_ * static_cast<size_t>(volume.grid().size.y)),
        scale_(static_cast<float>(volume.scale())),
        offset_(static_cast<float>(volume.offset())) {}

  /// The field at index coordinates; outside of the outermost centres that of the nearest point among them.
  float at(const glm::vec3& index) const { return valueOf(cornersAt(index)); }

  float at(const glm::vec3& index, glm::vec3& gradient) const {
    const Corners c = cornersAt(index);
    const auto across = [](float a, float b, float share) { return a + (b - a) * share; };
    gradient.x = scale_ * across(across(c.v[1] - c.v[0], c.v[3] - c.v[2], c.share.y),
                                 across(c.v[5] - c.v[4], c.v[7] - c.v[6], c.share.y), c.share.z);
    gradient.y = scale_ * across(across(c.v[2] - c.v[0], c.v[3] - c.v[1], c.share.x),
                                 across(c.v[6] - c.v[4], c.v[7] - c.v[5], c.share.x), c.share.z);
    gradient.z = scale_ * across(across(c.v[4] - c.v[0], c.v[5] - c.v[1], c.share.x),
                                 across(c.v[6] - c.v[2], c.v[7] - c.v[3], c.share.x), c.share.y);
    return valueOf(c);
  }

 private:
  struct Corners {
    float v[8];  ///< i fastest, then j, then k
    glm::vec3 share;
  };

  Corners cornersAt(const glm::vec3& index) const {
    Corners c;
    size_t low[3];
    size_t step[3];
    const size_t strides[3] = {1, rowStride_, layerStride_};
    for (int axis = 0; axis < 3; ++axis) {
      const float inside = std::clamp(index[axis], 0.0f, static_cast<float>(last_[axis]));
      const int lower = std::max(std::min(static_cast<int>(inside), last_[axis] - 1), 0);
      c.share[axis] = inside - static_cast<float>(lower);
      low[axis] = static_cast<size_t>(lower) * strides[axis];
      step[axis] = last_[axis] > 0 ? strides[axis] : 0;
    }
    const Voxel* at = first_ + low[0] + low[1] + low[2];
    for (size_t corner = 0; corner < 8; ++corner) {
      c.v[corner] =
          static_cast<float>(at[(corner & 1) * step[0] + (corner >> 1 & 1) * step[1] + (corner >> 2) * step[2]]);
    }
    return c;
  }

  float valueOf(const Corners& c) const {
    const auto mix = [](float a, float b, float share) { return a + (b - a) * share; };
    const float near = mix(mix(c.v[0], c.v[1], c.share.x), mix(c.v[2], c.v[3], c.share.x), c.share.y);
    const float far = mix(mix(c.v[4], c.v[5], c.share.x), mix(c.v[6], c.v[7], c.share.x), c.share.y);
    return scale_ * mix(near, far, c.share.z) + offset_;
  }

  const Voxel* first_;
  glm::ivec3 last_;
  size_t rowStride_;
  size_t layerStride_;
  float scale_;
  float offset_;
};

/// Calls `visitor` with the field of the type that the volume has.
template <class Visitor>
auto visitSweptField(const ScalarVolume& volume, Visitor&& visitor) {
  return visitVoxels(volume, [&]<class Voxel>(const Voxel* first) { return visitor(SweptField(volume, first)); });
}

}  // namespace ocelli
