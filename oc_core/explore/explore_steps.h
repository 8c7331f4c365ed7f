// The steps of scripts (explore_script.h).
#pragma once

#include <vector>

#include "oc_core/explore/explore_script.h"

namespace ocelli {

/// Frames of the script's time, at most as many as ten minutes have.
inline constexpr double kMaxExploreSeconds = 600;

/// What a person does for so long.
void showFrames(ExploreSession& session, const WalkInput& input, double seconds);

/// Walks, turns, jumps and waits.
std::vector<ExploreStepKind> exploreWalkSteps();
/// Constructors, picks, options, what is expected, and files.
std::vector<ExploreStepKind> exploreChoiceSteps();
/// Cameras that are drawn.
std::vector<ExploreStepKind> exploreDrawSteps();
/// Keys and the pointer, where there is a window.
std::vector<ExploreStepKind> exploreEventSteps();

}  // namespace ocelli
