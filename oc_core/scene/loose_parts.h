// Lines and points of scene files, which become geometry of the scene.
#pragma once

#include <string>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/scene/scene.h"
#include "oc_core/scene/texture_bake.h"

namespace ocelli {

/// Adds tubes (line_mesh.h) and panels (point_mesh.h) to the scene for what its copies have besides triangles: copies
/// of `parts`, whose colours are baked, as the scene's instances name them. Without PointSceneOptions::width lines are
/// kLineShare of the diagonal of the box around all lines and triangles wide. Sets Scene::points where there is any.
///
/// Points that cannot be drawn, as one alone has no size of its own, are an InputError naming `where`, and a warning
/// where there are lines or triangles to be seen.
void addLooseParts(Scene& scene, const std::vector<TexturedMesh>& parts, const PointSceneOptions& options,
                   const std::string& where, const Progress& progress);

}  // namespace ocelli
