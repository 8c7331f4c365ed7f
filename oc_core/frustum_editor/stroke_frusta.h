// Which frustum of a camera a stroke is for, and where in space it is: for the tools' .cpp files.
#pragma once

#include "oc_core/frustum_editor/editor_tools.h"

namespace ocelli {

/// The frustum under a point of the plan, the selected one before others. Throws InputError where there is none.
const DrawnFrustum& frustumUnder(const DrawnCamera& camera, PlanSide side, const glm::dvec2& paper,
                                 const std::string& selected = "");
/// That which most of the stroke crosses.
const DrawnFrustum& frustumOfStroke(const DrawnCamera& camera, const PlanStroke& stroke,
                                    const std::string& selected = "");

/// Where a point of the paper is: as deep as the middle rays of the frustum are there.
glm::dvec3 onMiddleRays(const DrawnFrustum& frustum, PlanSide side, const glm::dvec2& paper);

/// The part of the image of the rays of a frustum that pass between two points of a plan, and that no child takes; in
/// shares of the image. Throws InputError where no rays pass there.
GraphCamera::Part partBetween(const DrawnCamera& camera, const DrawnFrustum& frustum, PlanSide side,
                              const glm::dvec2& a, const glm::dvec2& b);
/// The part of a frustum that no child takes, where it is one convex piece; empty for all of it.
GraphCamera::Part freePart(const DrawnCamera& camera, const DrawnFrustum& frustum);

}  // namespace ocelli
