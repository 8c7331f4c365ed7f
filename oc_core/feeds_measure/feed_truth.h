// The truth about simulated feeds: what truth.json holds, and what is made again from it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "oc_core/feeds/feed_setup.h"
#include "oc_core/feeds_measure/walkers.h"

namespace ocelli {

struct FeedTruth {
  std::string name;
  double clockOffsetSeconds = 0;
  double phase = 0;               ///< of its frames, as a share of the time between two
  double exposurePeriod = 10;     ///< seconds
  double exposurePhase = 0;       ///< radians
  double frozenFromSeconds = -1;  ///< from then on all frames show this moment; less than 0: never
  std::vector<size_t> dropped;    ///< frames that were taken, but are not in the video

  /// When the first row of frame `k` is taken.
  double takenAt(size_t k, double framesPerSecond) const { return (static_cast<double>(k) + phase) / framesPerSecond; }
  /// What a frame that is taken at a time shows: that moment, or the one at which the feed froze.
  double shownAt(double seconds) const {
    return frozenFromSeconds >= 0 && seconds > frozenFromSeconds ? frozenFromSeconds : seconds;
  }
  /// The factor of all light at a time.
  double exposureAt(double seconds, double swing) const;
};

struct SimulationTruth {
  std::string scene;
  uint64_t seed = 1;
  size_t walkers = 4;
  double seconds = 10;
  double framesPerSecond = 30;
  double exposureSwing = 0.1;
  double noiseLevels = 2;
  /// From the first row of a frame to its last: row y of h is taken at takenAt() + rollingSeconds y / h.
  double rollingSeconds = 0;
  std::vector<FeedTruth> feeds;  ///< of the setup, in its order

  Walkers makeWalkers() const;
};

/// With the places of all walkers at each frame.
std::string jsonText(const SimulationTruth& truth, const FeedSetup& setup);
/// Throws InputError where a file is none that simulateFeeds() wrote.
SimulationTruth readSimulationTruth(const std::filesystem::path& path);

}  // namespace ocelli
