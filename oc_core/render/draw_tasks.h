// Draws blocks of triangles into pieces of rays, on all threads.
#pragma once

#include "oc_core/render/draw_parallel.h"
#include "oc_core/render/straight_segment.h"

namespace ocelli {

/// `makeScratch()` makes what a thread needs for a run of tasks, `draw(buffer, task, scratch)` draws one. Tasks of
/// pieces that rays pass first should come first: what lies behind is passed over then.
template <class MakeScratch, class Draw>
OrderedBuffer drawTasks(size_t pixels, const std::vector<BlockTask>& tasks, const MakeScratch& makeScratch,
                        const Draw& draw) {
  constexpr size_t kEach = MeshBlocks::kTriangles;
  return drawOnBuffers(
      pixels, pixels, tasks.size() * kEach, [&] { return OrderedBuffer(pixels); },
      [&](OrderedBuffer& buffer, size_t begin, size_t end) {
        auto scratch = makeScratch();
        for (size_t i = begin / kEach; i < end / kEach; ++i) {
          draw(buffer, tasks[i], scratch);
        }
      });
}

/// The image of what was drawn. `zOf(pixel, order, point)` is z of what the ray of a pixel meets in a piece; behind
/// `zFar` nothing is seen.
template <class ZOf>
FragmentImage fragmentsOf(const OrderedBuffer& buffer, const Mesh& mesh, int width, int height, double zFar,
                          const ZOf& zOf) {
  FragmentImage fragments(width, height);
  parallelFor(fragments.size(), 1 << 12, [&](size_t begin, size_t end) {
    for (size_t pixel = begin; pixel < end; ++pixel) {
      Fragment fragment = buffer.fragment(pixel);
      if (fragment.covered()) {
        const double z = zOf(pixel, buffer.order(pixel), glm::dvec3(positionOf(fragment, mesh)));
        if (z <= zFar) {
          fragment.t = static_cast<float>(z);
          fragments[pixel] = fragment;
        }
      }
    }
  });
  return fragments;
}

}  // namespace ocelli
