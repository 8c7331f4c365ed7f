// Drawings (oc_core/drawing/) painted with Dear ImGui: plans of editors, in panes.
#pragma once

#include <glm/vec2.hpp>

#include "oc_core/drawing/drawing.h"

struct ImDrawList;

namespace ocelli {

/// A length of 1 of the drawing is `scale` screen coordinates, and its origin is at `corner`. Filled outlines must be
/// convex; texts stand upright; images are left out, as they would be uploaded in every frame.
void paintExploreDrawing(ImDrawList& list, const Drawing& drawing, const glm::vec2& corner, float scale);

}  // namespace ocelli
