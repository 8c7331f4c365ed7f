// What a `.svol` file holds, frame by frame, and whether all of it is right.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "display_sim/frames/svol_reader.h"
#include "oc_core/base/error.h"
#include "oc_core/base/progress.h"

namespace ocelli {

struct SvolFrameSummary {
  uint64_t timeMicroseconds = 0;
  bool key = false;
  uint64_t bytes = 0;                            ///< in the file
  std::array<size_t, kSvolSliceKinds> slices{};  ///< how many of each kind
};

struct SvolSummary {
  std::vector<SvolFrameSummary> frames;  ///< those before the damage
  size_t keyFrames = 0;
  std::optional<size_t> litVoxels;  ///< of the first frame, where that can be read
  uint64_t durationMicroseconds = 0;
  std::optional<InputError> damage;  ///< the first that opening, the slice tables or the first frame show
};

/// From the slice tables and the first frame alone: other payloads may be damaged (verifySvol() tells).
SvolSummary summarizeSvol(SvolReader& reader, const Progress& progress = {});

/// Decodes every slice of every frame. Throws InputError for the first thing in the file that is wrong; that it is
/// unfinished is not (reader.ending() tells).
void verifySvol(SvolReader& reader, const Progress& progress = {});

}  // namespace ocelli
