// Path previewing (section 4.3.1.5): a curved ray camera that travels along a path and shows what is behind its next
// turns: its rays follow the path, as if that were straight.
//
// Control points stand at even distances along the path. At each of those ahead, up to the preview length, rays turn
// from the way they came to that towards the next control point: the viewpoint turns about the control point, and the
// planes of the transition meet on the inside of the turn, just beside the outermost ray. Turns unfold over the last
// two stretches between control points of the preview, and collapse over the first two, while the view itself turns
// from one control point to the next: so images change smoothly as the position advances. Corners of the path are
// rounded, as the view would turn at once where it passes one: on four paths no step changes the image more than the
// pinhole's largest one does (tests/constructor/path_travel_test.cpp).
//
// A turn that rays of this width cannot make (they would meet the planes of the one before, or not meet its own) is as
// strong as it can be made, which may be not at all.
#pragma once

#include <vector>

#include "oc_core/camera/curved_ray_camera.h"
#include "oc_core/scene/scene_guides.h"

namespace ocelli {

class JsonFields;

/// Lengths are shares of the path's length.
struct PathOptions {
  std::vector<glm::vec3> path;  ///< where empty, that of the scene
  double position = 0;          ///< of the eye
  double preview = 0.3;         ///< how far ahead rays follow the path
  int turns = 4;                ///< control points within the preview; of fewer than 4 none is ever bent in full
  double eyeHeight = 0;         ///< over the path, along "up" of the reference view; in the world
  double rounding = 1;  ///< a point of the path is its mean over so many distances of control points; 0 keeps corners
  double deployed = 1;  ///< share by which its turns are unfolded: 0 is the pinhole
};

/// What travels: the pinhole at the position, which looks along the path, as wide as the reference and with its "up".
/// Throws InputError where there is no path, or its length is 0 or not finite.
PinholeCamera pathPinhole(const PathOptions& options, const SceneGuides& guides, const PinholeCamera& reference);

/// Throws as pathPinhole().
CurvedRayCamera buildPathCamera(const PathOptions& options, const SceneGuides& guides, const PinholeCamera& reference);

/// Throws InputError naming the field.
PathOptions readPathOptions(JsonFields& fields);

}  // namespace ocelli
