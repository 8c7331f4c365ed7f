// Series of images of one volume, with one gain, and pairs of images for two eyes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "display_sim/observing/eye_path.h"
#include "display_sim/observing/frame_sink.h"
#include "display_sim/observing/observer.h"
#include "oc_core/base/progress.h"

namespace ocelli {

/// What observes: collectLight() of a volume, or a GPU.
using CollectLight = std::function<Image<glm::vec3>(const ObserverOptions&)>;

struct LightPair {
  Image<glm::vec3> left;
  Image<glm::vec3> right;
};

/// What two eyes see that are so many display radii apart, on either side of options.eye.
LightPair collectPair(const CollectLight& collect, const ObserverOptions& options, double separationRadii);

/// The left eye's image on the left.
Image<glm::vec3> sideBySide(const LightPair& pair);

struct ObserverSeries {
  std::vector<glm::vec3> eyes;  ///< one a frame
  double separationRadii = 0;   ///< of two eyes, side by side in each frame; 0: one eye
};

/// Throws InputError, naming file and pose, where this way from the file `where` leads into the display.
void checkWay(const std::vector<EyePose>& poses, double framesPerSecond, const DisplayProfile& profile,
              const std::string& where);

/// Throws as checkObserverOptions() does, for every eye of the series.
void checkSeries(const ObserverSeries& series, const ObserverOptions& options, const DisplayProfile& profile);

/// The gain for all frames: options.tone's, or the CommonGain of up to nine frames, spread over the series.
double seriesGain(const CollectLight& collect, const ObserverOptions& options, const ObserverSeries& series);

/// Draws frame after frame, all with this gain. Does not finish `sink`.
void observeSeries(const CollectLight& collect, const ObserverOptions& options, const ObserverSeries& series,
                   double gain, FrameSink& sink, const Progress& progress = {});

}  // namespace ocelli
