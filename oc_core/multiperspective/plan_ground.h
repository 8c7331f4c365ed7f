// The scene under a plan.
#pragma once

#include "oc_core/image/png_file.h"
#include "oc_core/multiperspective/plan_side.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// What lies behind the plane across the axis of `side` at coordinate `at`, seen from that side, on white. `lower` and
/// `upper` are the corners of the paper; `pixels` is the longer side of the image.
Image<Rgb8> planGround(const Mesh& mesh, PlanSide side, const glm::vec2& lower, const glm::vec2& upper, float at,
                       int pixels);

}  // namespace ocelli
