// Draws what lies in a straight segment: triangles are clipped with it, projected by its matrix, and filled, as for a
// pinhole.
//
// Where a segment ends and the next begins, a surface that runs through both must show no crack, though vertices are
// snapped to a grid and cut edges are rounded. So triangles are cut a little beyond both planes, and each pixel is
// tested: it belongs to the segment up to kOverlapPixels beyond the line where the surface meets the plane. Of two
// segments that hold a pixel, the earlier one is seen.
//
// The vertices of a block are projected together, and triangles that lie between pixel centres are passed over by the
// cells of their corners (projected_mesh.h) before anything else is found out about them: most of a dense scene.
#pragma once

#include "oc_core/render/block_projection.h"
#include "oc_core/render/straight_segment.h"

namespace ocelli {

class SegmentRasterizer final : public PieceRasterizer {
 public:
  /// All must outlive it. The image is so large.
  SegmentRasterizer(const StraightSegment& segment, const Mesh& mesh, const MeshBlocks& blocks, int width, int height);

  uint8_t order() const override { return segment_.order; }
  const PixelBounds& rect() const override { return rect_; }
  std::span<const int16_t> kindOfLeaf() const override { return segment_.endsOfLeaf; }
  void findBlocks(MeshBlocks::Runs runs, uint32_t piece, const RegionGrid& grid,
                  std::vector<BlockTask>& tasks) const override;
  std::unique_ptr<Scratch> makeScratch() const override;
  void begin(const RegionBuffer& region, uint64_t kinds, Scratch& scratch) const override;
  void draw(RegionBuffer& region, const BlockTask& task, Scratch& scratch) const override;

 private:
  class Drawing;

  /// u and v times their weight, and the weight.
  glm::dvec3 image(const glm::dvec3& point) const;

  const StraightSegment& segment_;
  const Mesh& mesh_;
  const MeshBlocks& blocks_;
  int width_;
  int height_;
  SegmentBounds bounds_;
  PixelBounds rect_;
  SegmentSetup setup_;
};

}  // namespace ocelli
