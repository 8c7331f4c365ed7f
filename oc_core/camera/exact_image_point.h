// Image points in double precision, for cameras whose rays bend: errors grow from bend to bend.
#pragma once

#include <optional>

#include "oc_core/camera/camera.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/camera/plane.h"

namespace ocelli {

/// As ImagePoint: u and v in pixels from the top left corner, t as the camera measures it.
struct ExactImagePoint {
  double u = 0;
  double v = 0;
  double t = 0;
};

/// What rounding of world points to single precision amounts to, in the image of a camera that holds them.
inline constexpr double kSinglePixelRounding = 1e-3;
inline constexpr double kSingleDepthRounding = 1e-6;

/// The projection of a pinhole: rows u, v, none and weight.
glm::dmat4 pixelFromWorld(const PinholeCamera& camera);

/// In single precision; nothing where that is not finite.
std::optional<ImagePoint> inSinglePrecision(const std::optional<ExactImagePoint>& q);

}  // namespace ocelli
