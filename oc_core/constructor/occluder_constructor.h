// The occluder-based constructor (section 4.3.1.2): a graph camera whose rays part before a box, run along both of its
// sides and come together behind it, so that one sees its sides and what it hides.
//
// The split (Figure 4.6) is where the ray to the middle of the box enters it, so that the box hides the split line; but
// above and below the box it shows. Beyond the split each half has a viewpoint of its own, moved to its side so far
// that the rays which graze the back of the box meet behind it. There both are merged into one viewpoint. Rays
// that would cross to the other side before that end in the middle: so nothing is seen twice, and only a wedge behind
// the box stays hidden. A box should be tight: where rays pass between the object and its box they end, too.
#pragma once

#include <optional>

#include "oc_core/camera/graph_camera.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {

class JsonFields;

struct OccluderOptions {
  std::optional<Box> box;
  int object = 0;     ///< the identity of the object whose box it is, where no box is given
  double shadow = 1;  ///< the length of what stays hidden behind the box, in its widths as seen
  /// Where rays part, forward from the eye: on the object's surface, where its box is not tight. Nothing: where the ray
  /// to the middle of the box enters it.
  std::optional<double> splitDepth{};
  /// By which share of the way its viewpoints have moved: 0 is the pinhole.
  double deployed = 1;
  /// Whether rays that run on behind the box depend on where the eye is alone, and not on the direction of the view, so
  /// that none moves when the head turns. Otherwise the outermost rays of the image run on as they do in the pinhole's.
  bool steady = false;
};

/// Throws InputError where there is no such object; where the eye is in the box, the box is behind the eye or not in
/// view; and where GraphCamera does.
GraphCamera buildOccluderCamera(const OccluderOptions& options, const GuidedScene& scene,
                                const PinholeCamera& reference);

/// Throws InputError naming the field.
OccluderOptions readOccluderOptions(JsonFields& fields);

}  // namespace ocelli
