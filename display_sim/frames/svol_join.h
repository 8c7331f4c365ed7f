// One recording from the frames of several `.svol` files.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "oc_core/base/progress.h"

namespace ocelli {

struct JoinOptions {
  /// Between the last frame of a file and the first of the next: 0.001 to 1000000, by default the display's refreshes.
  /// Within a file the frames keep their distances.
  std::optional<double> framesPerSecond = {};
  int framesPerKey = 48;
  /// Of unfinished and damaged sources, take the frames up to the first that cannot be read.
  bool salvage = false;
};

struct JoinResult {
  size_t frames = 0;
  std::vector<std::filesystem::path>
      incomplete;  ///< sources that are unfinished or damaged: what can be read was taken
};

/// Writes all frames of `sources`, in their order, with the metadata of the first. The file appears when it is
/// complete. Throws InputError for sources of different displays, without frames, or not whole, and for a rate
/// out of range; and WorkError.
JoinResult joinSvol(const std::vector<std::filesystem::path>& sources, const std::filesystem::path& output,
                    const JoinOptions& options = {}, const Progress& progress = {});

}  // namespace ocelli
