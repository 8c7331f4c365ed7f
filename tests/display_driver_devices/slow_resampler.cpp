#include "tests/display_driver_devices/slow_resampler.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "display_sim/frames/sweep_geometry.h"

namespace ocelli::test {
namespace {

bool within(double coordinate, int cell) {
  return coordinate >= cell && coordinate < cell + 1;
}

struct Light {
  glm::dvec3 sum{0};
  int lit = 0;
  std::set<int> planes, rows;
  int voxels = 0;

  int thinnestCut() const {
    const double angles = static_cast<double>(planes.size());
    const double heights = static_cast<double>(rows.size());
    const double radii = voxels / angles / heights;
    return static_cast<int>(voxels / std::max({angles, heights, radii}));
  }
};

}  // namespace

std::vector<uint8_t> slowlyResampled(const Volume& volume, const VoxelGrid& grid, int shownBits) {
  const DisplayProfile& profile = volume.profile();
  const SweepGeometry sweep(profile);
  const double scale = std::min(1.0, grid.halfHeight() / profile.halfHeightRadii);
  const bool own = profile.secondHalfTurn == SecondHalfTurn::kOwn;
  std::vector<uint8_t> cells(grid.cells(), 0);
  for (int y = 0; y < grid.y; ++y) {
    for (int x = 0; x < grid.x; ++x) {
      std::vector<Light> column(static_cast<size_t>(grid.z));
      for (int plane = 0; plane < sweep.slicesPerHalfTurn(); ++plane) {
        for (int c = 0; c < sweep.width(); ++c) {
          const glm::dvec3 place = grid.gridFromModel(scale * sweep.voxelCenter(plane, c, 0));
          const glm::dvec3 center = grid.cellCenter(x, y, 0) / scale;
          const glm::dvec2 direction = sweep.sectorDirection(plane);
          const double along = center.x * direction.x + center.z * direction.y;
          const double across = center.x * direction.y - center.z * direction.x;
          const bool voxelInCell = within(place.x, x) && within(place.y, y);
          const bool cellInVoxel =
              std::abs(across) <= std::abs(along) * sweep.tanHalfStep() && within((1 + along) * sweep.width() / 2, c);
          if (!voxelInCell && !cellInVoxel) {
            continue;
          }
          for (int row = 0; row < sweep.height(); ++row) {
            glm::dvec3 light(volume.levels(plane, c, row));
            if (own) {
              light += glm::dvec3(volume.levels(plane + sweep.slicesPerHalfTurn(), sweep.width() - 1 - c, row));
              light /= 2;
            }
            for (int z = 0; z < grid.z; ++z) {
              const double height = grid.gridFromModel({0, scale * sweep.rowCenterY(row), 0}).z;
              if (within(height, z) || within(sweep.rowOfY(grid.cellCenter(0, 0, z).y / scale), row)) {
                Light& cell = column[static_cast<size_t>(z)];
                cell.sum += light;
                cell.lit += light == glm::dvec3(0) ? 0 : 1;
                cell.planes.insert(plane);
                cell.rows.insert(row);
                ++cell.voxels;
              }
            }
          }
        }
      }
      for (int z = 0; z < grid.z; ++z) {
        const Light& light = column[static_cast<size_t>(z)];
        if (light.lit > 0) {
          // Sums of whole and half levels are exact; twice them are whole.
          const int places = std::max(light.lit, light.thinnestCut());
          cells[grid.index(x, y, z)] =
              rgb332(glm::u64vec3(2.0 * light.sum), static_cast<uint64_t>(2 * places * volume.fullLevel()), shownBits);
        }
      }
    }
  }
  return cells;
}

}  // namespace ocelli::test
