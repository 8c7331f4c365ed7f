// What a `.svol` file holds, frame by frame, and whether all of it is right.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "display_sim/svol_reader.h"
#include "oc_core/base/progress.h"

namespace ocelli {

struct SvolFrameSummary {
  uint64_t timeMicroseconds = 0;
  bool key = false;
  uint64_t bytes = 0;                            ///< in the file
  std::array<size_t, kSvolSliceKinds> slices{};  ///< how many of each kind
};

/// From the slice tables alone. Throws InputError for one that is wrong.
std::vector<SvolFrameSummary> summarizeFrames(SvolReader& reader, const Progress& progress = {});

/// Decodes every slice of every frame. Throws InputError for the first thing in the file that is wrong; that it is
/// unfinished is not (reader.ending() tells).
void verifySvol(SvolReader& reader, const Progress& progress = {});

}  // namespace ocelli
