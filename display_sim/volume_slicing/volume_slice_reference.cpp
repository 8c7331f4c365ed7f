#include "display_sim/volume_slicing/volume_slice_reference.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>
#include <utility>

#include "display_sim/dither/diffusion.h"
#include "display_sim/dither/voxel_dither.h"
#include "oc_core/base/parallel.h"

namespace ocelli {

VolumeSliceReference::VolumeSliceReference(const VolumeScene& scene, const DisplayProfile& profile, int pointsASide,
                                           const SweptLightOptions& options)
    : scene_(scene),
      profile_(profile),
      sweep_(profile),
      pointsASide_(pointsASide),
      options_(options),
      indexFromScene_(glm::inverse(scene.worldFromIndex)) {}

glm::vec3 VolumeSliceReference::lightOf(int slice, int column, int row) const {
  const glm::ivec3& size = scene_.volume->grid().size;
  const auto indexOf = [&](const glm::dvec3& point) { return glm::dvec3(indexFromScene_ * glm::dvec4(point, 1)); };
  const glm::dvec2& direction = sweep_.sectorDirection(slice);
  const glm::dvec3 outward(direction.x, 0, direction.y);
  const glm::dvec3 across(-direction.y, 0, direction.x);
  const auto share = [&](int i) { return (i + 0.5) / pointsASide_ - 0.5; };
  double extinction = 0;
  double weights = 0;
  double weightsInside = 0;
  glm::dvec3 emission(0);
  for (int i = 0; i < pointsASide_; ++i) {
    const double r = sweep_.columnRadius(column) + share(i) * sweep_.columnWidth();
    for (int j = 0; j < pointsASide_; ++j) {
      const double s = share(j) * 2 * r * sweep_.tanHalfStep();
      for (int k = 0; k < pointsASide_; ++k) {
        const double y = sweep_.rowCenterY(row) + share(k) * sweep_.rowHeight();
        const glm::dvec3 index = indexOf(outward * r + across * s + glm::dvec3(0, y, 0));
        const double weight = std::abs(r);
        weights += weight;
        if (glm::any(glm::lessThan(index, glm::dvec3(-0.5))) ||
            glm::any(glm::greaterThan(index, glm::dvec3(size) - 0.5))) {
          continue;
        }
        weightsInside += weight;
        const double value = scene_.volume->fieldAt(index);
        if (options_.shown && (value < options_.shown->least || value > options_.shown->greatest)) {
          continue;
        }
        const OpticalSample sample = scene_.appearance.transfer.at(value);
        extinction += weight * sample.extinction;
        emission += weight * sample.extinction * sample.color;
      }
    }
  }
  if (!(extinction > 0)) {
    return glm::vec3(0);
  }
  const double mean = extinction / weightsInside * options_.gain / scene_.sceneLengthOfUnit();
  const double covered = weightsInside / weights;
  return glm::vec3(covered * emission / extinction * -std::expm1(-mean * sweptThickness(sweep_, column)));
}

VoxelColors VolumeSliceReference::colors(const Progress& progress) const {
  VoxelColors colors(static_cast<size_t>(profile_.storedSlices()));
  for (size_t i = 0; i < colors.size(); ++i) {
    report(progress, "slicing", static_cast<double>(i) / static_cast<double>(colors.size()));
    std::vector<SliceColors> rows(static_cast<size_t>(profile_.height));
    parallelFor(rows.size(), 1, [&](size_t begin, size_t end) {
      for (size_t row = begin; row < end; ++row) {
        for (int column = 0; column < profile_.width; ++column) {
          const glm::vec3 light = lightOf(static_cast<int>(i), column, static_cast<int>(row));
          if (light != glm::vec3(0)) {
            rows[row].push_back(
                {static_cast<uint32_t>(row * static_cast<size_t>(profile_.width)) + static_cast<uint32_t>(column),
                 light});
          }
        }
      }
    });
    for (const SliceColors& row : rows) {
      colors[i].insert(colors[i].end(), row.begin(), row.end());
    }
  }
  return colors;
}

Volume VolumeSliceReference::slice(const SliceOptions& options, const Progress& progress) const {
  return ditheredVolume(colors(progress), profile_, options);
}

Volume ditheredVolume(const VoxelColors& colors, const DisplayProfile& profile, const SliceOptions& options) {
  if (options.colors == ColorReduction::kDiffusion) {
    return diffuse(colors, profile).volume;
  }
  const VoxelDither dither(options.colors);
  Volume volume(profile);
  const auto width = static_cast<uint32_t>(profile.width);
  parallelFor(colors.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const int slice = static_cast<int>(i);
      for (const ColoredVoxel& voxel : colors[i]) {
        const int column = static_cast<int>(voxel.position % width);
        const int row = static_cast<int>(voxel.position / width);
        volume.raise(slice, column, row, dither.levels(voxel.color, volume.fullLevel(), slice, column, row));
      }
    }
  });
  return volume;
}

}  // namespace ocelli
