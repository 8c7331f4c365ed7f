// The clusters of a packed scene (oc_core/pack) that stand for it near a viewpoint: what lies inside the frustum, as
// coarse as nobody there can tell.
#pragma once

#include <vector>

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/pack/cluster_cut.h"

namespace ocelli {

/// How far a surface may be off in an image that is made of a packed scene, pixels. Twice as much moves edges that a
/// DDOC finds, and with them 1 to 10 % of its samples (docs/results.md, over packed scenes).
inline constexpr float kPackedErrorPixels = 0.25f;

struct ViewCutOptions {
  /// How far a surface may be off in the image, pixels.
  float maxErrorPixels = kPackedErrorPixels;
  /// Around the image: how far a camera displaces what a pinhole sees, pixels.
  float marginPixels = 0;
  /// The viewpoints lie within this distance of the eye, world units.
  float reach = 0;
  /// Whether rays go anywhere, and not into the image alone: then nothing is left out, and the margin has no meaning.
  bool allAround = false;
};

/// For pinholes with the view direction and the image of `camera`, and for cameras that displace their samples.
std::vector<ClusterChoice> viewCut(const PackedScene& scene, const PinholeCamera& camera,
                                   const ViewCutOptions& options = {});

}  // namespace ocelli
