// Poses of MPEG immersive video: x forward, y to the left, z up, metres. Rotations are yaw, pitch and roll in degrees:
// R = Rz(yaw) Ry(pitch) Rx(roll) takes what the camera sees to the world; a positive pitch looks down.
//
// Our world (y up, looking along -z) stands there as x = -z, y = -x, z = y.
#pragma once

#include <array>

#include "oc_core/camera/pinhole_camera.h"

namespace ocelli {

struct MivPose {
  std::array<double, 3> position{};  ///< metres
  std::array<double, 3> rotation{};  ///< yaw, pitch, roll; degrees
};

MivPose mivPose(const PinholeCamera& camera, double unitsPerMetre);

/// The eye, and a target one metre away along the view direction; `up` is that of the camera. The rest is `otherwise`.
View viewOfMivPose(const MivPose& pose, double unitsPerMetre, const View& otherwise);

}  // namespace ocelli
