#include "oc_core/sea/sea_summary.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "oc_core/sea/sea_graph.h"

namespace ocelli {

double medianSpacing(const std::vector<glm::dvec3>& positions) {
  // The nearest position is a neighbour in the triangulation.
  std::vector<double> nearest(positions.size(), std::numeric_limits<double>::infinity());
  for (const auto& [a, b] : delaunayEdges(planePositions(positions))) {
    const double length = glm::distance(positions[a], positions[b]);
    nearest[a] = std::min(nearest[a], length);
    nearest[b] = std::min(nearest[b], length);
  }
  const auto middle = nearest.begin() + static_cast<ptrdiff_t>(nearest.size() / 2);
  std::nth_element(nearest.begin(), middle, nearest.end());
  return positions.size() > 1 ? *middle : 0;
}

SeaSummary summaryOf(const SeaFile& sea) {
  SeaSummary summary;
  const std::vector<glm::dvec3> positions = sea.positions();
  summary.lower = summary.upper = positions[0];
  for (uint32_t i = 0; i < sea.count(); ++i) {
    const SeaFile::Stored stored = sea.stored(i);
    const bool isInner = stored.reference == sea::kNoReference;
    summary.inner += isInner ? 1 : 0;
    (isInner ? summary.innerBytes : summary.residualBytes) += stored.bytes;
    summary.hiddenBytes += stored.hiddenBytes;
    summary.mostAdditions = std::max(summary.mostAdditions, stored.additions);
    summary.lower = glm::min(summary.lower, positions[i]);
    summary.upper = glm::max(summary.upper, positions[i]);
  }
  const SeaProjection& projection = sea.settings().projection;
  summary.rawBytes =
      uint64_t{3} * sea.count() * static_cast<uint64_t>(projection.width) * static_cast<uint64_t>(projection.height);
  summary.fileBytes = sea.fileBytes();
  summary.spacing = medianSpacing(positions);
  return summary;
}

}  // namespace ocelli
