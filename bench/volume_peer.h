// Other people's volume renderers, for volume_bench. Each is there where its library was found.
#pragma once

#include <functional>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/image/image.h"
#include "oc_core/volume/volume_scene.h"

namespace ocelli {

struct VolumePeer {
  using Picture = std::function<Image<glm::vec4>(const PinholeCamera&)>;

  std::string name;
  /// What is made once for a scene; then what is made for a step, in mean distances of voxels; then an image: linear
  /// RGB and opacity. The scene must outlive it.
  std::function<std::function<Picture(double step)>(const VolumeScene&)> prepare;
};

/// Empty where volume_bench was built without VTK.
std::vector<VolumePeer> volumePeers();

}  // namespace ocelli
