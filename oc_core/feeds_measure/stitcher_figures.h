// The same feeds in OpenCV's stitcher (oc_core/feeds_stitch): for how many frames it makes a picture, and how often
// each walker is in it once.
#pragma once

#include <vector>

#include "oc_core/feeds_measure/simulated_feed.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

struct StitcherFigures {
  size_t frames = 0;
  size_t pictures = 0;       ///< frames of which it made one
  size_t picturesOfAll = 0;  ///< of these, those in which all feeds are
  /// Of walkers that are seen in any feed, in frames with a picture: in the part of one feed, of more, of none. The
  /// same feed may show a walker whole or in part.
  size_t seenOnce = 0;
  size_t seenTwice = 0;
  size_t notSeen = 0;
  double seconds = 0;  ///< of all frames

  double meanSeconds() const { return frames > 0 ? seconds / static_cast<double>(frames) : 0; }
};

/// Whether this program was built with the stitcher (OCELLI_WITH_STITCHER).
bool hasStitcher();

/// Adds one frame. `frames` and `masks` have one entry a feed. The caller must have asked
/// hasStitcher().
void addStitchedFrame(const std::vector<Image<Rgb8>>& frames, const std::vector<WalkerMask>& masks, size_t walkers,
                      StitcherFigures& figures);

}  // namespace ocelli
