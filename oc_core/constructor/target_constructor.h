// Target tracking (section 4.3.1.3): a curved ray camera that keeps an object in sight: its rays bend around what
// stands before it.
//
// One number f, from -1 to 1, says how far rays bend: all the way to the left at -1, to the right at 1, and not at all
// at 0. The second viewpoint stands beside the eye, on the other side, at |f| times half the distance to the target;
// rays begin to bend half way to the target and have done so before it.
//
// Whether the target is in sight is decided by boxes, in one of the ways of target_sight.h.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "oc_core/camera/curved_ray_camera.h"
#include "oc_core/constructor/target_sight.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {

class JsonFields;

struct TargetOptions {
  std::optional<Box> box;      ///< of the target; the scene's where missing
  std::vector<Box> occluders;  ///< where empty those of all objects but the target; structure hides nothing
  double f = 0;                ///< where the search begins
  double maxF = 1;             ///< the strongest bend, to either side
  std::string sight = "rays";  ///< one of targetSights()
  double visibleShare = 0.5;   ///< of the target, for it to be in sight; where images decide, 1 is the text's test
  double enlarged = 0.1;       ///< by so much its box is larger on each side, in shares of its size
  double enlargedPixels = 0;   ///< and by so many pixels of the image (TargetMargin)
  double maxChange = 0.05;     ///< of f from one frame to the next
};

/// The camera bent by f; a pinhole where f is 0, or the target not well before zNear.
CurvedRayCamera bentCamera(const PinholeCamera& view, const Box& target, double f);

/// Follows a target from frame to frame. f is all that it remembers, so view, target and occluders may all move.
class TargetTracker {
 public:
  explicit TargetTracker(const TargetOptions& options) : options_(options), f_(options.f) {}

  double f() const { return f_; }
  /// Moves f, by at most maxChange, towards the value that shows the target: 0 where that does, else f as it is, else
  /// the nearest that does, else 0. A target behind the eye, or around it, is one that nothing shows; none of the boxes
  /// may be the target's.
  CurvedRayCamera update(const PinholeCamera& view, std::span<const Box> occluders, const Box& target);

  /// The value that update() moves f towards.
  double wanted(const PinholeCamera& view, std::span<const Box> occluders, const Box& target) const;

 private:
  TargetOptions options_;
  double f_;
};

/// The camera for a single image: f is what update() would move to. Throws InputError where there is no target, and
/// where the eye is in its box, or does not have it in front.
CurvedRayCamera buildTargetCamera(const TargetOptions& options, const GuidedScene& scene,
                                  const PinholeCamera& reference);

/// Boxes of all objects of the scene but structure and the target of the guides.
std::vector<Box> occluderBoxes(const GuidedScene& scene);

/// Throws InputError naming the field.
TargetOptions readTargetOptions(JsonFields& fields);

}  // namespace ocelli
