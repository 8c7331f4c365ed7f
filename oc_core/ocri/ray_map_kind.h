// The camera of a ray map (oc_core/camera/ray_map.h): what `--camera RAYS.exr` names. Its image is cast along the rays,
// and keeps where each sample is.
//
// It is no row of representationKinds(): it has no name of its own, and nothing can be built without its rays.
#pragma once

#include <memory>

#include "oc_core/camera/ray_map.h"
#include "oc_core/ocri/camera_choice.h"

namespace ocelli {

/// The image has the size of the reference, and the camera stands at its view where the map's frame is the view's.
CameraChoice rayMapChoice(std::shared_ptr<const RayMap> map);

}  // namespace ocelli
