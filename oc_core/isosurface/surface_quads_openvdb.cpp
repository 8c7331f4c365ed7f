// By OpenVDB (K. Museth, "VDB: high-resolution sparse volumes with dynamic topology", 2013), tools::volumeToMesh. Only
// the blocks of 8x8x8 voxels that the surface runs through, or beside, get voxels in its tree; all others are inside or
// outside as a whole.
#include <openvdb/openvdb.h>
#include <openvdb/tools/VolumeToMesh.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "oc_core/base/parallel.h"
#include "oc_core/isosurface/isosurface.h"
#include "oc_core/isosurface/surface_quads.h"

namespace ocelli {
namespace {

using Tree = openvdb::FloatTree;
using Leaf = Tree::LeafNodeType;
constexpr int kBlock = static_cast<int>(Leaf::DIM);

/// The value of the surface minus that of a voxel: negative inside. The voxels stand at (1, 1, 1) and on, with those
/// around them that close the surface: outside, and such that a straight line from an inner voxel crosses 0 in the
/// middle, which is the face of the box.
template <class T>
class PaddedField {
 public:
  PaddedField(const ScalarVolume& volume, const T* voxels, double value)
      : voxels_(voxels), size_(volume.grid().size), scale_(volume.scale()), offset_(volume.offset()), value_(value) {}

  double valueOf(int i, int j, int k) const {
    const size_t at = (size_t(k) * size_.y + j) * size_.x + i;
    return scale_ * static_cast<double>(voxels_[at]) + offset_;
  }
  float at(int x, int y, int z) const {
    const int i = std::clamp(x - 1, 0, size_.x - 1);
    const int j = std::clamp(y - 1, 0, size_.y - 1);
    const int k = std::clamp(z - 1, 0, size_.z - 1);
    // No value of the volume is lost by the difference of two others: it is taken before it is rounded.
    const auto difference = static_cast<float>(value_ - valueOf(i, j, k));
    return i == x - 1 && j == y - 1 && k == z - 1 ? difference : std::abs(difference);
  }

 private:
  const T* voxels_;
  glm::ivec3 size_;
  double scale_;
  double offset_;
  double value_;
};

/// A row of blocks, before it is put into the tree.
struct BlockRow {
  std::vector<std::unique_ptr<Leaf>> leaves;  ///< by their number in the row; null where the surface is not near
  std::vector<char> isInside;                 ///< of blocks without a leaf
  ValueRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  size_t brokenVoxels = 0;
  size_t crossings = 0;
};

/// Looks at the voxels of a block, and at those next to it, so that every cell of eight voxels that the surface runs
/// through lies in leaves.
template <class T>
void look(const PaddedField<T>& field, const glm::ivec3& first, int number, BlockRow& row) {
  bool anyInside = false;
  bool anyOutside = false;
  for (int z = first.z - 1; z <= first.z + kBlock; ++z) {
    for (int y = first.y - 1; y <= first.y + kBlock; ++y) {
      for (int x = first.x - 1; x <= first.x + kBlock; ++x) {
        (field.at(x, y, z) < 0 ? anyInside : anyOutside) = true;
      }
    }
  }
  row.isInside[number] = anyInside;
  if (!anyInside || !anyOutside) {
    return;
  }
  auto leaf = std::make_unique<Leaf>(openvdb::Coord(first.x, first.y, first.z), 0.0f, true);
  float* values = leaf->buffer().data();
  for (int x = 0; x < kBlock; ++x) {
    for (int y = 0; y < kBlock; ++y) {
      for (int z = 0; z < kBlock; ++z) {
        const glm::ivec3 p = first + glm::ivec3(x, y, z);
        const float value = field.at(p.x, p.y, p.z);
        values[(x * kBlock + y) * kBlock + z] = value;
        const bool isInside = value < 0;
        row.crossings += (field.at(p.x + 1, p.y, p.z) < 0) != isInside;
        row.crossings += (field.at(p.x, p.y + 1, p.z) < 0) != isInside;
        row.crossings += (field.at(p.x, p.y, p.z + 1) < 0) != isInside;
      }
    }
  }
  row.leaves[number] = std::move(leaf);
}

template <class T>
void addRange(const PaddedField<T>& field, const glm::ivec3& from, const glm::ivec3& to, BlockRow& row) {
  for (int k = from.z; k < to.z; ++k) {
    for (int j = from.y; j < to.y; ++j) {
      for (int i = from.x; i < to.x; ++i) {
        const double value = field.valueOf(i, j, k);
        row.brokenVoxels += !std::isfinite(value);
        row.range.least = std::min(row.range.least, value);
        row.range.greatest = std::max(row.range.greatest, value);
      }
    }
  }
}

/// Fills the tree layer by layer: what is read at a time is a layer of the volume nine voxels thick.
template <class T>
void fill(Tree& tree, const ScalarVolume& volume, const T* voxels, double value, size_t maxQuads, SurfaceQuads& surface,
          const Progress& progress) {
  const PaddedField<T> field(volume, voxels, value);
  const glm::ivec3 size = volume.grid().size;
  const glm::ivec3 blocks = (size + 2 + kBlock - 1) / kBlock;
  const size_t bytesOfSlice = bytesOf(volume.type()) * size.x * size.y;
  for (int layer = 0; layer < blocks.z && surface.crossings <= maxQuads; ++layer) {
    report(progress, "looking for the surface", static_cast<double>(layer) / blocks.z);
    // Of the slices that the layer reads.
    const size_t firstByte = bytesOfSlice * std::max(layer * kBlock - 2, 0);
    const size_t lastByte = bytesOfSlice * std::min((layer + 1) * kBlock, size.z);
    if (volume.store() != nullptr && volume.offset() <= value && volume.store()->isKnownZero(firstByte, lastByte)) {
      surface.range.least = std::min(surface.range.least, volume.offset());
      surface.range.greatest = std::max(surface.range.greatest, volume.offset());
      continue;  // a hole of a sparse file, which lies outside
    }
    std::vector<BlockRow> rows(static_cast<size_t>(blocks.y));
    parallelFor(rows.size(), 1, [&](size_t begin, size_t end) {
      for (size_t y = begin; y < end; ++y) {
        BlockRow& row = rows[y];
        row.leaves.resize(static_cast<size_t>(blocks.x));
        row.isInside.resize(static_cast<size_t>(blocks.x));
        const glm::ivec3 first(0, static_cast<int>(y) * kBlock, layer * kBlock);
        // Each voxel counts once; padded coordinates are one more than those of voxels.
        const glm::ivec3 from = glm::max(first - 1, glm::ivec3(0));
        const glm::ivec3 to = glm::min(first - 1 + kBlock, size);
        addRange(field, {0, from.y, from.z}, {size.x, to.y, to.z}, row);
        for (int x = 0; x < blocks.x; ++x) {
          look(field, {x * kBlock, first.y, first.z}, x, row);
        }
      }
    });
    for (size_t y = 0; y < rows.size(); ++y) {
      BlockRow& row = rows[y];
      surface.brokenVoxels += row.brokenVoxels;
      surface.crossings += row.crossings;
      surface.range.least = std::min(surface.range.least, row.range.least);
      surface.range.greatest = std::max(surface.range.greatest, row.range.greatest);
      for (size_t x = 0; x < row.leaves.size(); ++x) {
        if (row.leaves[x] != nullptr) {
          tree.addLeaf(row.leaves[x].release());
        } else if (row.isInside[x] != 0) {
          const openvdb::Coord first(static_cast<int>(x) * kBlock, static_cast<int>(y) * kBlock, layer * kBlock);
          tree.addTile(1, first, -tree.background(), false);
        }
      }
    }
    if (volume.store() != nullptr) {
      volume.store()->release(firstByte, lastByte);
    }
  }
}

}  // namespace

bool canExtractIsosurfaces() {
  return true;
}

SurfaceQuads surfaceQuads(const ScalarVolume& volume, double value, size_t maxQuads, const Progress& progress) {
  SurfaceQuads surface;
  surface.range = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  // The background, and minus it, stand for outside and inside.
  const auto grid = openvdb::FloatGrid::create(1.0f);
  visitVoxels(volume,
              [&](const auto* voxels) { fill(grid->tree(), volume, voxels, value, maxQuads, surface, progress); });
  if (surface.brokenVoxels > 0 || surface.crossings > maxQuads) {
    return surface;
  }
  report(progress, "extracting the surface", 0);
  std::vector<openvdb::Vec3s> points;
  std::vector<openvdb::Vec4I> quads;
  openvdb::tools::volumeToMesh(*grid, points, quads, 0.0);
  surface.points.reserve(points.size());
  for (const openvdb::Vec3s& p : points) {
    surface.points.push_back(glm::vec3(p.x(), p.y(), p.z()) - 1.0f);
  }
  points = {};
  surface.quads.reserve(quads.size());
  for (const openvdb::Vec4I& q : quads) {
    surface.quads.push_back({q[0], q[1], q[2], q[3]});
  }
  report(progress, "extracting the surface", 1);
  return surface;
}

}  // namespace ocelli
