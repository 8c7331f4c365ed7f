// Draws what lies in a bend of a curved ray camera (section 4.2.2), where rays are conics: triangles are split until
// their pieces come out straight, and the pieces are filled as for a pinhole.
//
// Whether an edge is split depends on its two ends and its middle alone, so triangles that share an edge split it
// alike: no cracks. It is split where its middle comes out more than `kErrorPixels` from where a straight piece, in
// perspective, would have it; edges that cannot bend so much are not looked at (bend_projection.h). So surfaces are
// shown within about that many pixels of where they are.
//
// The vertices of a block are projected together. A triangle that is not split and lies between pixel centres is passed
// over by the cells of its corners (projected_mesh.h): most of a dense scene.
//
// A ray crosses the planes through the line that the planes of the bend have in common one after the other, so the
// share of the bend that such a plane cuts off orders what is met along the ray.
#pragma once

#include <array>

#include "oc_core/camera/curved_ray_camera.h"
#include "oc_core/render/bend_projection.h"
#include "oc_core/render/piece_rasterizer.h"

namespace ocelli {

class BendRasterizer final : public PieceRasterizer {
 public:
  static constexpr double kErrorPixels = 1.0 / 16;

  struct Vertex {
    glm::dvec3 p{0};
    glm::dvec2 b{0};
    BendImage image;
  };

  /// All must outlive it.
  BendRasterizer(const CurvedRayCamera& camera, size_t bend, uint8_t order, const Mesh& mesh, const MeshBlocks& blocks);

  uint8_t order() const override { return order_; }
  const PixelBounds& rect() const override { return rect_; }
  std::span<const int16_t> kindOfLeaf() const override { return kindOfLeaf_; }
  void findBlocks(MeshBlocks::Runs runs, uint32_t piece, const RegionGrid& grid,
                  std::vector<BlockTask>& tasks) const override;
  std::unique_ptr<Scratch> makeScratch() const override;
  void begin(const RegionBuffer& region, uint64_t kinds, Scratch& scratch) const override;
  void draw(RegionBuffer& region, const BlockTask& task, Scratch& scratch) const override;

 private:
  struct OwnScratch;
  struct Sink {
    RegionBuffer& region;
    uint32_t triangle;
  };

  Vertex vertex(const glm::dvec3& p, const glm::dvec2& b) const { return {p, b, projection_.project(p)}; }
  Vertex meshVertex(size_t i, const glm::dvec2& b, const OwnScratch& scratch) const;
  void place(uint32_t block, OwnScratch& scratch) const;
  bool isStraight(const BlockVertices::Triangle& triangle, const OwnScratch& scratch) const;
  void drawStraight(const Sink& sink, const BlockVertices::Triangle& triangle, OwnScratch& scratch) const;
  void touch(RegionBuffer& region, OwnScratch& scratch) const;
  void drawClipped(const Sink& sink, OwnScratch& scratch) const;
  bool isUnseen(const Sink& sink, const Vertex& a, const Vertex& b, const Vertex& c) const;
  std::optional<Vertex> splitOf(const Vertex& a, const Vertex& b) const;
  void refine(const Sink& sink, const Vertex& a, const Vertex& b, const Vertex& c, int depth) const;
  void refineOne(const Sink& sink, const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& ab,
                 int depth) const;
  void refineTwo(const Sink& sink, const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& ab,
                 const Vertex& bc, int depth) const;
  void fill(const Sink& sink, const Vertex& a, const Vertex& b, const Vertex& c) const;
  void fillAndTouch(const Sink& sink, const Vertex& a, const Vertex& b, const Vertex& c) const;

  const BendBounds& bounds() const { return projection_.bounds(); }

  const Mesh& mesh_;
  const MeshBlocks& blocks_;
  BendProjection projection_;
  uint8_t order_;
  PixelBounds rect_;  ///< the whole image
  std::array<int16_t, 1> kindOfLeaf_{0};
  std::vector<HalfSpaces> sidesOfRows_;     ///< around the rays of each row of regions
  std::vector<HalfSpaces> sidesOfRegions_;  ///< and of each region
};

}  // namespace ocelli
