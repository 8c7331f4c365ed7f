// Why an image shows nothing of a scene, and what to do.
#pragma once

#include <string>

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// Throws InputError at `where`: the scene lies outside of the view, is seen edge-on, or is smaller than a pixel.
[[noreturn]] void failSeeingNothing(const PinholeCamera& reference, const Mesh& mesh, const std::string& where);

}  // namespace ocelli
