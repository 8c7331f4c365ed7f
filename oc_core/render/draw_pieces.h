// Draws pieces of rays (piece_rasterizer.h) on all threads, region by region of the image: first where the blocks of
// the mesh may be seen, then each region piece after piece, and within a piece blocks from the near to the far, so that
// what lies behind is passed over. Each region is drawn by one thread, so images are the same for any number of
// threads.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "oc_core/base/parallel.h"
#include "oc_core/render/piece_rasterizer.h"
#include "oc_core/render/ray_batch.h"

namespace ocelli {

using RayPieces = std::vector<std::unique_ptr<PieceRasterizer>>;

/// Calls `finish(region)` once a region of the image, on several threads at once. Pieces come in their order along
/// rays.
void drawPieces(const RayPieces& pieces, const PixelLeaves& leaves, const MeshBlocks& blocks,
                const std::function<void(const RegionBuffer& region)>& finish);

/// The same as a buffer.
OrderedBuffer orderedBufferOf(const RayPieces& pieces, const PixelLeaves& leaves, const MeshBlocks& blocks);

/// The fragments of a run of samples. `zOf(x, y, order, leaf, points, z)` gives z of what rays side by side meet at
/// points of a piece; behind `zFar` nothing is seen.
template <class ZOf>
void putFragments(const RegionBuffer::SampleRun& run, const Mesh& mesh, double zFar, const ZOf& zOf,
                  std::span<Fragment> fragments) {
  RayBatch::Points points;
  RayBatch::Lanes z;
  for (size_t i = 0; i < run.size; ++i) {
    fragments[i] = run.fragment(i);
    points.set(static_cast<int>(i), glm::dvec3(positionOf(fragments[i], mesh)));
  }
  zOf(run.x, run.y, run.order, run.leaf, points, z);
  for (size_t i = 0; i < run.size; ++i) {
    if (z[i] <= zFar) {
      fragments[i].t = static_cast<float>(z[i]);
    } else {
      fragments[i] = Fragment();
    }
  }
}

/// The image of pieces.
template <class ZOf>
FragmentImage drawFragments(const RayPieces& pieces, const PixelLeaves& leaves, const Mesh& mesh,
                            const MeshBlocks& blocks, double zFar, const ZOf& zOf) {
  FragmentImage fragments(leaves.width(), leaves.height());
  drawPieces(pieces, leaves, blocks, [&](const RegionBuffer& region) {
    region.forEachRun(RayBatch::kLanes, [&](const RegionBuffer::SampleRun& run) {
      putFragments(run, mesh, zFar, zOf, {&fragments(run.x, run.y), run.size});
    });
  });
  return fragments;
}

/// The image of what was drawn to a buffer.
template <class ZOf>
FragmentImage fragmentsOf(const OrderedBuffer& buffer, const PixelLeaves& leaves, const Mesh& mesh, double zFar,
                          const ZOf& zOf) {
  FragmentImage fragments(leaves.width(), leaves.height());
  parallelFor(static_cast<size_t>(leaves.height()), 8, [&](size_t begin, size_t end) {
    for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
      for (int x = 0; x < leaves.width(); ++x) {
        const size_t pixel = fragments.index(x, y);
        if (buffer.order(pixel) != OrderedBuffer::kNone) {
          const Fragment f = buffer.fragment(pixel);
          putFragments({x, y, buffer.order(pixel), leaves[pixel], 1, &f.t, &f.triangle, &f.b1, &f.b2}, mesh, zFar, zOf,
                       {&fragments[pixel], 1});
        }
      }
    }
  });
  return fragments;
}

}  // namespace ocelli
