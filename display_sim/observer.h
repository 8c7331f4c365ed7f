// What an eye or a camera sees of a volume on the display.
//
// Every lit voxel emits; light adds, and nothing hides anything. While a slice is on, the screen sweeps the arc around
// its plane, so the light of a voxel is spread over that arc, and from there over the image area that it projects to,
// in proportion to the area. One pass of one channel of a voxel gives the image the light (d / z)^2, where z is the
// voxel's distance along the view direction and d that of the display's centre: so the brightness of a surface, light
// for its image area, does not depend on its distance. Every voxel emits the same light, and those at the axis lie
// closer together: surfaces are brighter there, as on a real display. Voxels emit evenly into all directions.
#pragma once

#include <glm/vec3.hpp>

#include "display_sim/volume.h"
#include "oc_core/base/conventions.h"
#include "oc_core/base/image.h"

namespace ocelli {

struct ObserverOptions {
  glm::vec3 eye{0, 0, kDefaultEyeDistance};  ///< in display radii, outside of the display; it looks at the centre, y up
  int width = 768;
  int height = 768;
  double fovVerticalDegrees = 0;  ///< 0: just holds the unit sphere
  double exposureSeconds = 0;     ///< 0: one refresh of the display
  /// The screen angle at which the exposure ends: where the sector starts that an exposure below a refresh misses.
  double missingSectorStartDegrees = 0;
  double gain = 0;   ///< of tone(); 0: automaticGain()
  double gamma = 1;  ///< of tone()
};

/// collectLight(), then tone(). Linear light; the same bytes with any number of threads. Throws as
/// checkObserverOptions() does.
Image<glm::vec3> observe(const Volume& volume, const ObserverOptions& options = {});

/// Throws InputError for an eye in the display and other options that make no sense.
void checkObserverOptions(const ObserverOptions& options, const DisplayProfile& profile);

/// The light that reaches each pixel; its sum over the image is the light of all voxels that the image holds.
Image<glm::vec3> collectLight(const Volume& volume, const ObserverOptions& options);

/// The gain that takes the 99th percentile of the brightest channel of the lit pixels to 0.95, just below white; 1 for
/// an image without light.
double automaticGain(const Image<glm::vec3>& light);

/// (light x gain)^(1 / gamma), where values above 1 stand for overexposure. `gamma` is that of the eye's or camera's
/// response; PNG files have their own encoding beside it.
void tone(Image<glm::vec3>& image, double gain, double gamma);

}  // namespace ocelli
