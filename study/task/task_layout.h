// Where things stand on the screen of a trial. All views have whole pixels.
#pragma once

#include <vector>

#include "study/task/trial_layout.h"

namespace ocelli {

/// All of the screen.
PixelRect wholeScreen(const TrialScreen& screen);
/// All of the screen but the prompt.
PixelRect stageOf(const TrialScreen& screen);
/// So many rows and columns of equal places, row by row, with a few pixels between them. `gap` is a share of the
/// height.
std::vector<PixelRect> gridOf(const PixelRect& area, int rows, int columns, double gap);
/// A row of buttons across the middle.
std::vector<PixelRect> buttonsIn(const PixelRect& area, int count);
/// As large as a place.
glm::ivec2 sizeOf(const PixelRect& place);

}  // namespace ocelli
