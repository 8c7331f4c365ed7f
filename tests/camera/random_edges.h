// Epipolar occlusion cameras with edges at random: whatever the edges, a camera keeps its contract.
#pragma once

#include <random>
#include <vector>

#include "oc_core/camera/epipolar_camera.h"

namespace ocelli::test {

/// R for the small camera of test_scenes.h, whose eye L is at (0, 0, 10): across, into the scene, away from it, and
/// aslant.
inline std::vector<glm::vec3> segmentEnds() {
  return {{1.6f, 0, 10}, {0, 0, 8.6f}, {0, 0, 11.4f}, {0.8f, 0.3f, 9}};
}

/// Edges of occluders at depths from 7 to 9 that hide up to 14 pixels.
inline std::vector<std::vector<EpipolarEdge>> randomEdges(const EpipolarLines& lines, unsigned seed) {
  std::mt19937 random(seed);
  const auto upTo = [&](int most) { return static_cast<int>(random() % static_cast<unsigned>(most + 1)); };
  std::vector<std::vector<EpipolarEdge>> rows(static_cast<size_t>(lines.rowCount()));
  for (int row = 0; row < lines.rowCount(); ++row) {
    for (int position = 3 + upTo(20); position < lines.length(row) - 1; position += 2 + upTo(25)) {
      const int clip = std::max(0, position - 1 - upTo(13));
      const float inverseNear = 1 / (7 + static_cast<float>(upTo(200)) / 100);
      const double x = lines.x(row, position);
      // No more columns than reach the horizon of R, and none beyond the epipole.
      const double xHorizon = x - lines.disparity() * static_cast<double>(inverseNear) * lines.inverseZScale(x);
      int added = 1 + upTo(position - clip + 2);
      while (added > 0 && !(lines.has(row, position - added) && lines.x(row, position - added) >= xHorizon)) {
        --added;
      }
      if (added > 0) {
        rows[static_cast<size_t>(row)].push_back({position, clip, added, inverseNear});
      }
    }
  }
  return rows;
}

}  // namespace ocelli::test
