// A rectangle of an image to which pieces of rays are drawn one after the other, in the order in which rays pass them
// (ordered_buffer.h). What is drawn first stays, so a piece is drawn to the pixels alone whose rays pass it and have
// met nothing yet: its open pixels.
//
// Tiles of pixels know a bound of what they hold, so that whole blocks of triangles are passed over which lie behind
// what was drawn, or where no pixel is open. Passing over them changes nothing: a sample that is not nearer than what
// its pixel holds is dropped anyway.
#pragma once

#include <span>

#include "oc_core/render/ordered_buffer.h"

namespace ocelli {

/// The leaf that the ray of each pixel passes: for cameras whose rays are all of one kind, 0.
using PixelLeaves = Image<uint16_t>;

class RegionBuffer {
 public:
  static constexpr int kTile = 8;  ///< pixels a side

  /// Empties it for the pixels of `rect`, which is not empty and lies within the image of the leaves.
  void reset(const PixelBounds& rect, const PixelLeaves& leaves);
  const PixelBounds& rect() const { return rect_; }

  /// Begins a piece that is seen within `rect`: open are the pixels that hold nothing yet, and whose leaf has a kind of
  /// rays in this piece (-1 for none). Returns which kinds of rays open pixels have: bit i is kind i, the last one for
  /// all from it on; 0 where no pixel is open, or the region lies outside of `rect`: then nothing is to be drawn.
  uint64_t open(const PixelBounds& rect, uint8_t order, std::span<const int16_t> kindOfLeaf);
  /// A bit for each kind of rays that pixels have in the tiles that `rect` lies in, open or not, and perhaps more.
  uint64_t kindsIn(const PixelBounds& rect, std::span<const int16_t> kindOfLeaf) const;
  /// Ends the piece: what was drawn stays, and forEachRun() tells it.
  void close();
  /// The bit of a kind in what open() returns.
  static uint64_t kindBit(size_t kind) { return uint64_t{1} << std::min<size_t>(kind, 63); }

  /// Whether something in these pixels, whose depths are `nearest` or more, may be nearer than what they hold.
  bool mayShow(const PixelBounds& rect, float nearest);
  /// Something was drawn there.
  void touch(const PixelBounds& rect);

  /// Calls `emit(pixel, z, weights)` for the pixels of `rect`, which lies within the region, that a triangle covers.
  template <class Emit>
  void scan(const PixelBounds& rect, const RasterVertex& a, const RasterVertex& b, const RasterVertex& c,
            const Emit& emit) const {
    scanTriangle(width_, rect, a, b, c,
                 [&](size_t pixel, float z, const PixelWeights& weights) { emit(pixel - first_, z, weights); });
  }
  /// Pixels are numbered within the region. `depth` is positive and grows along the piece; so do the fronts.
  bool isNearest(size_t pixel, float depth, uint32_t triangle) const {
    const uint32_t front = frontOf(depth);
    return front < fronts_[pixel] || (front == fronts_[pixel] && triangle < triangles_[pixel]);
  }
  void put(size_t pixel, float depth, uint32_t triangle, const glm::vec2& b) {
    fronts_[pixel] = frontOf(depth);
    depths_[pixel] = depth;
    triangles_[pixel] = triangle;
    b1s_[pixel] = b.x;
    b2s_[pixel] = b.y;
  }
  /// Draws a triangle to the pixels of `rect`, as scan(), isNearest() and put() would: many pixels at once.
  void fill(const PixelBounds& rect, uint32_t triangle, const RasterVertex& a, const RasterVertex& b,
            const RasterVertex& c);
  /// Whether a small triangle changes no pixel of `rect` for sure: it covers none, or none that holds something as far
  /// as `nearest` or farther. Quick; false for triangles that are not small. Corners lie within 2^20 pixels.
  bool missesAll(const PixelBounds& rect, const RasterVertex& a, const RasterVertex& b, const RasterVertex& c,
                 float nearest) const;
  uint16_t leaf(size_t pixel) const { return leaves_[pixel]; }

  /// A row of samples of one order, whose rays belong to one leaf.
  struct SampleRun {
    int x = 0;  ///< of the first pixel
    int y = 0;
    uint8_t order = 0;
    uint16_t leaf = 0;
    size_t size = 0;
    const float* depths = nullptr;  ///< of `size` samples, as all that follows
    const uint32_t* triangles = nullptr;
    const float* b1s = nullptr;
    const float* b2s = nullptr;

    /// With the depth as its t.
    Fragment fragment(size_t i) const { return {depths[i], triangles[i], b1s[i], b2s[i]}; }
  };
  /// Calls `visit(run)` for all pixels that hold a sample, in runs of up to `most` pixels.
  template <class Visit>
  void forEachRun(size_t most, const Visit& visit) const;

 private:
  static constexpr int32_t kMixed = -1;
  static constexpr uint32_t kClosed = 0;
  static constexpr uint32_t kOpen = ~uint32_t{0};

  /// Grows with depth; never kClosed.
  static uint32_t frontOf(float depth) { return std::bit_cast<uint32_t>(depth) + 1; }

  /// Pixels side by side of one leaf.
  struct Run {
    uint32_t begin = 0;
    uint32_t end = 0;
    uint16_t leaf = 0;
  };
  struct Tile {
    uint32_t farthest = kOpen;  ///< no front is farther
    bool stale = true;          ///< it may be nearer by now
  };
  /// The tiles that some pixels lie in, by their columns and rows.
  PixelBounds tilesOf(const PixelBounds& rect) const;
  Tile& tile(int tileX, int tileY) {
    return tiles_[static_cast<size_t>(tileY) * static_cast<size_t>(tilesAcross_) + static_cast<size_t>(tileX)];
  }
  uint32_t farthestOf(int tileX, int tileY) const;

  PixelBounds rect_;
  int width_ = 0;
  int tilesAcross_ = 0;
  size_t first_ = 0;  ///< of the pixels, as scan() numbers them
  uint8_t order_ = 0;
  bool hasPiece_ = false;  ///< between open() and close()
  std::vector<uint32_t> fronts_;
  // What pixels hold, each number by itself, as many pixels are drawn at once. Where the order is kNone, the rest is
  // left over from before.
  std::vector<uint8_t> orders_;
  std::vector<float> depths_;
  std::vector<uint32_t> triangles_;
  std::vector<float> b1s_;
  std::vector<float> b2s_;
  std::vector<uint16_t> leaves_;
  std::vector<Run> runs_;
  std::vector<Tile> tiles_;
  std::vector<int32_t> leavesOfTiles_;  ///< the leaf of all pixels of a tile; kMixed where there is none
};

template <class Visit>
void RegionBuffer::forEachRun(size_t most, const Visit& visit) const {
  for (int y = rect_.y0; y < rect_.y1; ++y) {
    const size_t row = static_cast<size_t>(y - rect_.y0) * static_cast<size_t>(width_);
    const size_t rowEnd = row + static_cast<size_t>(width_);
    for (size_t first = row; first < rowEnd;) {
      size_t last = first + 1;
      if (orders_[first] != OrderedBuffer::kNone) {
        const size_t limit = std::min(first + most, rowEnd);
        while (last < limit && orders_[last] == orders_[first] && leaves_[last] == leaves_[first]) {
          ++last;
        }
        visit(SampleRun{rect_.x0 + static_cast<int>(first - row), y, orders_[first], leaves_[first], last - first,
                        &depths_[first], &triangles_[first], &b1s_[first], &b2s_[first]});
      }
      first = last;
    }
  }
}

}  // namespace ocelli
