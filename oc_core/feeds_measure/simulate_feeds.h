// Feeds of a built-in scene with walkers, as cameras that are not ideal take them: with the distortion of a lens,
// noise, an exposure that changes, clocks that differ, and frames that are lost. And the truth about all of it.
//
// A folder gets NAME.mkv (H.264; the timestamps of the camera's clock) and NAME.png (the background) of each feed,
// setup.json (oc_core/feeds), truth.json (feed_truth.h), and where asked masks/NAME-FRAME.png: 40 times the number of
// the walker that is seen, from 1 on; 0 is the place.
#pragma once

#include <filesystem>
#include <string>

#include "oc_core/base/progress.h"
#include "oc_core/feeds/feed_setup.h"

namespace ocelli {

struct FeedSimulationOptions {
  std::string scene = "builtin:corridor_t";
  double seconds = 10;
  double framesPerSecond = 30;
  size_t walkers = 4;
  uint64_t seed = 1;
  double noiseLevels = 2;       ///< standard deviation, of 255
  double exposureSwing = 0.1;   ///< share by which the light of a feed goes up and down
  double maxClockOffset = 0.5;  ///< seconds
  double droppedShare = 0.01;   ///< of frames
  double distortion = 1;        ///< 0: pinholes; 1: lenses of usual cameras
  double rollingSeconds = 0;    ///< over which the rows of a frame are taken one after the other; 0: all at once
  int width = 0;                ///< of all feeds and the composed image, pixels; 0: as the rig has them
  int height = 0;
  size_t maskEvery = 0;    ///< masks of each so manieth frame; 0: none
  std::string frozenFeed;  ///< shows nothing new from `frozenSeconds` on
  double frozenSeconds = 0;
};

struct FeedSimulationFigures {
  size_t frames = 0;  ///< of all feeds
  size_t dropped = 0;
};

inline constexpr size_t kMaxWalkers = 100;
inline constexpr double kMaxRollingSeconds = 1;

/// Throws InputError for a scene without cameras and ways or a feed that does not exist, WorkError where a file cannot
/// be written.
FeedSimulationFigures simulateFeeds(const FeedSimulationOptions& options, const std::filesystem::path& folder,
                                    const Progress& progress = {});

}  // namespace ocelli
