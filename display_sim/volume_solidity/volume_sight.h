// What eyes would see of a volume that absorbs light, which one on a display that emits does not: how far they see into
// it.
//
// For each eye there is an image of depths, as large as the display has rows: how far along a pixel's ray the opacity
// of what lies before first reaches a threshold (oc_core/volume_render). This is the depth image of the volume, the
// reference image of an occlusion camera of one viewpoint, and what lies behind it is hidden. A place within a voxel
// and a half of it cannot be told from it on the display, and counts as seen; so does one that a neighbouring pixel
// sees, as rims would have holes else.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/image/image.h"
#include "oc_core/volume_render/volume_renderer.h"

namespace ocelli {

class VolumeSight {
 public:
  /// The threshold is the renderer's depthOpacity. The caller must have checked that eyes lie outside of the unit
  /// sphere, and look at its centre; `side` is that of the square images, pixels.
  VolumeSight(const VolumeRenderer& renderer, const std::vector<glm::vec3>& eyes, int side,
              const Progress& progress = {});

  /// Whether one of the eyes sees the place of a cell with this longest side.
  bool sees(const glm::dvec3& point, double cellSide) const;

 private:
  struct Eye {
    PinholeCamera camera;
    Image<float> depths;  ///< along the view direction
  };
  std::vector<Eye> eyes_;
};

}  // namespace ocelli
