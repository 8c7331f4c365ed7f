#include "display_driver/devices/voxel_resampler.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "display_sim/frames/sweep_geometry.h"
#include "oc_core/base/check.h"
#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

/// Pairs of (list, item), each wanted once, as lists.
template <class Lists>
Lists listsOf(std::vector<std::pair<uint32_t, uint32_t>> pairs, size_t count) {
  std::ranges::sort(pairs);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  Lists lists;
  lists.begins.assign(count + 1, 0);
  for (const auto& [list, item] : pairs) {
    ++lists.begins[list + 1];
    lists.items.push_back(item);
  }
  for (size_t list = 0; list < count; ++list) {
    lists.begins[list + 1] += lists.begins[list];
  }
  return lists;
}

std::optional<int> cellOf(double coordinate, int cells) {
  const double cell = std::floor(coordinate);
  return cell >= 0 && cell < cells ? std::optional(static_cast<int>(cell)) : std::nullopt;
}

}  // namespace

VoxelResampler::VoxelResampler(const DisplayProfile& profile, const VoxelGrid& grid)
    : grid_(grid),
      scale_(std::min(1.0, grid.halfHeight() / profile.halfHeightRadii)),
      volume_(profile),
      ownSecondHalf_(profile.secondHalfTurn == SecondHalfTurn::kOwn),
      columns_(columnsOfPlaces()),
      heights_(heightsOfRows()),
      extents_(extentsOfColumns()),
      rows_(rowsOfHeights()),
      sums_(grid.cells()),
      changed_(grid.columns(), 0),
      cells_(grid.cells(), 0) {}

VoxelResampler::Lists VoxelResampler::columnsOfPlaces() const {
  const SweepGeometry sweep(volume_.profile());
  const auto listOf = [&](int plane, int column) { return static_cast<uint32_t>(plane * sweep.width() + column); };
  const auto itemOf = [&](int x, int y) { return static_cast<uint32_t>(y * grid_.x + x); };
  std::vector<std::pair<uint32_t, uint32_t>> pairs;
  for (int plane = 0; plane < sweep.slicesPerHalfTurn(); ++plane) {
    for (int column = 0; column < sweep.width(); ++column) {
      const glm::dvec3 place = grid_.gridFromModel(scale_ * sweep.voxelCenter(plane, column, 0));
      const std::optional<int> x = cellOf(place.x, grid_.x);
      const std::optional<int> y = cellOf(place.y, grid_.y);
      if (x && y) {
        pairs.emplace_back(listOf(plane, column), itemOf(*x, *y));
      }
    }
  }
  for (int y = 0; y < grid_.y; ++y) {
    for (int x = 0; x < grid_.x; ++x) {
      const glm::dvec3 center = grid_.cellCenter(x, y, 0) / scale_;
      const double turn = std::atan2(center.z, center.x) / sweep.stepRadians();
      const int sector = (static_cast<int>(std::lround(turn)) + sweep.sectors()) % sweep.sectors();
      const glm::dvec2& direction = sweep.sectorDirection(sector);
      const double right = sweep.sideOfSector(sector) * (center.x * direction.x + center.z * direction.y);
      if (const auto column = cellOf((1 + right) * sweep.columnsPerRadius(), sweep.width())) {
        pairs.emplace_back(listOf(sweep.sliceOfSector(sector), *column), itemOf(x, y));
      }
    }
  }
  return listsOf<Lists>(std::move(pairs),
                        static_cast<size_t>(sweep.slicesPerHalfTurn()) * static_cast<size_t>(sweep.width()));
}

VoxelResampler::Lists VoxelResampler::heightsOfRows() const {
  const SweepGeometry sweep(volume_.profile());
  std::vector<std::pair<uint32_t, uint32_t>> pairs;
  for (int row = 0; row < sweep.height(); ++row) {
    const double height = grid_.gridFromModel({0, scale_ * sweep.rowCenterY(row), 0}).z;
    if (const auto z = cellOf(height, grid_.z)) {
      pairs.emplace_back(row, *z);
    }
  }
  for (int z = 0; z < grid_.z; ++z) {
    if (const auto row = cellOf(sweep.rowOfY(grid_.cellCenter(0, 0, z).y / scale_), sweep.height())) {
      pairs.emplace_back(*row, z);
    }
  }
  return listsOf<Lists>(std::move(pairs), static_cast<size_t>(sweep.height()));
}

std::vector<VoxelResampler::Extent> VoxelResampler::extentsOfColumns() const {
  std::vector<double> planes(grid_.columns(), 0);
  std::vector<int> lastPlane(grid_.columns(), -1);
  std::vector<Extent> extents(grid_.columns());
  for (size_t list = 0; list + 1 < columns_.begins.size(); ++list) {
    const auto plane = static_cast<int>(list) / volume_.width();
    for (const uint32_t column : columns_.of(list)) {
      planes[column] += std::exchange(lastPlane[column], plane) == plane ? 0 : 1;
      ++extents[column].places;
    }
  }
  for (size_t column = 0; column < extents.size(); ++column) {
    if (planes[column] > 0) {
      extents[column].longest = std::max(planes[column], extents[column].places / planes[column]);
    }
  }
  return extents;
}

std::vector<double> VoxelResampler::rowsOfHeights() const {
  std::vector<double> rows(static_cast<size_t>(grid_.z), 0);
  for (const uint32_t z : heights_.items) {
    ++rows[z];
  }
  return rows;
}

void VoxelResampler::addPlace(int plane, int column, int row, const glm::uvec3& levels, int sign) {
  const auto times = static_cast<uint32_t>(sign);  // -1 is 2^32 - 1, which takes away as well
  const size_t list = static_cast<size_t>(plane) * static_cast<size_t>(volume_.width()) + static_cast<size_t>(column);
  for (const uint32_t cellColumn : columns_.of(list)) {
    changed_[cellColumn] = 1;
    Sum* sums = &sums_[static_cast<size_t>(cellColumn) * static_cast<size_t>(grid_.z)];
    for (const uint32_t z : heights_.of(static_cast<size_t>(row))) {
      sums[z].red += times * levels.r;
      sums[z].green += times * levels.g;
      sums[z].blue += times * levels.b;
      sums[z].places += times;
    }
  }
}

void VoxelResampler::addPlane(int plane, int sign) {
  if (!ownSecondHalf_) {
    forEachLevel(volume_, plane, [&](int column, int row, const Rgb8& levels) {
      addPlace(plane, column, row, glm::uvec3(levels), sign);
    });
    return;
  }
  // Half a turn later the screen is back at the place, and its other side shows it.
  const int later = plane + volume_.profile().slicesPerHalfTurn;
  const int last = volume_.width() - 1;
  forEachLevel(volume_, plane, [&](int column, int row, const Rgb8& levels) {
    addPlace(plane, column, row, glm::uvec3(levels) + glm::uvec3(volume_.levels(later, last - column, row)), sign);
  });
  forEachLevel(volume_, later, [&](int column, int row, const Rgb8& levels) {
    if (volume_.colorBits(plane, last - column, row) == 0) {
      addPlace(plane, last - column, row, glm::uvec3(levels), sign);
    }
  });
}

void VoxelResampler::color(size_t column) {
  const auto height = static_cast<size_t>(grid_.z);
  const uint64_t fullOfPlace = static_cast<uint64_t>(volume_.fullLevel()) * (ownSecondHalf_ ? 2 : 1);
  const Extent& extent = extents_[column];
  for (size_t z = 0; z < height; ++z) {
    const Sum& sum = sums_[column * height + z];
    uint8_t& cell = cells_[column * height + z];
    if (sum.places == 0) {
      cell = 0;
      continue;
    }
    const double thinnestCut = extent.places * rows_[z] / std::max(extent.longest, rows_[z]);
    const uint64_t places = std::max(uint64_t{sum.places}, static_cast<uint64_t>(thinnestCut));
    cell = rgb332({sum.red, sum.green, sum.blue}, fullOfPlace * places, shownBits_);
  }
}

void VoxelResampler::update(const Volume& volume, std::optional<std::span<const int>> changedSlices, int shownBits) {
  OC_CHECK(volume.profile() == volume_.profile(), "a volume of another profile");
  const int planes = volume_.profile().slicesPerHalfTurn;
  std::vector<uint8_t> changedPlanes(static_cast<size_t>(planes), 0);
  const auto look = [&](int slice) {
    if (!std::ranges::equal(volume.slice(slice), volume_.slice(slice))) {
      changedPlanes[static_cast<size_t>(slice % planes)] = 1;
    }
  };
  if (changedSlices) {
    std::ranges::for_each(*changedSlices, look);
  } else {
    for (int slice = 0; slice < volume.slices(); ++slice) {
      look(slice);
    }
  }
  for (int plane = 0; plane < planes; ++plane) {
    if (changedPlanes[static_cast<size_t>(plane)] != 0) {
      addPlane(plane, -1);
      for (int slice = plane; slice < volume.slices(); slice += planes) {
        std::ranges::copy(volume.slice(slice), volume_.slice(slice).begin());
      }
      addPlane(plane, 1);
    }
  }
  if (shownBits != shownBits_) {
    shownBits_ = shownBits;
    std::ranges::fill(changed_, uint8_t{1});
  }
  for (size_t column = 0; column < changed_.size(); ++column) {
    if (std::exchange(changed_[column], uint8_t{0}) != 0) {
      color(column);
    }
  }
}

}  // namespace ocelli
