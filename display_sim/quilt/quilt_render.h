// A quilt view by view: each tile is a picture of the scene's triangles by its own pinhole. The reference for all
// others, and what displays are fed with today.
#pragma once

#include "display_sim/quilt/quilt_picture.h"
#include "oc_core/base/progress.h"

namespace ocelli {

/// `scene` is in the stretched world (quilt_views.h).
QuiltPicture quiltByRender(const QuiltViews& views, const Mesh& scene, QuiltDepths depths = QuiltDepths::kNone,
                           const Progress& progress = {});

}  // namespace ocelli
