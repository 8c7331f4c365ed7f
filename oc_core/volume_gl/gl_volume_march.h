// The shader that marches along rays (shaders/volume_march.comp): its variants, and the passes in which it runs. For
// .cpp files.
#pragma once

#include <map>

#include "oc_core/gl/gl_object.h"

namespace ocelli {

/// Where the shader has its rays from.
enum class VolumeRaysFrom {
  kList,     ///< shaders/listed_rays.glsl
  kPinhole,  ///< shaders/pinhole_rays.glsl
  kLenses,   ///< the same, of a general pinhole
};

/// What a variant of the shader is compiled for.
struct VolumeMarchKind {
  VolumeRaysFrom rays = VolumeRaysFrom::kList;
  bool isShaded = false;
  bool hasSurfaces = false;
  bool isFilteredByHardware = false;

  auto operator<=>(const VolumeMarchKind&) const = default;
};

/// Clips that the shader cuts the rays of a pinhole by; rays of more are listed.
inline constexpr int kMaxShaderClips = 8;

/// The numbers of a picture.
struct VolumeMarchNumbers {
  float step = 0;  ///< in the unit of length of pieces
  float endTransmittance = 0;
  float depthTransmittance = 0;
  /// An entry of the optical table is `entriesByTexel` times a texel plus `firstEntry`.
  float entriesByTexel = 1;
  float firstEntry = 0;
};

class GlVolumeMarch {
 public:
  /// The context must outlive it.
  explicit GlVolumeMarch(GlContext& context) : context_(&context) {}

  /// Rows of an image, of `width` pixels a row. `longest` bounds the length of their rays within the volume. What the
  /// variant reads is bound, and so are the images that it writes. Throws GlError where the driver refuses the shader,
  /// or fails. Hold a GlScope.
  void run(const VolumeMarchKind& kind, const VolumeMarchNumbers& numbers, int width, int firstRow, int endRow,
           double longest);

 private:
  const GlObject& programOf(const VolumeMarchKind& kind);

  GlContext* context_;
  std::map<VolumeMarchKind, GlObject> programs_;
};

}  // namespace ocelli
