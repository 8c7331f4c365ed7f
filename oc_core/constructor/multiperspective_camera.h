// A camera of the graph camera family (chapter 4), which draws several perspectives into one image.
#pragma once

#include <variant>

#include "oc_core/camera/curved_ray_camera.h"
#include "oc_core/camera/graph_camera.h"

namespace ocelli {

using MultiperspectiveCamera = std::variant<GraphCamera, CurvedRayCamera>;

}  // namespace ocelli
