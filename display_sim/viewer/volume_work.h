// The pictures of the volume pane, on a thread of their own.
#pragma once

#include "display_sim/viewer/moving_pictures.h"
#include "display_sim/viewer/picture_pane.h"
#include "display_sim/viewer/volume_painter.h"

namespace ocelli {

using VolumePicture = MovingPicture<VolumeWanted>;
using VolumeStatus = MovingPictureStatus<VolumeWanted>;
using VolumeWork = MovingPictures<VolumeWanted, VolumePainter>;
using VolumePane = PicturePane<VolumeWanted>;

}  // namespace ocelli
