#include "display_sim/solidity/voxel_visibility.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>

#include "display_sim/frames/sweep_geometry.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

double voxelSize(const SweepGeometry& sweep, int column) {
  return std::max({sweep.columnWidth(), sweep.rowHeight(), std::abs(sweep.columnRadius(column)) * sweep.stepRadians()});
}

}  // namespace

VoxelVisibility::VoxelVisibility(const Volume& volume, const RayScene& scene)
    : profile_(volume.profile()), scene_(scene), slices_(static_cast<size_t>(volume.slices())) {
  const SweepGeometry sweep(profile_);
  parallelFor(slices_.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const int slice = static_cast<int>(i);
      forEachLevel(volume, slice, [&](int column, int row, const Rgb8& levels) {
        const glm::vec3 center(sweep.voxelCenter(slice, column, row));
        const auto reach = static_cast<float>(kVoxelReach * voxelSize(sweep, column));
        const auto surface = scene_.closestSurface(center, reach);
        slices_[i].push_back({column, row, levels, surface ? surface->position : center, reach});
      });
    }
  });
}

Volume VoxelVisibility::hiddenFrom(const glm::vec3& eye) const {
  constexpr size_t kBatch = 64;  // of paths, which are large
  Volume hidden(profile_);
  parallelFor(slices_.size(), 1, [&](size_t begin, size_t end) {
    std::vector<RayPath> paths;
    std::vector<Fragment> met(kBatch);
    for (size_t i = begin; i < end; ++i) {
      const std::vector<LitVoxel>& voxels = slices_[i];
      for (size_t first = 0; first < voxels.size(); first += kBatch) {
        const auto batch = std::span(voxels).subspan(first, std::min(kBatch, voxels.size() - first));
        paths.clear();
        for (const LitVoxel& voxel : batch) {
          const float distance = glm::distance(eye, voxel.point);
          paths.push_back({eye, eye + (voxel.point - eye) * std::max(1 - voxel.reach / distance, 0.0f)});
        }
        scene_.intersect(paths, std::span(met).first(batch.size()));
        for (size_t k = 0; k < batch.size(); ++k) {
          if (met[k].covered()) {
            hidden.raise(static_cast<int>(i), batch[k].column, batch[k].row, batch[k].levels);
          }
        }
      }
    }
  });
  return hidden;
}

}  // namespace ocelli
