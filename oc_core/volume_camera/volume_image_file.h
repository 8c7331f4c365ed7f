// Pictures of volumes, and the EXR files that hold them.
//
// The file: OpenEXR, channels R G B A (linear, the colours multiplied by the opacity A), Z (the parameter of the ray
// where the opacity of what it has passed reaches the threshold; 0 where it does not), P.X P.Y P.Z (that place, in the
// world of the scene) and, in the text attribute "ocelli", JSON with the camera, its view and the threshold.
#pragma once

#include <filesystem>

#include "oc_core/volume_camera/volume_camera.h"
#include "oc_core/volume_render/volume_image.h"

namespace ocelli {

/// Before a background, linear RGB.
Image<glm::vec3> imageBefore(const glm::vec3& background, const VolumeImage& image);

/// Where each ray is opaque, in the world of the scene; 0 where it is nowhere (VolumePixel::opaqueT()). `image` is that
/// of the camera.
Image<glm::vec3> opaquePoints(const VolumeImage& image, const VolumeCamera& camera);

/// What a picture took and shows.
struct VolumeImageFacts {
  uint64_t samples = 0;    ///< places where the field was looked at
  uint64_t touched = 0;    ///< pixels whose ray passes places that are not transparent, or meets a surface
  uint64_t opaque = 0;     ///< pixels whose opacity reaches the threshold of depth
  double meanOpacity = 0;  ///< of all pixels
};
VolumeImageFacts factsOf(const VolumeImage& image);

/// Throws InputError for an image that shows nothing: where no ray passes the volume, and where all places that rays
/// pass are transparent.
[[noreturn]] void failShowingNothing(const VolumeCamera& camera, const VolumeScene& scene);

/// `image` is that of the camera. Throws WorkError where the file cannot be written.
void writeVolumeImage(const std::filesystem::path& path, const VolumeImage& image, const VolumeCamera& camera,
                      double depthOpacity);

}  // namespace ocelli
