#include "oc_core/render/draw_parallel.h"

#include <atomic>
#include <memory>

#include "oc_core/base/parallel.h"

namespace ocelli {

FragmentImage drawParallel(int width, int height, size_t triangleCount,
                           const std::function<void(VisibilityBuffer&, size_t, size_t)>& draw) {
  constexpr size_t kBlock = 2048;
  const size_t blocks = (triangleCount + kBlock - 1) / kBlock;
  // Many threads must not take more memory for their buffers than a machine has.
  constexpr size_t kMostBufferPixels = size_t{1} << 28;
  const size_t fitting =
      kMostBufferPixels / std::max<size_t>(static_cast<size_t>(width) * static_cast<size_t>(height), 1);
  const size_t workers = std::max<size_t>(std::min({blocks, static_cast<size_t>(threadCount()), fitting}), 1);
  std::vector<std::unique_ptr<VisibilityBuffer>> buffers(workers);
  std::atomic<size_t> nextBlock{0};
  parallelChunks(workers, workers, [&](size_t worker, size_t, size_t) {
    auto buffer = std::make_unique<VisibilityBuffer>(width, height);
    for (size_t block = nextBlock++; block < blocks; block = nextBlock++) {
      draw(*buffer, block * kBlock, std::min((block + 1) * kBlock, triangleCount));
    }
    buffers[worker] = std::move(buffer);
  });

  FragmentImage fragments(width, height);
  parallelFor(fragments.size(), 1 << 14, [&](size_t begin, size_t end) {
    for (size_t worker = 1; worker < workers; ++worker) {
      buffers[0]->mergePixels(*buffers[worker], begin, end);
    }
    for (size_t i = begin; i < end; ++i) {
      fragments[i] = buffers[0]->fragment(i);
    }
  });
  return fragments;
}

}  // namespace ocelli
