// Options of cameras, which Python gives as keywords and the C++ side takes as the JSON of a camera's file.
#pragma once

#include <string>

#include "oc_core/ocri/camera_choice.h"

namespace ocelli {

/// What stands for such a file in messages.
inline constexpr const char* kCameraOptions = "options of the camera";

/// Throws InputError as cameraChoice() does for a file.
CameraChoice cameraChoiceFromJson(const std::string& json, const ViewCell& cell = {});

}  // namespace ocelli
