#include "display_sim/volume_slicing/coarser_volume.h"

#include <algorithm>
#include <glm/common.hpp>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "oc_core/base/parallel.h"
#include "oc_core/volume/volume_scan.h"

namespace ocelli {

glm::dmat4 fineFromCoarserIndex(const glm::ivec3& factor) {
  // Coarse voxel i covers the fine ones from factor i to factor (i + 1) - 1.
  glm::dmat4 matrix(1);
  for (int axis = 0; axis < 3; ++axis) {
    matrix[axis][axis] = factor[axis];
    matrix[3][axis] = (factor[axis] - 1) / 2.0;
  }
  return matrix;
}

ScalarVolume coarserVolume(const ScalarVolume& volume, const glm::ivec3& factor, const ValueRange& range) {
  const VolumeGrid& fine = volume.grid();
  VolumeGrid grid = fine;
  grid.size = (fine.size + factor - 1) / factor;
  grid.worldFromIndex = fine.worldFromIndex * fineFromCoarserIndex(factor);
  const auto width = static_cast<size_t>(grid.size.x);
  const size_t layer = width * static_cast<size_t>(grid.size.y);
  constexpr double kSteps = 65535;
  const double extent = range.greatest - range.least;
  const double stepsByValue = extent > 0 ? kSteps / extent : 0;
  // What a voxel holds at the ends of the range.
  const double atLeast = volume.scale() != 0 ? (range.least - volume.offset()) / volume.scale() : 0;
  const double atGreatest = volume.scale() != 0 ? (range.greatest - volume.offset()) / volume.scale() : 0;
  const double lower = std::min(atLeast, atGreatest);
  const double upper = std::max(atLeast, atGreatest);
  const auto values = std::make_shared<std::vector<uint16_t>>(grid.voxelCount());
  visitVoxels(volume, [&](const auto* first) {
    parallelFor(static_cast<size_t>(grid.size.z), 1, [&](size_t begin, size_t end) {
      std::vector<double> sums(layer);
      std::vector<int> counts(layer);
      for (size_t coarse = begin; coarse < end; ++coarse) {
        std::ranges::fill(sums, 0.0);
        std::ranges::fill(counts, 0);
        const int firstLayer = static_cast<int>(coarse) * factor.z;
        // Of volumes larger than memory no more than what is averaged now.
        const SlicesInMemory layers(volume, static_cast<size_t>(firstLayer),
                                    static_cast<size_t>(std::min(firstLayer + factor.z, fine.size.z)));
        for (int k = firstLayer; k < std::min(firstLayer + factor.z, fine.size.z); ++k) {
          for (int j = 0; j < fine.size.y; ++j) {
            const auto* row =
                first + (static_cast<size_t>(k) * static_cast<size_t>(fine.size.y) + static_cast<size_t>(j)) *
                            static_cast<size_t>(fine.size.x);
            const size_t out = static_cast<size_t>(j / factor.y) * width;
            for (int i = 0; i < fine.size.x; ++i) {
              sums[out + static_cast<size_t>(i / factor.x)] += std::clamp(static_cast<double>(row[i]), lower, upper);
              ++counts[out + static_cast<size_t>(i / factor.x)];
            }
          }
        }
        for (size_t i = 0; i < layer; ++i) {
          const double mean = volume.scale() * (sums[i] / counts[i]) + volume.offset();
          (*values)[coarse * layer + i] =
              static_cast<uint16_t>(std::clamp((mean - range.least) * stepsByValue, 0.0, kSteps) + 0.5);
        }
      }
    });
  });
  return {
      std::move(grid), VoxelType::kUint16, std::as_bytes(std::span(*values)), values, extent > 0 ? extent / kSteps : 1,
      range.least};
}

}  // namespace ocelli
