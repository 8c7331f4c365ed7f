// Straight segments: parts of space in which the rays of a camera run straight, away from one viewpoint, so that one
// matrix projects all points of the part (Appendix A): a frustum of a graph camera, or what lies between two bends of a
// curved ray camera. Triangles are clipped with a segment, projected by its matrix, and filled, as for a pinhole.
//
// Where a segment ends and the next begins, a surface that runs through both must show no crack, though vertices are
// snapped to a grid and cut edges are rounded. So triangles are cut a little beyond both planes, and each pixel is
// tested: it belongs to the segment up to kOverlapPixels beyond the line where the surface meets the plane. Of two
// segments that hold a pixel, the earlier one is seen.
#pragma once

#include <array>

#include "oc_core/image/image.h"
#include "oc_core/render/mesh_blocks.h"
#include "oc_core/render/ordered_buffer.h"

namespace ocelli {

struct StraightSegment {
  uint8_t order = 0;  ///< of the pieces that a ray passes
  glm::dvec3 viewpoint{0};
  glm::dmat4 pixelFromWorld{1};          ///< rows 0, 1 and 3
  Plane begin;                           ///< the viewpoint lies before it
  std::vector<glm::dvec2> part;          ///< of the image, a convex polygon, clockwise as seen
  std::vector<std::vector<Plane>> ends;  ///< rays of one kind end at the first of these planes, which may be none
  /// The kind of the rays of each leaf, of those that the pixels name; -1 where they do not pass this segment.
  std::vector<int16_t> endsOfLeaf;
};

/// The leaf that the ray of each pixel passes: for cameras whose rays are all of one kind, 0.
using PixelLeaves = Image<uint16_t>;

/// A block of triangles that a piece of rays may hold something of.
struct BlockTask {
  uint32_t piece = 0;
  uint32_t block = 0;
  bool inside = false;  ///< wholly: nothing is to be clipped or tested
};

/// Where a segment is, and which blocks of a mesh it may show.
class SegmentBounds {
 public:
  /// It must outlive this.
  explicit SegmentBounds(const StraightSegment& segment);

  /// How far before its first plane, and beyond its last ones, triangles are still drawn, and then tested by pixels.
  double margin() const { return margin_; }
  /// That it lies in, with that margin and one around its part of the image.
  const HalfSpaces& spaces() const { return spaces_; }
  /// Appends the blocks that the segment may show, as tasks of this piece.
  void findBlocks(const MeshBlocks& blocks, uint32_t piece, std::vector<BlockTask>& tasks) const;

 private:
  bool endsBefore(const Box& box) const;
  bool endsBehind(const Box& box) const;

  const StraightSegment& segment_;
  double margin_;
  HalfSpaces spaces_;
};

class SegmentRasterizer {
 public:
  /// What a thread keeps from one block to the next.
  struct Scratch {
    struct Vertex {
      uint64_t tag = ~uint64_t{0};
      RasterVertex image;
      uint8_t flags = 0;
    };
    static constexpr size_t kVertices = 64;

    uint64_t serial = 0;
    std::array<Vertex, kVertices> cache;
    Clipper clipper;
    std::vector<RasterVertex> corners;
  };

  /// All must outlive it.
  SegmentRasterizer(const StraightSegment& segment, const Mesh& mesh, const MeshBlocks& blocks,
                    const PixelLeaves& leaves);

  const SegmentBounds& bounds() const { return bounds_; }
  void draw(OrderedBuffer& buffer, const BlockTask& task, Scratch& scratch) const;

 private:
  RasterVertex project(const glm::dvec3& point) const;
  bool isBeyondEnds(const glm::dvec3& point) const;
  bool isBehindAll(const glm::dvec3& point) const;
  const Scratch::Vertex& vertex(uint32_t index, bool inside, Scratch& scratch) const;
  void drawCut(OrderedBuffer& buffer, uint32_t triangle, bool clips, Scratch& scratch) const;
  void fill(OrderedBuffer& buffer, uint32_t triangle, const std::array<RasterVertex, 3>& vertices) const;
  void fillTested(OrderedBuffer& buffer, uint32_t triangle, const std::array<RasterVertex, 3>& vertices,
                  const std::array<glm::dvec3, 3>& points) const;

  const StraightSegment& segment_;
  const Mesh& mesh_;
  const MeshBlocks& blocks_;
  const PixelLeaves& leaves_;
  glm::dvec4 uRow_{0};
  glm::dvec4 vRow_{0};
  glm::dvec4 weightRow_{0};
  SegmentBounds bounds_;
  PixelBounds rect_;
  bool holdsAllPixels_;  ///< of the rectangle
};

}  // namespace ocelli
