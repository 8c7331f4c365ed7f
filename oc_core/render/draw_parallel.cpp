#include "oc_core/render/draw_parallel.h"

namespace ocelli {

size_t drawingWorkers(size_t blocks, size_t samples) {
  // Many threads must not take more memory for their buffers than a machine has.
  constexpr size_t kMaxSamples = size_t{1} << 28;
  const size_t fitting = kMaxSamples / std::max<size_t>(samples, 1);
  return std::max<size_t>(std::min({blocks, static_cast<size_t>(threadCount()), fitting}), 1);
}

FragmentImage drawParallel(int width, int height, size_t triangleCount,
                           const std::function<void(VisibilityBuffer&, size_t, size_t)>& draw) {
  FragmentImage fragments(width, height);
  const VisibilityBuffer buffer = drawOnBuffers(
      fragments.size(), fragments.size(), triangleCount, [&] { return VisibilityBuffer(width, height); }, draw);
  parallelFor(fragments.size(), 1 << 14, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      fragments[i] = buffer.fragment(i);
    }
  });
  return fragments;
}

}  // namespace ocelli
