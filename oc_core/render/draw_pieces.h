// Draws pieces of rays (piece_rasterizer.h) on all threads, region by region of the image: first where the blocks of the
// mesh may be seen, then each region piece after piece, and within a piece blocks from the near to the far, so that
// what lies behind is passed over. Each region is drawn by one thread, so images are the same for any number of threads.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "oc_core/render/piece_rasterizer.h"

namespace ocelli {

using RayPieces = std::vector<std::unique_ptr<PieceRasterizer>>;

/// Calls `finish(region)` once a region of the image, on several threads at once. Pieces come in their order along rays.
void drawPieces(const RayPieces& pieces, const PixelLeaves& leaves, const MeshBlocks& blocks,
                const std::function<void(const RegionBuffer& region)>& finish);

/// The same as a buffer.
OrderedBuffer orderedBufferOf(const RayPieces& pieces, const PixelLeaves& leaves, const MeshBlocks& blocks);

/// The sample of a pixel as a fragment, whose z is `zOf(x, y, order, point)`; behind `zFar` nothing is seen.
template <class ZOf>
Fragment fragmentAlong(const Fragment& sample, int x, int y, uint8_t order, const Mesh& mesh, double zFar,
                       const ZOf& zOf) {
  const double z = zOf(x, y, order, glm::dvec3(positionOf(sample, mesh)));
  return z <= zFar ? Fragment{static_cast<float>(z), sample.triangle, sample.b1, sample.b2} : Fragment();
}

/// The image of pieces.
template <class ZOf>
FragmentImage drawFragments(const RayPieces& pieces, const PixelLeaves& leaves, const Mesh& mesh,
                            const MeshBlocks& blocks, double zFar, const ZOf& zOf) {
  FragmentImage fragments(leaves.width(), leaves.height());
  drawPieces(pieces, leaves, blocks, [&](const RegionBuffer& region) {
    region.forEachSample([&](int x, int y, uint8_t order, const KeyedSample& sample) {
      fragments(x, y) = fragmentAlong(sample.fragment(), x, y, order, mesh, zFar, zOf);
    });
  });
  return fragments;
}

/// The image of what was drawn to a buffer.
template <class ZOf>
FragmentImage fragmentsOf(const OrderedBuffer& buffer, const Mesh& mesh, int width, int height, double zFar,
                          const ZOf& zOf) {
  FragmentImage fragments(width, height);
  parallelFor(static_cast<size_t>(height), 8, [&](size_t begin, size_t end) {
    for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
      for (int x = 0; x < width; ++x) {
        const size_t pixel = fragments.index(x, y);
        if (buffer.order(pixel) != OrderedBuffer::kNone) {
          fragments[pixel] = fragmentAlong(buffer.fragment(pixel), x, y, buffer.order(pixel), mesh, zFar, zOf);
        }
      }
    }
  });
  return fragments;
}

}  // namespace ocelli
