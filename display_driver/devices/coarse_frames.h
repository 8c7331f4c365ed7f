// A frame as it arrives: what a display shows of it when only a part has come.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "display_sim/frames/volume.h"

namespace ocelli {

struct CoarseFrame {
  Volume shown;
  int slices = 0;    ///< that have come
  size_t bytes = 0;  ///< of the stream, up to the last of them
};

/// Codes a whole frame as for a display that takes everything, and cuts the stream after these shares of its slices,
/// each above 0 and up to 1. A dark volume has no slices to send: it is shown whole.
std::vector<CoarseFrame> coarseFrames(const Volume& volume, std::span<const double> shares);

}  // namespace ocelli
