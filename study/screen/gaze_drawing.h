// Where a subject looked, over a trial that is shown again: a ring with a trail.
#pragma once

#include <span>

#include "study/screen/study_canvas.h"
#include "study/session/session_screen.h"

namespace ocelli {

void drawGazeMarks(StudyCanvas& canvas, std::span<const GazeMark> marks);

}  // namespace ocelli
