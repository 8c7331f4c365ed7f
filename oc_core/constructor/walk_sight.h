// What the rays of a comprehensive camera really meet, by casting some of them: a walk map knows boxes and openings,
// not the furniture, trees and open doors that stand in them. Slow reference: all pixels of the image cast, and those
// counted that show the middle of a cell (bench/walk_acceptance.h).
#pragma once

#include <cstddef>
#include <vector>

#include "oc_core/camera/graph_camera.h"
#include "oc_core/constructor/walk_region.h"
#include "oc_core/render/raycast.h"
#include "oc_core/scene/walk_map.h"

namespace ocelli {

class WalkSight {
 public:
  /// The scene must outlive it, and have the units of the walk map.
  explicit WalkSight(const RayScene& scene) : scene_(scene) {}

  /// Of the rays of `frustum` that would pass the mouth, the share that nothing stops between where they enter frustum
  /// `first`, which is `frustum` or comes before it, and the mouth. 0 where there are no such rays.
  double throughShare(const GraphCamera& camera, int first, int frustum, const WalkMouth& mouth) const;

  /// Square pixels of the frustum whose rays meet the middle of the cell's floor (middleOf()), or what lies on it up to
  /// a tenth of the cell's height: rugs and kerbs. Where there are few pixels, how many.
  double pixelsOfMiddle(const GraphCamera& camera, int frustum, const WalkCell& cell) const {
    return pixelsOfMiddle(camera, GraphCamera::kRoot, frustum, cell);
  }
  /// The same where rays meet nothing before they enter frustum `first`, which is `frustum` or comes before it.
  double pixelsOfMiddle(const GraphCamera& camera, int first, int frustum, const WalkCell& cell) const;

  struct Middle {
    double pixels = 0;  ///< whose rays meet the middle
    /// The frustum in which most of the rays end that lead to it and do not meet it; -1 where there are none.
    int stoppedIn = -1;
  };
  /// Of these frusta, pixel by pixel where an image of the middle takes up to 4096 of them: for cells of which few are
  /// seen.
  Middle count(const GraphCamera& camera, const WalkCell& cell, const std::vector<int>& frusta) const;

 private:
  const RayScene& scene_;
};

/// The middle of a cell, whose pixels count: the corners of the square on its floor, half as wide as its shorter side,
/// that lies around its centre.
std::vector<glm::dvec3> middleOf(const WalkCell& cell);

/// Whether a point lies over that middle, within `height` of the floor.
bool isOverMiddle(const WalkCell& cell, const glm::vec3& point, float height);

}  // namespace ocelli
