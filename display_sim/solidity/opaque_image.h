// The image that a solid scene would give: its surfaces opaque, seen by the observer's eye at the observer's size.
#pragma once

#include "display_sim/observing/observer.h"
#include "oc_core/image/png_file.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// On black, each pixel the mean of 2x2 samples. Of `options` counts what says where the eye is and what its image
/// holds.
Image<Rgb8> opaqueImage(const Mesh& scene, const ObserverOptions& options);

}  // namespace ocelli
