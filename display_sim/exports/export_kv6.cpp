#include "display_sim/exports/export_kv6.h"

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

/// A grid with the axes of the model.
class Kv6Grid {
 public:
  explicit Kv6Grid(const CartesianVolume& grid) : grid_(grid) {}

  int sizeX() const { return grid_.sizeX; }
  int sizeY() const { return grid_.sizeZ; }
  int sizeZ() const { return grid_.sizeY; }

  const Rgb8& color(int x, int y, int z) const { return grid_.cells[grid_.index(x, grid_.sizeY - 1 - z, y)]; }
  bool isLit(int x, int y, int z) const {
    return x >= 0 && x < sizeX() && y >= 0 && y < sizeY() && z >= 0 && z < sizeZ() && color(x, y, z) != Rgb8(0);
  }

  uint8_t faces(int x, int y, int z) const {
    unsigned faces = 0;
    const auto look = [&](uint8_t face, int nextX, int nextY, int nextZ) {
      faces |= isLit(nextX, nextY, nextZ) ? 0u : unsigned{face};
    };
    look(kKv6LowX, x - 1, y, z);
    look(kKv6HighX, x + 1, y, z);
    look(kKv6LowY, x, y - 1, z);
    look(kKv6HighY, x, y + 1, z);
    look(kKv6LowZ, x, y, z - 1);
    look(kKv6HighZ, x, y, z + 1);
    return static_cast<uint8_t>(faces);
  }

  uint8_t normal(int x, int y, int z) const {
    constexpr int kReach = 2;
    glm::ivec3 sum(0);
    for (int dx = -kReach; dx <= kReach; ++dx) {
      for (int dy = -kReach; dy <= kReach; ++dy) {
        for (int dz = -kReach; dz <= kReach; ++dz) {
          if (isLit(x + dx, y + dy, z + dz)) {
            sum += glm::ivec3(dx, dy, dz);
          }
        }
      }
    }
    return kv6NormalIndex(glm::dvec3(sum));
  }

 private:
  const CartesianVolume& grid_;
};

/// Adds the voxels of an x, and returns how many each of its columns has.
std::vector<uint16_t> addPlane(const Kv6Grid& grid, int x, std::vector<Kv6Voxel>& voxels) {
  std::vector<uint16_t> counts;
  for (int y = 0; y < grid.sizeY(); ++y) {
    const size_t before = voxels.size();
    for (int z = 0; z < grid.sizeZ(); ++z) {
      if (grid.isLit(x, y, z)) {
        const uint8_t faces = grid.faces(x, y, z);
        voxels.push_back({.color = grid.color(x, y, z),
                          .z = static_cast<uint16_t>(z),
                          .faces = faces,
                          .normal = faces == 0 ? kKv6NoNormal : grid.normal(x, y, z)});
      }
    }
    counts.push_back(static_cast<uint16_t>(voxels.size() - before));
  }
  return counts;
}

}  // namespace

Kv6Model kv6Model(const CartesianVolume& cells) {
  const Kv6Grid grid(cells);
  std::vector<std::vector<Kv6Voxel>> voxels(static_cast<size_t>(grid.sizeX()));
  std::vector<std::vector<uint16_t>> counts(voxels.size());
  parallelFor(voxels.size(), 1, [&](size_t begin, size_t end) {
    for (size_t x = begin; x < end; ++x) {
      counts[x] = addPlane(grid, static_cast<int>(x), voxels[x]);
    }
  });
  Kv6Model model;
  model.sizeX = grid.sizeX();
  model.sizeY = grid.sizeY();
  model.sizeZ = grid.sizeZ();
  model.pivot = glm::vec3(model.sizeX, model.sizeY, model.sizeZ) / 2.0f;
  for (size_t x = 0; x < voxels.size(); ++x) {
    model.voxels.insert(model.voxels.end(), voxels[x].begin(), voxels[x].end());
    model.voxelsOfColumn.insert(model.voxelsOfColumn.end(), counts[x].begin(), counts[x].end());
  }
  return model;
}

void exportKv6(const std::filesystem::path& path, const Volume& volume, const Kv6Options& options,
               const Progress& progress) {
  checkGridSize(options.cellsAcross, volume.profile(), path);
  report(progress, "resampling", 0);
  const CartesianVolume grid = resample(volume, options.cellsAcross);
  report(progress, "finding faces and normals", 0.5);
  writeFile(path, kv6Bytes(kv6Model(grid)));
  report(progress, "finding faces and normals", 1);
}

}  // namespace ocelli
