// The voxels of a volume as a 3-D texture: of one or two bytes where the volume's voxels have as many, of single
// precision else. Shaders read them by shaders/voxel_field.glsl, and interpolate as ScalarVolume::fieldAt() does.
#pragma once

#include <glm/vec3.hpp>

#include "oc_core/base/progress.h"
#include "oc_core/gl/gl_object.h"
#include "oc_core/volume/scalar_volume.h"

namespace ocelli {

class GlVoxelTexture {
 public:
  /// Uploads all voxels, and keeps none of them; the volume may go. Throws GlError where the volume has more voxels
  /// along an axis than this context's 3-D textures, or more bytes than it has room for. `progress` may throw. Hold a
  /// GlScope. The context must outlive it.
  GlVoxelTexture(GlContext& context, const ScalarVolume& volume, const Progress& progress = {});

  const GlObject& texture() const { return texture_; }
  const glm::ivec3& size() const { return size_; }
  /// What a voxel means is `scale()` times its texel plus `offset()`.
  double scale() const { return scale_; }
  double offset() const { return offset_; }
  /// Of the texture.
  size_t bytes() const { return bytes_; }

 private:
  GlObject texture_;
  glm::ivec3 size_;
  double scale_ = 1;
  double offset_ = 0;
  size_t bytes_ = 0;
};

}  // namespace ocelli
