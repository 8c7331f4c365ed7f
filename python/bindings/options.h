// What Python gives for a camera: options, which are keywords there and the JSON of a camera's file here, or rays.
#pragma once

#include <memory>
#include <string>
#include <variant>

#include "oc_core/camera/ray_map.h"
#include "oc_core/ocri/camera_choice.h"

namespace ocelli {

/// What stands for such a file in messages.
inline constexpr const char* kCameraOptions = "options of the camera";

/// Options as JSON, or a ray map.
using CameraArgument = std::variant<std::string, std::shared_ptr<RayMap>>;

/// Throws InputError as cameraChoice() does for a file.
CameraChoice cameraChoiceOf(const CameraArgument& camera, const ViewCell& cell = {});

}  // namespace ocelli
