// A frame of a trial as an image: the views by any renderer, and over them the prompt, maps, answers, a scale or dial
// and the pointer, plainly drawn. What a screen shows differs from it in fonts and colours.
#pragma once

#include "study/task/trial_image.h"

namespace ocelli {

/// Throws WorkError where it cannot be drawn.
Image<Rgb8> trialFrame(const TrialLayout& layout, const TrialScreen& screen, const StudyRenderer& renderer);

}  // namespace ocelli
