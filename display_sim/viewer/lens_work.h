// The pictures of the lens pane, on a thread of their own.
#pragma once

#include "display_sim/viewer/lens_painter.h"
#include "display_sim/viewer/moving_pictures.h"

namespace ocelli {

using LensPicture = MovingPicture<LensWanted>;
using LensStatus = MovingPictureStatus<LensWanted>;
using LensWork = MovingPictures<LensWanted, LensPainter>;

}  // namespace ocelli
