// The parameters of a camera, as a form.
#pragma once

#include "oc_core/ocri/camera_choice.h"

namespace ocelli {

/// Shows those that the model has; `labelWidth` is the width of the values. True where one was changed.
bool drawCameraForm(CameraChoice& camera, float valueWidth);

}  // namespace ocelli
