// Splats of the DDOC's construction, steps 3 to 6 (section 3.2.2): each depth edge claims the pixels around it,
// conflicts shrink the claims, and the remaining claims become the distortion map.
#pragma once

#include <vector>

#include "oc_core/camera/distortion_map.h"
#include "oc_core/ocri/depth_edges.h"

namespace ocelli {

/// What one depth edge does to the pixels around it. With x the signed distance from the edge, positive towards the
/// background, the band [-hidden, room] is squeezed into [0, room]: the hidden part comes out from behind the occluder,
/// and the visible part makes space for it.
struct DistortionSplat {
  DepthEdge edge;
  float hidden = 0;  ///< how far behind the occluder samples are fetched from, pixels
  float room = 0;    ///< how far in front of the background samples are moved closer together, pixels

  float reach() const { return hidden > room ? hidden : room; }
  /// Step 6: the displacement along the normal, pixels. For hidden = room = r it is the text's (r - x) / 2.
  float displacementAt(float x) const { return hidden > 0 ? (room - x) * hidden / (hidden + room) : 0.0f; }
};

/// Index of the splat that each pixel belongs to, -1 where there is none.
using SplatOwners = Image<int>;

/// Step 3: every pixel goes to the splat with the closest centre among those that reach it.
SplatOwners claimPixels(const std::vector<DistortionSplat>& splats, int width, int height);

/// Step 4: which splats with normals more than 90 degrees apart are in conflict where their pixels touch.
enum class Conflicts {
  kAll,     ///< as in the text
  kFacing,  ///< those that compete for visible room; splats back to back, behind a thin occluder, just share its hidden
            ///< side
};

/// Shrinks the rooms of splats in conflict until they no longer overlap. `hidden` follows, so that
/// `hidden <= maxHiddenPerRoom * room`. Returns how many splats shrank.
size_t shrinkConflicts(std::vector<DistortionSplat>& splats, const SplatOwners& owners, Conflicts conflicts,
                       float maxHiddenPerRoom);

/// Makes the bands change gradually along the silhouettes: hidden and room grow by at most `steepestGrowth` pixels for
/// each pixel between two splats; 0 leaves them as they are.
void limitBandGrowth(std::vector<DistortionSplat>& splats, float steepestGrowth);

/// Steps 5 and 6: the map of the displacements. Pixels out of their splat's band get none.
DistortionMap finalizeMap(const std::vector<DistortionSplat>& splats, const SplatOwners& owners,
                          DistortionMap::Lookup lookup);

/// Makes the field continuous: displacements are averaged with a Gaussian over all pixels, depth intervals over the
/// pixels that have one.
DistortionMap smoothMap(const DistortionMap& map, float sigmaPixels);

}  // namespace ocelli
