// Scales and dials to answer on with a number.
#pragma once

#include "study/screen/study_canvas.h"
#include "study/task/trial_layout.h"

namespace ocelli {

/// A line with ticks, and numbers below; the mark is a triangle above it and a line across.
void drawScale(StudyCanvas& canvas, const TrialLayout::Scale& scale);

/// A circle with ticks every 15 degrees, the subject in its middle, "ahead" at the top; the mark is an arrow from the
/// middle.
void drawDial(StudyCanvas& canvas, const TrialLayout::Dial& dial);

}  // namespace ocelli
