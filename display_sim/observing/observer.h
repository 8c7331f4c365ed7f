// What an eye or a camera sees of a volume on the display.
//
// Every lit voxel emits (emission.h); light adds, and nothing hides anything. While a slice is on, the screen sweeps
// the arc around its plane, so the light of a voxel is spread over that arc, and from there over the image area that it
// projects to, in proportion to the area. One pass of one channel of a voxel that emits evenly gives the image the
// light (d / z)^2, where z is the voxel's distance along the view direction and d that of the display's centre: so the
// brightness of a surface, light for its image area, does not depend on its distance. Every voxel emits the same light,
// and those at the axis lie closer together: surfaces are brighter there, as on a real display.
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "display_sim/frames/volume.h"
#include "display_sim/observing/emission.h"
#include "display_sim/observing/lens.h"
#include "display_sim/observing/tone.h"
#include "display_sim/observing/wobble.h"
#include "oc_core/base/conventions.h"
#include "oc_core/image/image.h"

namespace ocelli {

struct ObserverOptions {
  glm::vec3 eye{0, 0, kDefaultEyeDistance};  ///< in display radii, outside of the display; it looks at the centre, y up
  int width = 768;
  int height = 768;
  double fovVerticalDegrees = 0;  ///< 0: just holds the unit sphere; or 1e-6 at least
  double exposureSeconds = 0;     ///< 0: one refresh of the display
  /// The screen angle at which the exposure ends: where the sector starts that an exposure below a refresh misses.
  double missingSectorStartDegrees = 0;
  std::optional<double> startDegrees = std::nullopt;  ///< where given, the screen angle at which the exposure starts
  Emission emission = {};
  Wobble wobble = {};
  Lens lens = {};
  /// Nothing is lit within this distance from the axis, where a display has its shaft.
  double deadZoneRadii = 0;
  /// Light of the room that the screen scatters, relative to that of a screen lit white all the time: ambient_light.h.
  double ambient = 0;
  Tone tone{.gain = 0};  ///< gain 0: automaticGain()
};

/// collectLight(), then applyTone(). Linear light; the same bytes with any number of threads. Throws as
/// checkObserverOptions() does.
Image<glm::vec3> observe(const Volume& volume, const ObserverOptions& options = {});

/// Or so near to it that nothing can be seen.
bool isInDisplay(const glm::vec3& eye, const DisplayProfile& profile);

/// Throws InputError for an eye in the display and other options that make no sense.
void checkObserverOptions(const ObserverOptions& options, const DisplayProfile& profile);

/// What the screen sweeps during the exposure.
Sweep exposedSweep(const ObserverOptions& options, const DisplayProfile& profile);

/// The light that reaches each pixel. Without light of the room its sum over the image is the light of all voxels that
/// the image holds.
Image<glm::vec3> collectLight(const Volume& volume, const ObserverOptions& options);

}  // namespace ocelli
