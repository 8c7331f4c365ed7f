#include "display_sim/exact_slicer.h"

#include <algorithm>
#include <mutex>

#include "display_sim/dither.h"
#include "display_sim/exact_triangle.h"
#include "display_sim/sweep_geometry.h"
#include "oc_core/base/conventions.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

/// A lit voxel of a known slice.
struct Fragment {
  uint16_t column;
  uint16_t row;
  Rgb8 levels;
};

/// The volume under construction. Raising levels gives the same result in any order, so threads add to it as they come.
class SharedVolume {
 public:
  explicit SharedVolume(const DisplayProfile& profile) : volume_(profile), locks_(volume_.layout().slices) {}

  void add(size_t slice, const std::vector<Fragment>& fragments) {
    const VolumeLayout& layout = volume_.layout();
    const std::scoped_lock lock(locks_[slice]);
    if (layout.planes > kColorChannels) {
      for (const Fragment& f : fragments) {
        volume_.raise(static_cast<int>(slice), f.column, f.row, f.levels);
      }
      return;
    }
    uint8_t* planes = volume_.slice(static_cast<int>(slice)).data();
    for (const Fragment& f : fragments) {
      uint8_t* byte = planes + f.row * layout.rowBytes + f.column / 8;
      for (int channel = 0; channel < kColorChannels; ++channel, byte += layout.planeBytes) {
        *byte |= static_cast<uint8_t>(f.levels[channel] << f.column % 8);
      }
    }
  }

  Volume take() { return std::move(volume_); }

 private:
  Volume volume_;
  std::vector<std::mutex> locks_;
};

/// Fragments of one thread, gathered by slice so that a slice is in the cache when they are added to it.
class FragmentBins {
 public:
  explicit FragmentBins(SharedVolume& volume, size_t slices) : volume_(volume), bins_(slices) {}

  void push(int slice, const Fragment& fragment) {
    std::vector<Fragment>& bin = bins_[static_cast<size_t>(slice)];
    bin.push_back(fragment);
    if (bin.size() == kMostFragments) {
      volume_.add(static_cast<size_t>(slice), bin);
      bin.clear();
    }
  }

  void flush() {
    for (size_t slice = 0; slice < bins_.size(); ++slice) {
      volume_.add(slice, bins_[slice]);
      bins_[slice].clear();
    }
  }

 private:
  static constexpr size_t kMostFragments = 2048;
  SharedVolume& volume_;
  std::vector<std::vector<Fragment>> bins_;
};

std::vector<SweepVertex> sweepVertices(const Mesh& mesh, const SweepGeometry& sweep) {
  std::vector<SweepVertex> vertices(mesh.positions.size());
  parallelFor(vertices.size(), 1 << 12, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      vertices[i] = sweepVertex(sweep, mesh.positions[i]);
    }
  });
  return vertices;
}

/// Slices triangles one by one into its bins. One for each thread.
class TriangleSlicer {
 public:
  TriangleSlicer(const Mesh& mesh, const SweepGeometry& sweep, const std::vector<SweepVertex>& vertices,
                 const SliceOptions& options, SharedVolume& volume, const DisplayProfile& profile)
      : mesh_(mesh),
        sweep_(sweep),
        vertices_(vertices),
        options_(options),
        fullLevel_((1 << profile.colorBitsPerChannel) - 1),
        ownSecondHalf_(profile.secondHalfTurn == SecondHalfTurn::kOwn),
        raster_(profile.width, profile.height),
        bins_(volume, static_cast<size_t>(profile.storedSlices())) {}

  void slice(const glm::uvec3& t) {
    const SweepVertex& a = vertices_[t.x];
    const SweepVertex& b = vertices_[t.y];
    const SweepVertex& c = vertices_[t.z];
    const SweepTriangle triangle{{a.point, b.point, c.point}};
    position_ = mesh_.positions[t.x];
    positionB_ = mesh_.positions[t.y] - position_;
    positionC_ = mesh_.positions[t.z] - position_;
    color_ = mesh_.color(t.x);
    colorB_ = mesh_.color(t.y) - color_;
    colorC_ = mesh_.color(t.z) - color_;
    const SectorRange range = sectorsOf(a, b, c, sweep_.sectors());
    forEachTouchedCell(sweep_, raster_, triangle, range, [&](int sector, int column, int row, double b1, double b2) {
      light(sector, column, row, b1, b2);
    });
  }

  void flush() { bins_.flush(); }

 private:
  void light(int sector, int column, int row, double b1, double b2) {
    const glm::vec3 color = color_ + colorB_ * static_cast<float>(b1) + colorC_ * static_cast<float>(b2);
    if (!options_.angularAntialiasing) {
      lightCell(sweep_.sliceOfSector(sector), column, row, color);
      return;
    }
    const glm::vec3 point = position_ + positionB_ * static_cast<float>(b1) + positionC_ * static_cast<float>(b2);
    forEachShare(sweep_, point, sector, column,
                 [&](int slice, int at, float share) { lightCell(slice, at, row, color * share); });
  }

  void lightCell(int slice, int column, int row, const glm::vec3& color) {
    store(slice, column, row, color);
    if (ownSecondHalf_) {
      store(slice + sweep_.slicesPerHalfTurn(), sweep_.width() - 1 - column, row, color);
    }
  }

  void store(int slice, int column, int row, const glm::vec3& color) {
    const Rgb8 levels = options_.colors == ColorReduction::kDither
                            ? ditheredLevels(color, fullLevel_, slice, column, row)
                            : occupancyLevels(color, fullLevel_);
    if (levels != Rgb8(0)) {
      bins_.push(slice, {static_cast<uint16_t>(column), static_cast<uint16_t>(row), levels});
    }
  }

  const Mesh& mesh_;
  const SweepGeometry& sweep_;
  const std::vector<SweepVertex>& vertices_;
  SliceOptions options_;
  int fullLevel_;
  bool ownSecondHalf_;
  PolygonRaster raster_;
  FragmentBins bins_;
  glm::vec3 position_{0};
  glm::vec3 positionB_{0};
  glm::vec3 positionC_{0};
  glm::vec3 color_{1};
  glm::vec3 colorB_{0};
  glm::vec3 colorC_{0};
};

}  // namespace

Volume sliceExactly(const Mesh& mesh, const DisplayProfile& profile, const SliceOptions& options) {
  const SweepGeometry sweep(profile);
  const std::vector<SweepVertex> vertices = sweepVertices(mesh, sweep);
  SharedVolume volume(profile);
  // A few parts for each thread even out the load; each part has its own bins, so not too many.
  const size_t parts = std::min<size_t>(static_cast<size_t>(threadCount()) * 4, mesh.triangles.size() / 256 + 1);
  parallelChunks(mesh.triangles.size(), parts, [&](size_t, size_t begin, size_t end) {
    TriangleSlicer slicer(mesh, sweep, vertices, options, volume, profile);
    for (size_t i = begin; i < end; ++i) {
      slicer.slice(mesh.triangles[i]);
    }
    slicer.flush();
  });
  return volume.take();
}

}  // namespace ocelli
