// A small volume that tests know by heart.
#pragma once

#include "oc_core/volume/volume_scene.h"

namespace ocelli::test {

/// 33 x 33 x 33 voxels over the cube from -1 to 1; the field is 1 minus the distance from the middle. What is nearer to
/// the middle than `radius` is as good as opaque and red, all else is transparent. Not fitted: the cube is the scene.
VolumeScene ballVolume(double radius = 0.5);

}  // namespace ocelli::test
