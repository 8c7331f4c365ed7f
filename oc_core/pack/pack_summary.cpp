#include "oc_core/pack/pack_summary.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "oc_core/base/error.h"

namespace ocelli {

PackSummary summaryOf(const PackedScene& scene, const Progress& progress) {
  constexpr uint32_t kBetween = 1024;
  PackSummary summary;
  uint64_t triangles = 0;
  uint64_t clusters = 0;
  std::vector<uint32_t> levels(scene.groupCount(), 0);  // of the highest cluster of a group
  // What stands above a group comes after it: where each but the root stands below one, all stand below the root.
  std::vector<uint8_t> standsBelow(scene.groupCount(), 0);
  for (uint32_t i = 0; i < scene.groupCount(); ++i) {
    const PackedGroupInfo group = scene.group(i);
    for (uint32_t k = 0; k < group.clusters; ++k) {
      const PackedClusterInfo cluster = scene.cluster(i, k);
      const bool isOfScene = cluster.finer == PackedClusterInfo::kNone;
      // Groups that something replaces stand before the clusters that replace them.
      levels[i] = std::max(levels[i], isOfScene ? 1 : levels[cluster.finer] + 1);
      if (!isOfScene) {
        standsBelow[cluster.finer] = 1;
      }
      summary.finestTriangles += isOfScene ? cluster.triangles : 0;
      summary.finestClusters += isOfScene ? 1 : 0;
    }
    for (uint32_t k = 0; k < group.innerGroups; ++k) {
      standsBelow[group.firstInner + k] = 1;
    }
    summary.levels = std::max(summary.levels, levels[i]);
    if (std::isinf(group.error)) {
      summary.coarsestTriangles += group.triangles;
      summary.coarsestClusters += group.clusters;
    }
    triangles += group.triangles;
    clusters += group.clusters;
    if (i % kBetween == 0) {
      report(progress, "counting", static_cast<double>(i) / scene.groupCount());
      scene.release();
    }
  }
  standsBelow[scene.root()] = 1;
  if (std::ranges::count(standsBelow, 0) > 0 || triangles != scene.storedTriangles() ||
      clusters != scene.clusterCount() || summary.finestTriangles > scene.triangleCount()) {
    throw InputError("this packed scene is damaged: it does not hold what its end says", scene.path().string(),
                     "pack the scene again");
  }
  return summary;
}

}  // namespace ocelli
