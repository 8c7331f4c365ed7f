// The opaque truth of a volume (display_sim/solidity/solid_reference.h): its image with emission and absorption, and
// hidden what lies behind the opacity that its renderer's threshold asks for (volume_sight.h).
#pragma once

#include <memory>

#include "display_sim/solidity/solid_reference.h"
#include "oc_core/volume_render/volume_renderer.h"

namespace ocelli {

/// The renderer must outlive it, and stay as it is.
std::unique_ptr<SolidReference> solidVolume(const VolumeRenderer& renderer);

}  // namespace ocelli
