// Several viewers around a display that show a scene together: reference images for each, and one mesh for all. What
// the mesh of earlier viewers shows already is left out of the images of later ones (image-set-difference, section
// 3.1.4; the union is that of section 3.5.1).
#pragma once

#include "oc_core/ocri/reference_image.h"

namespace ocelli {

/// `count` views, the first one as it is, and each next one turned about the display's axis (y) by the same step,
/// counter-clockwise seen from above.
std::vector<View> viewsAround(const View& first, int count);

struct ViewerMergeOptions {
  /// A sample is held where the mesh of earlier viewers passes within so many of its pixel footprints,
  float maxFootprints = 0.25f;
  /// ... and samples as densely: a corner of the triangle there is at most so many footprints away. Surfaces that an
  /// earlier viewer sees at a grazing angle are sampled again.
  float maxFootprintsToSample = 1.5f;
  /// Around what is left, so many duplicates of the same surface stay, so that the meshes overlap.
  int seamPixels = 1;
};

/// Samples of one viewer.
struct ViewerShare {
  size_t built = 0;
  size_t kept = 0;
};

struct MergedViewers {
  ReferenceImages images;  ///< of all viewers, one behind the other
  std::vector<ViewerShare> shares;
};

/// `viewers` has the images of each viewer, which may be a union. Those of the first one keep all samples. Where there
/// are several viewers, all images are marked as seen from aside. The same with any number of threads.
MergedViewers mergeViewers(std::vector<ReferenceImages> viewers, const ViewerMergeOptions& options = {});

}  // namespace ocelli
