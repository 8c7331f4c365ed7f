// What becomes of the holes of a resampled view.
#pragma once

#include "oc_core/ocri/resample.h"

namespace ocelli {

/// Gives holes a colour that no surface has: magenta.
void markHoles(ResampledView& view);
/// Continues what lies around a hole into it, ring by ring: of that the farther part, up to 0.3 of the way (in 1/z) to
/// the nearest, as the nearer hid what the hole shows. They stay holes in what `hole` says.
void fillHoles(ResampledView& view);

}  // namespace ocelli
