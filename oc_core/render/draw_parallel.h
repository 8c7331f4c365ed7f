// Draws many triangles on all threads: the workers take blocks of triangles from a common counter, each fills a
// buffer of its own, and the buffers are merged. Merging keeps the closest, so the image is the same for any number of
// threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>

#include "oc_core/base/parallel.h"
#include "oc_core/render/visibility_buffer.h"

namespace ocelli {

/// How many threads draw `blocks` blocks: not more than there is memory for, each with `samples` of its own.
size_t drawingWorkers(size_t blocks, size_t samples);

/// `makeBuffer()` makes a worker's buffer of `pixels` pixels and `samples` samples, `draw(buffer, begin, end)` fills it
/// with the triangles in [begin, end), and `buffer.mergePixels(other, begin, end)` joins two.
template <class MakeBuffer, class Draw>
auto drawOnBuffers(size_t pixels, size_t samples, size_t triangleCount, const MakeBuffer& makeBuffer,
                   const Draw& draw) {
  using Buffer = decltype(makeBuffer());
  constexpr size_t kBlock = 2048;
  const size_t blocks = (triangleCount + kBlock - 1) / kBlock;
  const size_t workers = drawingWorkers(blocks, samples);
  std::vector<std::unique_ptr<Buffer>> buffers(workers);
  std::atomic<size_t> nextBlock{0};
  parallelChunks(workers, workers, [&](size_t worker, size_t, size_t) {
    auto buffer = std::make_unique<Buffer>(makeBuffer());
    for (size_t block = nextBlock++; block < blocks; block = nextBlock++) {
      draw(*buffer, block * kBlock, std::min((block + 1) * kBlock, triangleCount));
    }
    buffers[worker] = std::move(buffer);
  });
  parallelFor(pixels, 1 << 14, [&](size_t begin, size_t end) {
    for (size_t worker = 1; worker < workers; ++worker) {
      buffers[0]->mergePixels(*buffers[worker], begin, end);
    }
  });
  return std::move(*buffers[0]);
}

FragmentImage drawParallel(int width, int height, size_t triangleCount,
                           const std::function<void(VisibilityBuffer& buffer, size_t begin, size_t end)>& draw);

}  // namespace ocelli
