#include "display_sim/slicing/slice_pass.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstring>
#include <utility>

#include "display_sim/dither/voxel_dither.h"
#include "display_sim/slicing/exact_triangle.h"
#include "display_sim/slicing/packed_voxel_bins.h"
#include "display_sim/slicing/slicer_kernels.h"
#include "display_sim/slicing/triangle_strips.h"
#include "display_sim/slicing/wide_triangles.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

constexpr size_t kRoomSamples = 8192;
constexpr int kSectorsPerTask = 32;

/// A part of a triangle that is found exactly: its vertices and some of its sectors.
struct ExactTask {
  uint32_t corners[3];
  SectorRange sectors;
};

class Stopwatch {
 public:
  /// Milliseconds since the last time, or since it was made.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double, std::milli>(now - std::exchange(last_, now)).count();
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Made once for all slicers.
const TriangleStrips& allStrips() {
  static const TriangleStrips strips;
  return strips;
}

/// What one thread works with.
template <class Voxel>
struct Worker {
  Worker(const DisplayProfile& profile, size_t bins)
      : lit(bins),
        points(std::max(SliceMesh::kChunkVertices, kRoomSamples) + SliceMesh::kPadding),
        voxels(points.size()),
        sampled(SliceMesh::kChunkTriangles),
        wide(SliceMesh::kChunkTriangles),
        room(kRoomSamples),
        raster(profile.width, profile.height) {}

  PackedVoxelBins<Voxel> lit;
  std::vector<SweepPoint> points;
  LitSamples voxels;
  std::vector<SampledTriangle> sampled;
  WideTriangles wide;
  SampleRoom room;
  std::vector<ExactTask> exact;
  PolygonRaster raster;
  // Of one slice, where levels have many bits: those of its voxels, and which bytes of its planes have light.
  std::vector<uint32_t> levels;
  std::vector<char> hasLight;
  std::vector<uint32_t> litBytes;
  size_t samples = 0;
  size_t exactCells = 0;
};

template <class Voxel>
class SlicePassOf final : public SlicePass {
 public:
  SlicePassOf(const DisplayProfile& profile, const SliceOptions& options)
      : profile_(profile),
        sweep_(profile),
        setup_(profile, options),
        dither_(options.colors),
        strips_(allStrips()),
        noSlice_(static_cast<uint32_t>(profile.storedSlices())),
        binOfSlice_(noSlice_ + 1) {}

  void findSpans(const SliceMesh& mesh, std::span<const size_t> chunks, std::span<SectorSpan> spans) override {
    begin(mesh);
    forEachItem(chunks.size(), 1, [&](Worker<Voxel>& worker, size_t i) {
      const SliceChunk& chunk = mesh.chunks()[chunks[i]];
      const SectorReach reach =
          lightSamples(setup_, verticesFrom(chunk.firstVertex, chunk.vertices), worker.points.data(), worker.voxels);
      spans[chunks[i]] = spanOf(reach);
    });
  }

  SliceStages run(const SliceMesh& mesh, std::span<const size_t> chunks, std::span<const int> wanted,
                  std::span<SectorSpan> spans, Volume& volume) override {
    begin(mesh);
    allSlices_ = wanted.size() == noSlice_;
    std::ranges::fill(binOfSlice_, noSlice_);
    for (const int slice : wanted) {
      binOfSlice_[static_cast<size_t>(slice)] = static_cast<uint32_t>(slice);
    }
    Stopwatch watch;
    SliceStages stages;
    forEachItem(chunks.size(), 1, [&](Worker<Voxel>& worker, size_t i) {
      spans[chunks[i]] = lightChunk(worker, mesh.chunks()[chunks[i]]);
    });
    stages.sampling = watch.lap();
    std::vector<ExactTask> tasks;
    for (Worker<Voxel>& worker : workers_) {
      tasks.insert(tasks.end(), worker.exact.begin(), worker.exact.end());
      worker.exact.clear();
    }
    forEachItem(tasks.size(), 16, [&](Worker<Voxel>& worker, size_t i) { lightExactly(worker, tasks[i]); });
    stages.exact = watch.lap();
    forEachItem(wanted.size(), 1,
                [&](Worker<Voxel>& worker, size_t i) { putTogether(worker, static_cast<size_t>(wanted[i]), volume); });
    stages.assembling = watch.lap();
    for (Worker<Voxel>& worker : workers_) {
      stages.samples += std::exchange(worker.samples, 0);
      stages.exactCells += std::exchange(worker.exactCells, 0);
    }
    return stages;
  }

 private:
  void begin(const SliceMesh& mesh) {
    while (workers_.size() < static_cast<size_t>(threadCount())) {
      workers_.emplace_back(profile_, noSlice_ + 1);
    }
    mesh_ = &mesh;
    samples_ = {mesh.x(), mesh.y(), mesh.z(), nullptr, nullptr, nullptr, 0};
    if (!mesh.white()) {
      samples_.red = mesh.red();
      samples_.green = mesh.green();
      samples_.blue = mesh.blue();
    }
  }

  /// Calls `work(worker, item)` for every item; free threads take the next ones, `grain` at once.
  template <class Work>
  void forEachItem(size_t items, size_t grain, Work&& work) {
    std::atomic<size_t> next{0};
    parallelChunks(workers_.size(), workers_.size(), [&](size_t part, size_t, size_t) {
      for (size_t first = next.fetch_add(grain); first < items; first = next.fetch_add(grain)) {
        for (size_t item = first; item < std::min(first + grain, items); ++item) {
          work(workers_[part], item);
        }
      }
    });
  }

  SectorSpan lightChunk(Worker<Voxel>& worker, const SliceChunk& chunk) {
    const SectorReach reach = light(worker, verticesFrom(chunk.firstVertex, chunk.vertices), worker.points.data());
    const size_t sampled = sortTriangles(worker, chunk);
    for (size_t done = 0; done < sampled;) {
      worker.room.count = 0;
      done += sampleTriangles(samples_, strips_, worker.sampled.data() + done, sampled - done, worker.room);
      light(worker, worker.room.samples(mesh_->white()), nullptr);
    }
    return spanOf(reach);
  }

  /// Sends wide triangles to those that are sampled, whose number comes back, or to those that are found exactly.
  size_t sortTriangles(Worker<Voxel>& worker, const SliceChunk& chunk) const {
    const uint16_t* corners = mesh_->corners() + 3 * size_t{chunk.firstTriangle};
    const WideTriangles& wide = worker.wide;
    findWideTriangles(setup_, worker.points.data(), corners, chunk.triangles, worker.wide);
    size_t sampled = 0;
    for (size_t i = 0; i < wide.count; ++i) {
      if (wide.pattern[i] == WideTriangles::kCornersSuffice) {
        continue;
      }
      const uint16_t* corner = corners + 3 * wide.number[i];
      const uint32_t vertices[3] = {chunk.firstVertex + corner[0], chunk.firstVertex + corner[1],
                                    chunk.firstVertex + corner[2]};
      if (wide.pattern[i] == WideTriangles::kFoundExactly) {
        addExact(worker, vertices);
      } else {
        worker.sampled[sampled++] = strips_.sampled(vertices, wide.pattern[i], wide.order[i]);
      }
    }
    return sampled;
  }

  /// Triangles light no sectors but those between their corners, the shorter way around.
  SectorSpan spanOf(const SectorReach& reach) const {
    const int count = reach.last - reach.first + 3;  // with a neighbour on both sides, for antialiasing and rounding
    if (reach.onAxis || count >= sweep_.slicesPerHalfTurn()) {
      return {0, sweep_.sectors()};
    }
    return {(reach.first + sweep_.sectors() - 1) % sweep_.sectors(), count};
  }

  SliceSamples verticesFrom(size_t first, size_t count) const {
    SliceSamples vertices = samples_;
    vertices.x += first;
    vertices.y += first;
    vertices.z += first;
    if (vertices.red != nullptr) {
      vertices.red += first;
      vertices.green += first;
      vertices.blue += first;
    }
    vertices.count = count;
    return vertices;
  }

  void addExact(Worker<Voxel>& worker, const uint32_t (&corners)[3]) const {
    SweepVertex vertices[3];
    double lowest = sweep_.height();
    double highest = 0;
    for (size_t k = 0; k < 3; ++k) {
      vertices[k] = sweepVertex(sweep_, mesh_->position(corners[k]));
      lowest = std::min(lowest, vertices[k].point.y);
      highest = std::max(highest, vertices[k].point.y);
    }
    if (highest < 0 || lowest > sweep_.height()) {
      return;
    }
    const SectorRange range = sectorsOf(vertices[0], vertices[1], vertices[2], sweep_.sectors());
    for (int done = 0; done < range.count; done += kSectorsPerTask) {
      worker.exact.push_back(
          {{corners[0], corners[1], corners[2]},
           {(range.first + done) % sweep_.sectors(), std::min(kSectorsPerTask, range.count - done)}});
    }
  }

  SectorReach light(Worker<Voxel>& worker, const SliceSamples& samples, SweepPoint* points) {
    const SectorReach reach = lightSamples(setup_, samples, points, worker.voxels);
    worker.samples += samples.count;
    LitSamples& voxels = worker.voxels;
    if (!allSlices_) {
      for (size_t i = 0; i < voxels.count; ++i) {
        voxels.slice[i] = binOfSlice_[voxels.slice[i]];
      }
    }
    worker.lit.push(
        voxels.slice.data(),
        [&](size_t i) {
          return Voxel::kLevelBits == 1 ? voxels.position[i] : packVoxel<Voxel>(voxels.position[i], voxels.levels[i]);
        },
        voxels.count);
    return reach;
  }

  void lightExactly(Worker<Voxel>& worker, const ExactTask& task) {
    SweepTriangle triangle;
    glm::vec3 positions[3];
    glm::vec3 colors[3];
    for (size_t k = 0; k < 3; ++k) {
      positions[k] = mesh_->position(task.corners[k]);
      triangle.corners[k] = sweepPoint(sweep_, positions[k]);
      colors[k] = mesh_->color(task.corners[k]);
    }
    forEachTouchedCell(
        sweep_, worker.raster, triangle, task.sectors, [&](int sector, int column, int row, double b1, double b2) {
          ++worker.exactCells;
          const auto mix = [&](const glm::vec3& first, const glm::vec3& second, const glm::vec3& third) {
            return first + (second - first) * static_cast<float>(b1) + (third - first) * static_cast<float>(b2);
          };
          const glm::vec3 color = mix(colors[0], colors[1], colors[2]);
          if (!setup_.antialiased) {
            lightCell(worker, sweep_.sliceOfSector(sector), column, row, color);
            return;
          }
          forEachShare(sweep_, mix(positions[0], positions[1], positions[2]), sector, column,
                       [&](int slice, int at, float share) { lightCell(worker, slice, at, row, color * share); });
        });
  }

  /// `slice` is one of the first half turn.
  void lightCell(Worker<Voxel>& worker, int slice, int column, int row, const glm::vec3& color) {
    lightVoxel(worker, slice, column, row, color);
    if (setup_.ownSecondHalf) {
      lightVoxel(worker, slice + sweep_.slicesPerHalfTurn(), sweep_.width() - 1 - column, row, color);
    }
  }

  void lightVoxel(Worker<Voxel>& worker, int slice, int column, int row, const glm::vec3& color) {
    const Rgb8 levels = dither_.levels(color, setup_.fullLevel, slice, column, row);
    if (levels != Rgb8(0)) {
      const uint32_t bin = binOfSlice_[static_cast<size_t>(slice)];
      const auto position = static_cast<uint32_t>(row * setup_.paddedColumns + column);
      worker.lit.push(
          &bin, [&](size_t) { return packVoxel<Voxel>(position, packedLevels<Voxel>(levels)); }, 1);
    }
  }

  void putTogether(Worker<Voxel>& worker, size_t slice, Volume& volume) {
    const std::span<uint8_t> planes = volume.slice(static_cast<int>(slice));
    std::memset(planes.data(), 0, planes.size());
    if constexpr (Voxel::kLevelBits == 1) {
      for (Worker<Voxel>& each : workers_) {
        for (const auto voxel : each.lit.of(slice)) {
          const uint32_t position = voxel >> 3;
          uint8_t* byte = planes.data() + position / 8;
          byte[0] |= static_cast<uint8_t>((voxel & 1u) << position % 8);
          byte[volume.layout().planeBytes] |= static_cast<uint8_t>((voxel >> 1 & 1u) << position % 8);
          byte[2 * volume.layout().planeBytes] |= static_cast<uint8_t>((voxel >> 2 & 1u) << position % 8);
        }
        each.lit.clear(slice);
      }
    } else {
      putTogetherLevels(worker, slice, planes, volume.layout());
    }
  }

  void putTogetherLevels(Worker<Voxel>& worker, size_t slice, std::span<uint8_t> planes, const VolumeLayout& layout) {
    worker.levels.resize(8 * layout.planeBytes);
    worker.hasLight.resize(layout.planeBytes);
    worker.litBytes.clear();
    for (Worker<Voxel>& each : workers_) {
      for (const auto voxel : each.lit.of(slice)) {
        const auto position = static_cast<uint32_t>(voxel >> 24);
        uint32_t& levels = worker.levels[position];
        levels = higherLevels(levels, static_cast<uint32_t>(voxel & 0xffffffu));
        if (!worker.hasLight[position / 8]) {
          worker.hasLight[position / 8] = true;
          worker.litBytes.push_back(position / 8);
        }
      }
      each.lit.clear(slice);
    }
    writePlanes(worker.levels.data(), worker.litBytes, profile_.colorBitsPerChannel, planes.data(), layout.planeBytes);
    for (const uint32_t byte : worker.litBytes) {
      worker.hasLight[byte] = false;
    }
  }

  static uint32_t higherLevels(uint32_t a, uint32_t b) {
    return std::max(a & 0xffu, b & 0xffu) | std::max(a & 0xff00u, b & 0xff00u) | std::max(a & 0xff0000u, b & 0xff0000u);
  }

  DisplayProfile profile_;
  SweepGeometry sweep_;
  SliceKernelSetup setup_;
  VoxelDither dither_;
  const TriangleStrips& strips_;
  uint32_t noSlice_;
  std::vector<uint32_t> binOfSlice_;  ///< its own, or noSlice_ for one that is not wanted
  bool allSlices_ = true;
  std::vector<Worker<Voxel>> workers_;
  const SliceMesh* mesh_ = nullptr;
  SliceSamples samples_;
};

}  // namespace

std::unique_ptr<SlicePass> makeSlicePass(const DisplayProfile& profile, const SliceOptions& options) {
  if (profile.colorBitsPerChannel == 1) {
    return std::make_unique<SlicePassOf<OneBitVoxel>>(profile, options);
  }
  return std::make_unique<SlicePassOf<ManyBitVoxel>>(profile, options);
}

}  // namespace ocelli
