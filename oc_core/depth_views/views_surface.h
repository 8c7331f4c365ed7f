// The surface that several views with depth show together: one mesh, at which every camera of the toolkit can look as
// at any scene.
//
// Several views sample the same surface. At each place the samples of the view that has them closest together stay, of
// views that have them about as close those of the earlier one; other views' samples of that place are dropped, but for
// a seam along which the meshes overlap. The mesh is that of a union of reference images (union_mesh.h): neighbours are
// joined but across edges of depth.
#pragma once

#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/depth_views/depth_view.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

struct ViewsSurfaceOptions {
  /// Samples of two views are of the same place where they are at most so many spaces between samples apart: of the
  /// view whose sample stays, and no less than of a surface that is seen face on.
  float maxSpaces = 0.75f;
  /// A view is better where its samples are so many times closer together, or more.
  float betterBy = 2;
  /// Samples with such neighbours, pixel footprints apart, are joined; longer steps say nothing of a surface.
  float maxStepFootprints = 10;
  /// Around what stays of a view, so many samples of the same surface stay too.
  int seamPixels = 2;
  /// All samples stay: what views that see the same place differently look like.
  bool keepsAll = false;
};

struct ViewsSurface {
  Mesh mesh;                 ///< a part of a scene (Mesh::isPart), and of samples (Mesh::isSampled)
  std::vector<size_t> kept;  ///< samples of each view
  size_t samples = 0;        ///< of all views, before any was dropped

  size_t keptSamples() const;
};

/// Views as requireDepthView() and requireDifferentViews() have them. The same with any number of threads.
ViewsSurface surfaceOfViews(std::vector<DepthView> views, const ViewsSurfaceOptions& options = {},
                            const Progress& progress = {});

}  // namespace ocelli
