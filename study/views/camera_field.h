// The camera of a view, in a protocol.
#pragma once

#include "oc_core/ocri/camera_choice.h"

namespace ocelli {

/// The field "camera": a name that cameraChoice() knows, or an object as oc_core/ocri/camera.schema.json has it. Throws
/// InputError naming the field.
CameraChoice readCameraField(JsonFields& fields, const ViewCell& cell = {});

}  // namespace ocelli
