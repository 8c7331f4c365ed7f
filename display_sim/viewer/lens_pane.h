// The picture of a camera with lenses, as it comes from the CPU; lens_overlays.h draws the lenses over it.
#pragma once

#include "display_sim/viewer/lens_work.h"
#include "display_sim/viewer/picture_pane.h"

namespace ocelli {

using LensPane = PicturePane<LensWanted>;

}  // namespace ocelli
