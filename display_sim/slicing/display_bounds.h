// Whether a scene fits into the space that a display shows.
#pragma once

#include "display_sim/frames/display_profile.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// What lies outside of the display's cylinder is cut off by the slicer. Turning about the axis changes nothing.
bool liesWithin(const Mesh& mesh, const DisplayProfile& profile);

}  // namespace ocelli
