// The veil that a lit room lays over the display: its screen scatters the light of the room as well as its own.
#pragma once

#include "display_sim/observing/observer.h"

namespace ocelli {

/// For how much of a refresh the ray of a pixel through (u, v) meets the screen: 0 to 1. The ray meets the screen's
/// plane at the angle of each of its points about the axis in turn, so this is the angle that the ray covers within the
/// display, out of a half turn. 0 beside the display.
double screenCoverage(const ObserverOptions& options, const DisplayProfile& profile, double u, double v);

/// Adds to each pixel options.ambient x screenCoverage() of the light that a screen gives which is white all over, all
/// the time. A voxel of such a screen covers a = column width x row height of it, its light is spread over that, and
/// all N slices pass in a refresh: pi / 2 N d^2 / (a f^2) a refresh, with the distance d of the display's centre and f
/// pixels for one unit at distance 1. (The screen's two faces send, on average, the same.) Pixels take the mean over a
/// refresh where the exposure is no whole number of them.
void addAmbientLight(Image<glm::vec3>& light, const DisplayProfile& profile, const ObserverOptions& options);

}  // namespace ocelli
