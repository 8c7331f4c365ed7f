// A session without a window: a script's frames as images, videos, and figures of how long they took and whether any
// jumped.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "oc_core/explore/explore_jumps.h"
#include "oc_core/explore/explore_script.h"

namespace ocelli {

/// Where the frames of a recording go.
struct ExploreRecording {
  std::function<void(const Image<Rgb8>& frame)> add;
  std::function<void()> finish;
};

struct ExploreOffscreenOptions {
  ExplorerOptions explorer{};
  std::optional<WalkerView> start{};   ///< nothing: an open place
  std::string camera{};                ///< a live constructor or a camera's file to begin with; empty: the pinhole
  std::filesystem::path folder = ".";  ///< for what the script saves
  bool measureTimes = false;           ///< every frame is drawn
  bool measureJumps = false;           ///< every frame is drawn, and those of the pinhole
  /// Opens a video. Empty: recording is refused.
  std::function<ExploreRecording(const std::filesystem::path& path, int width, int height)> record{};
  std::function<void(const std::filesystem::path& path)> wrote{};
};

/// Of all frames of a session that were drawn, in milliseconds, by frame.
struct ExploreTimes {
  std::vector<double> step;    ///< the walker and the camera, by the clock
  std::vector<double> draw;    ///< the picture, by the clock
  double processorMeanMs = 0;  ///< of both, by the processor, all threads together: others on the machine do not count

  /// The value below which that share of the frames are, of both together; 0 for none.
  double percentile(double share) const;
  double mean() const;
};

struct ExploreReport {
  int frames = 0;
  ExploreTimes times;
  std::vector<FrameChange> changes;
  std::optional<WorstFrame> worst;

  int jumps() const;
};

/// Plays the script. `options.explorer` gets the script's size. Throws as the script and its steps do.
ExploreReport exploreOffscreen(ExploreScene& scene, const ExploreScript& script, ExploreOffscreenOptions options);

}  // namespace ocelli
