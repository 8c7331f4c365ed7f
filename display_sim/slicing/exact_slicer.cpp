#include "display_sim/slicing/exact_slicer.h"

#include <algorithm>
#include <mutex>
#include <numeric>
#include <optional>

#include "display_sim/dither/diffusion.h"
#include "display_sim/dither/even_light.h"
#include "display_sim/dither/voxel_dither.h"
#include "display_sim/frames/sweep_geometry.h"
#include "display_sim/slicing/exact_triangle.h"
#include "oc_core/base/conventions.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

/// A lit voxel of a known slice.
struct LitVoxel {
  uint16_t column;
  uint16_t row;
  Rgb8 levels;
};

/// The volume under construction. Raising levels gives the same result in any order, so threads add to it as they come.
class LevelSink {
 public:
  using Entry = LitVoxel;

  LevelSink(const DisplayProfile& profile, ColorReduction colors)
      : volume_(profile), dither_(colors), locks_(volume_.layout().slices) {}

  std::optional<Entry> entry(int slice, int column, int row, const glm::vec3& color) const {
    const Rgb8 levels = dither_.levels(color, volume_.fullLevel(), slice, column, row);
    if (levels == Rgb8(0)) {
      return std::nullopt;
    }
    return Entry{static_cast<uint16_t>(column), static_cast<uint16_t>(row), levels};
  }

  void add(size_t slice, const std::vector<Entry>& entries) {
    const VolumeLayout& layout = volume_.layout();
    const std::scoped_lock lock(locks_[slice]);
    if (layout.planes > kColorChannels) {
      for (const Entry& f : entries) {
        volume_.raise(static_cast<int>(slice), f.column, f.row, f.levels);
      }
      return;
    }
    uint8_t* planes = volume_.slice(static_cast<int>(slice)).data();
    for (const Entry& f : entries) {
      uint8_t* byte = planes + f.row * layout.rowBytes + f.column / 8;
      for (int channel = 0; channel < kColorChannels; ++channel, byte += layout.planeBytes) {
        *byte |= static_cast<uint8_t>(f.levels[channel] << f.column % 8);
      }
    }
  }

  Volume take() { return std::move(volume_); }

 private:
  Volume volume_;
  VoxelDither dither_;
  std::vector<std::mutex> locks_;
};

/// Colours under construction. The order in which they come makes no difference, since sortAndUnite() takes maxima.
class ColorSink {
 public:
  using Entry = ColoredVoxel;

  explicit ColorSink(const DisplayProfile& profile)
      : width_(static_cast<uint32_t>(profile.width)), slices_(static_cast<size_t>(profile.storedSlices())) {}

  std::optional<Entry> entry(int /*slice*/, int column, int row, const glm::vec3& color) const {
    if (!(color.x > 0 || color.y > 0 || color.z > 0)) {
      return std::nullopt;
    }
    return Entry{static_cast<uint32_t>(row) * width_ + static_cast<uint32_t>(column), color};
  }

  void add(size_t index, const std::vector<Entry>& entries) {
    Slice& slice = slices_[index];
    const std::scoped_lock lock(slice.lock);
    slice.voxels.insert(slice.voxels.end(), entries.begin(), entries.end());
    // Often enough that no place takes much more room than it needs, seldom enough to take little time.
    if (slice.voxels.size() > 2 * slice.united + kMinUnited) {
      sortAndUnite(slice.voxels);
      slice.united = slice.voxels.size();
    }
  }

  VoxelColors take() {
    VoxelColors colors(slices_.size());
    parallelFor(slices_.size(), 1, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        sortAndUnite(slices_[i].voxels);
        colors[i] = std::move(slices_[i].voxels);
      }
    });
    return colors;
  }

 private:
  static constexpr size_t kMinUnited = 1 << 14;
  struct Slice {
    std::mutex lock;
    SliceColors voxels;
    size_t united = 0;  ///< how many voxels there were when they were last united
  };
  uint32_t width_;
  std::vector<Slice> slices_;
};

/// Entries of one thread, gathered by slice so that a slice is in the cache when they are added to it.
template <class Sink>
class SliceBins {
 public:
  using Entry = typename Sink::Entry;

  explicit SliceBins(Sink& sink, size_t slices) : sink_(sink), bins_(slices) {}

  void push(int slice, const Entry& entry) {
    std::vector<Entry>& bin = bins_[static_cast<size_t>(slice)];
    bin.push_back(entry);
    if (bin.size() == kMaxEntries) {
      sink_.add(static_cast<size_t>(slice), bin);
      bin.clear();
    }
  }

  void flush() {
    for (size_t slice = 0; slice < bins_.size(); ++slice) {
      sink_.add(slice, bins_[slice]);
      bins_[slice].clear();
    }
  }

 private:
  static constexpr size_t kMaxEntries = 2048;
  Sink& sink_;
  std::vector<std::vector<Entry>> bins_;
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

/// What the slicing of every triangle needs.
struct Scene {
  /// `slices` are those to be made.
  Scene(const Mesh& sceneMesh, const DisplayProfile& profile, const SliceOptions& options, std::span<const int> slices)
      : mesh(sceneMesh),
        sweep(profile),
        vertices(sweepVertices(mesh, sweep)),
        antialiased(options.angularAntialiasing),
        wanted(static_cast<size_t>(profile.storedSlices())),
        sectors(static_cast<size_t>(sweep.sectors())) {
    for (const int slice : slices) {
      wanted[static_cast<size_t>(slice)] = 1;
    }
    // With antialiasing a sector lights the slices beside its own too.
    const int neighbours = antialiased ? 1 : 0;
    for (int sector = 0; sector < sweep.sectors(); ++sector) {
      for (int i = sector - neighbours; i <= sector + neighbours; ++i) {
        const auto slice = static_cast<size_t>(sweep.sliceOfSector((i + sweep.sectors()) % sweep.sectors()));
        if (wantsSlice(slice)) {
          sectors[static_cast<size_t>(sector)] = 1;
        }
      }
    }
    if (options.evenLightRadius > 0 && options.colors != ColorReduction::kOccupancy) {
      evenLight.emplace(sweep, options.evenLightRadius);
    }
  }

  const Mesh& mesh;
  SweepGeometry sweep;
  std::vector<SweepVertex> vertices;
  bool antialiased;
  std::vector<char> wanted;   ///< by stored slice
  std::vector<char> sectors;  ///< those that light a wanted slice
  std::optional<EvenLight> evenLight;

 private:
  /// Or the slice of the other half turn.
  bool wantsSlice(size_t slice) const {
    const size_t other = slice + static_cast<size_t>(sweep.slicesPerHalfTurn());
    return wanted[slice] != 0 || (other < wanted.size() && wanted[other] != 0);
  }
};

/// Slices triangles one by one into its bins. One for each thread.
template <class Sink>
class TriangleSlicer {
 public:
  TriangleSlicer(const Scene& scene, Sink& sink, const DisplayProfile& profile)
      : scene_(scene),
        sweep_(scene.sweep),
        sink_(sink),
        ownSecondHalf_(profile.secondHalfTurn == SecondHalfTurn::kOwn),
        raster_(profile.width, profile.height),
        bins_(sink, static_cast<size_t>(profile.storedSlices())) {}

  void slice(const glm::uvec3& t) {
    const SweepVertex& a = scene_.vertices[t.x];
    const SweepVertex& b = scene_.vertices[t.y];
    const SweepVertex& c = scene_.vertices[t.z];
    const SweepTriangle triangle{{a.point, b.point, c.point}};
    position_ = scene_.mesh.positions[t.x];
    positionB_ = scene_.mesh.positions[t.y] - position_;
    positionC_ = scene_.mesh.positions[t.z] - position_;
    color_ = scene_.mesh.color(t.x);
    colorB_ = scene_.mesh.color(t.y) - color_;
    colorC_ = scene_.mesh.color(t.z) - color_;
    if (scene_.evenLight) {
      const std::vector<glm::vec3>& positions = scene_.mesh.positions;
      normal_ = unitNormal(positions[t.x], positions[t.y], positions[t.z]);
      facingSlice_ = -1;
    }
    const SectorRange range = sectorsOf(a, b, c, sweep_.sectors());
    for (int done = 0; done < range.count;) {
      SectorRange part{(range.first + done) % sweep_.sectors(), 0};
      while (done + part.count < range.count && isWanted(range.first + done + part.count)) {
        ++part.count;
      }
      forEachTouchedCell(sweep_, raster_, triangle, part, [&](int sector, int column, int row, double b1, double b2) {
        light(sector, column, row, b1, b2);
      });
      done += std::max(part.count, 1);
    }
  }

  void flush() { bins_.flush(); }

 private:
  bool isWanted(int sector) const { return scene_.sectors[static_cast<size_t>(sector % sweep_.sectors())] != 0; }

  void light(int sector, int column, int row, double b1, double b2) {
    const int slice = sweep_.sliceOfSector(sector);
    glm::vec3 color = color_ + colorB_ * static_cast<float>(b1) + colorC_ * static_cast<float>(b2);
    if (scene_.evenLight) {
      color *= weight(slice, column);
    }
    if (!scene_.antialiased) {
      lightCell(slice, column, row, color);
      return;
    }
    const glm::vec3 point = position_ + positionB_ * static_cast<float>(b1) + positionC_ * static_cast<float>(b2);
    forEachShare(sweep_, point, sector, column,
                 [&](int shareSlice, int at, float share) { lightCell(shareSlice, at, row, color * share); });
  }

  void lightCell(int slice, int column, int row, const glm::vec3& color) {
    store(slice, column, row, color);
    if (ownSecondHalf_) {
      store(slice + sweep_.slicesPerHalfTurn(), sweep_.width() - 1 - column, row, color);
    }
  }

  float weight(int slice, int column) {
    if (slice != facingSlice_) {
      facing_ = scene_.evenLight->facing(normal_, slice);
      facingSlice_ = slice;
    }
    return evenLightWeight(facing_, EvenLight::columnRadius(sweep_, column));
  }

  void store(int slice, int column, int row, const glm::vec3& color) {
    if (scene_.wanted[static_cast<size_t>(slice)] == 0) {
      return;
    }
    if (const auto entry = sink_.entry(slice, column, row, color)) {
      bins_.push(slice, *entry);
    }
  }

  const Scene& scene_;
  const SweepGeometry& sweep_;
  Sink& sink_;
  bool ownSecondHalf_;
  PolygonRaster raster_;
  SliceBins<Sink> bins_;
  glm::vec3 position_{0};
  glm::vec3 positionB_{0};
  glm::vec3 positionC_{0};
  glm::vec3 color_{1};
  glm::vec3 colorB_{0};
  glm::vec3 colorC_{0};
  glm::dvec3 normal_{0};
  int facingSlice_ = -1;  ///< the slice that facing_ is for
  EvenLightFacing facing_;
};

template <class Sink>
void sliceInto(Sink& sink, const Mesh& mesh, const DisplayProfile& profile, const SliceOptions& options,
               std::span<const int> slices) {
  const Scene scene(mesh, profile, options, slices);
  // A few parts for each thread even out the load; each part has its own bins, so not too many.
  const size_t parts = std::min<size_t>(static_cast<size_t>(threadCount()) * 4, mesh.triangles.size() / 256 + 1);
  parallelChunks(mesh.triangles.size(), parts, [&](size_t, size_t begin, size_t end) {
    TriangleSlicer slicer(scene, sink, profile);
    for (size_t i = begin; i < end; ++i) {
      slicer.slice(mesh.triangles[i]);
    }
    slicer.flush();
  });
}

std::vector<int> allSlices(const DisplayProfile& profile) {
  std::vector<int> slices(static_cast<size_t>(profile.storedSlices()));
  std::iota(slices.begin(), slices.end(), 0);
  return slices;
}

}  // namespace

Volume sliceExactly(const Mesh& mesh, const DisplayProfile& profile, const SliceOptions& options) {
  if (options.colors == ColorReduction::kDiffusion) {
    return diffuse(colorsExactly(mesh, profile, options), profile).volume;
  }
  return makeSlicesExactly(mesh, profile, options, allSlices(profile));
}

Volume makeSlicesExactly(const Mesh& mesh, const DisplayProfile& profile, const SliceOptions& options,
                         std::span<const int> slices) {
  OC_CHECK(options.colors != ColorReduction::kDiffusion, "error diffusion needs all slices");
  LevelSink sink(profile, options.colors);
  sliceInto(sink, mesh, profile, options, slices);
  return sink.take();
}

VoxelColors colorsExactly(const Mesh& mesh, const DisplayProfile& profile, const SliceOptions& options) {
  return colorsOfSlices(mesh, profile, options, allSlices(profile));
}

VoxelColors colorsOfSlices(const Mesh& mesh, const DisplayProfile& profile, const SliceOptions& options,
                           std::span<const int> slices) {
  ColorSink sink(profile);
  sliceInto(sink, mesh, profile, options, slices);
  return sink.take();
}

}  // namespace ocelli
