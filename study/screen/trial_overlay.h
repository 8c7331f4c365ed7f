// What stands over and beside the views of a trial: prompt, choices, maps of paths, pointer.
#pragma once

#include "study/screen/scene_views.h"
#include "study/screen/study_canvas.h"

namespace ocelli {

void drawTrialOverlay(StudyCanvas& canvas, const TrialLayout& layout, SceneViews& views);

/// The choices and maps of a layout alone.
void drawChoicesAndMaps(StudyCanvas& canvas, const TrialLayout& layout);

/// A path as a map: from a dot, "Start", to an arrow.
void drawPathMap(StudyCanvas& canvas, const PixelRect& place, std::span<const glm::dvec2> corners, GuiColor background);

}  // namespace ocelli
