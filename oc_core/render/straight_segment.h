// Straight segments: parts of space in which the rays of a camera run straight, away from one viewpoint, so that one
// matrix projects all points of the part (Appendix A): a frustum of a graph camera, or what lies between two bends of a
// curved ray camera. segment_rasterizer.h draws them.
#pragma once

#include "oc_core/render/piece_rasterizer.h"

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

/// Where a segment is, and which blocks of a mesh it may show.
class SegmentBounds {
 public:
  /// It must outlive this.
  explicit SegmentBounds(const StraightSegment& segment);

  /// How far before its first plane, and beyond its last ones, triangles are still drawn, and then tested by pixels.
  double margin() const { return margin_; }
  /// That it lies in, with that margin and one around its part of the image.
  const HalfSpaces& spaces() const { return spaces_; }
  /// The pixels whose centres may lie in its part of an image of this size.
  PixelBounds rectIn(int width, int height) const;
  /// Appends the blocks of some runs that the segment may show, as tasks of this piece in that rectangle.
  void findBlocks(const MeshBlocks& blocks, MeshBlocks::Runs runs, uint32_t piece, const PixelBounds& rect,
                  std::vector<BlockTask>& tasks) const;

 private:
  /// How a box lies to where rays end: whether rays of all kinds end before it, which kinds do, and which kinds do not
  /// end before the box does.
  struct Ends {
    bool before = true;
    uint64_t ended = ~uint64_t{0};
    uint64_t clear = ~uint64_t{0};
  };
  Ends endsOf(const Box& box) const;
  void placeInImage(const Box& box, BlockTask& task) const;

  const StraightSegment& segment_;
  double margin_;
  HalfSpaces spaces_;
};

}  // namespace ocelli
