// What an observer saw of an emulated display: an image a refresh, from the record of what was shown.
#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <vector>

#include "display_driver/devices/shown_recorder.h"
#include "display_sim/observing/frame_sink.h"
#include "display_sim/observing/observer.h"
#include "oc_core/base/progress.h"

namespace ocelli {

/// Where the eye of `options` stands for a screen that is so far ahead of where it should be: the light of a turned
/// screen is that of a straight one, seen from an eye that is turned the other way.
glm::vec3 eyeForPhaseError(const glm::vec3& eye, double phaseErrorDegrees);

/// Draws the refreshes in their order, from the first one on that shows a frame: at most one for each 1 /
/// framesPerSecond of the display's time. One that is not in the record repeats the image before it. All have one
/// gain. Does not finish `sink`. Returns how many there are.
size_t drawShown(const std::filesystem::path& svol, const std::vector<RecordedRefresh>& refreshes,
                 const ObserverOptions& options, double framesPerSecond, FrameSink& sink,
                 const Progress& progress = {});

}  // namespace ocelli
