// What a packed scene holds, counted.
#pragma once

#include <cstdint>

#include "oc_core/base/progress.h"
#include "oc_core/pack/packed_scene.h"

namespace ocelli {

struct PackSummary {
  /// Of the scene itself 1; clusters that replace others are of a level more than the highest of these.
  uint32_t levels = 0;
  uint64_t finestTriangles = 0;  ///< of the scene itself: those that have an area
  uint64_t finestClusters = 0;
  uint64_t coarsestTriangles = 0;  ///< of the clusters that nothing replaces: the fewest that stand for the scene
  uint64_t coarsestClusters = 0;
};

/// Reads and checks all of the file; throws InputError where it is damaged, also where it does not hold what it says.
PackSummary summaryOf(const PackedScene& scene, const Progress& progress = {});

}  // namespace ocelli
