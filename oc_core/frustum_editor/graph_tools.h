// The tools that make frusta of a graph camera: for editor_tools.cpp alone.
#pragma once

#include "oc_core/frustum_editor/editor_tools.h"

namespace ocelli {

StrokeEdit bendStroke(const DrawnCamera& camera, const PlanStroke& stroke);
StrokeEdit addStroke(const DrawnCamera& camera, const PlanStroke& stroke);
StrokeEdit splitStroke(const DrawnCamera& camera, const PlanStroke& stroke);
StrokeEdit mergeStroke(const DrawnCamera& camera, const PlanStroke& stroke);
StrokeEdit limitStroke(const DrawnCamera& camera, const PlanStroke& stroke);

/// Of a curved ray camera: a turn about the end of the stroke where it began.
StrokeEdit turnStroke(const DrawnCamera& camera, const PlanStroke& stroke);

}  // namespace ocelli
