#include "oc_core/render/draw_pieces.h"

#include <algorithm>
#include <atomic>

#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

/// Runs of blocks that are looked at at once.
constexpr size_t kRunsAtOnce = 64;

/// The blocks that pieces may show: those of a piece side by side, pieces in their order.
std::vector<BlockTask> findTasks(const RayPieces& pieces, const MeshBlocks& blocks, const RegionGrid& grid) {
  const size_t chunks = (blocks.runCount() + kRunsAtOnce - 1) / kRunsAtOnce;
  std::vector<std::vector<BlockTask>> found(pieces.size() * chunks);
  parallelFor(found.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const size_t first = i % chunks * kRunsAtOnce;
      pieces[i / chunks]->findBlocks({first, std::min(first + kRunsAtOnce, blocks.runCount())},
                                     static_cast<uint32_t>(i / chunks), grid, found[i]);
    }
  });
  std::vector<BlockTask> tasks;
  size_t count = 0;
  for (const std::vector<BlockTask>& some : found) {
    count += some.size();
  }
  tasks.reserve(count);
  for (const std::vector<BlockTask>& some : found) {
    tasks.insert(tasks.end(), some.begin(), some.end());
  }
  return tasks;
}

/// What is drawn to each region: indices of tasks, pieces in their order.
std::vector<std::vector<uint32_t>> tasksOfRegions(const std::vector<BlockTask>& tasks, const RegionGrid& grid) {
  std::vector<std::vector<uint32_t>> regions(grid.size());
  for (uint32_t i = 0; i < tasks.size(); ++i) {
    const PixelBounds& rect = tasks[i].rect;
    if (rect.x0 >= rect.x1 || rect.y0 >= rect.y1) {
      continue;
    }
    for (int row = rect.y0 / RegionGrid::kHeight; row <= (rect.y1 - 1) / RegionGrid::kHeight; ++row) {
      for (int column = rect.x0 / RegionGrid::kWidth; column <= (rect.x1 - 1) / RegionGrid::kWidth; ++column) {
        regions[static_cast<size_t>(row * grid.across() + column)].push_back(i);
      }
    }
  }
  return regions;
}

/// Draws regions, with what a thread keeps from one to the next.
class RegionWorker {
 public:
  RegionWorker(const RayPieces& pieces, const std::vector<BlockTask>& tasks, const PixelLeaves& leaves)
      : pieces_(pieces), tasks_(tasks), leaves_(leaves), scratch_(pieces.size()) {}

  const RegionBuffer& draw(const PixelBounds& rect, std::vector<uint32_t>& list) {
    buffer_.reset(rect, leaves_);
    for (auto first = list.begin(); first != list.end();) {
      const uint32_t piece = tasks_[*first].piece;
      const auto last = std::find_if(first, list.end(), [&](uint32_t task) { return tasks_[task].piece != piece; });
      const PieceRasterizer& rasterizer = *pieces_[piece];
      const uint64_t kinds = buffer_.open(rasterizer.rect(), rasterizer.order(), rasterizer.kindOfLeaf());
      if (kinds != 0) {
        std::sort(first, last, [&](uint32_t a, uint32_t b) { return tasks_[a].nearest < tasks_[b].nearest; });
        if (!scratch_[piece]) {
          scratch_[piece] = rasterizer.makeScratch();
        }
        rasterizer.begin(buffer_, kinds, *scratch_[piece]);
        for (auto task = first; task != last; ++task) {
          if (buffer_.mayShow(tasks_[*task].rect, tasks_[*task].nearest)) {
            rasterizer.draw(buffer_, tasks_[*task], *scratch_[piece]);
          }
        }
        buffer_.close();
      }
      first = last;
    }
    return buffer_;
  }

 private:
  const RayPieces& pieces_;
  const std::vector<BlockTask>& tasks_;
  const PixelLeaves& leaves_;
  RegionBuffer buffer_;
  std::vector<std::unique_ptr<PieceRasterizer::Scratch>> scratch_;
};

}  // namespace

void drawPieces(const RayPieces& pieces, const PixelLeaves& leaves, const MeshBlocks& blocks,
                const std::function<void(const RegionBuffer& region)>& finish) {
  const RegionGrid grid(leaves.width(), leaves.height());
  const std::vector<BlockTask> tasks = findTasks(pieces, blocks, grid);
  std::vector<std::vector<uint32_t>> lists = tasksOfRegions(tasks, grid);
  const size_t workers = std::min(grid.size(), static_cast<size_t>(threadCount()));
  std::atomic<size_t> next{0};
  parallelChunks(workers, workers, [&](size_t, size_t, size_t) {
    RegionWorker worker(pieces, tasks, leaves);
    for (size_t region = next++; region < grid.size(); region = next++) {
      finish(worker.draw(grid.rect(region), lists[region]));
    }
  });
}

OrderedBuffer orderedBufferOf(const RayPieces& pieces, const PixelLeaves& leaves, const MeshBlocks& blocks) {
  OrderedBuffer buffer(leaves.size());
  drawPieces(pieces, leaves, blocks, [&](const RegionBuffer& region) {
    region.forEachRun(leaves.size(), [&](const RegionBuffer::SampleRun& run) {
      size_t pixel = leaves.index(run.x, run.y);
      for (size_t i = 0; i < run.size; ++i) {
        buffer.put(pixel++, run.order, run.depths[i], run.triangles[i], {run.b1s[i], run.b2s[i]});
      }
    });
  });
  return buffer;
}

}  // namespace ocelli
