// Draws what one piece of rays shows: a straight segment (straight_segment.h) or a bend (bend_rasterizer.h). A camera
// is a list of them (draw_pieces.h).
#pragma once

#include <memory>

#include "oc_core/render/half_spaces.h"
#include "oc_core/render/mesh_blocks.h"
#include "oc_core/render/region_buffer.h"

namespace ocelli {

/// A block of triangles that a piece of rays may hold something of.
struct BlockTask {
  uint32_t piece = 0;
  uint32_t block = 0;
  bool within = false;  ///< wholly, but for where rays end
  uint64_t clear = 0;   ///< kinds of rays (RegionBuffer::kindBit()) that do not end before the block does
  uint64_t ended = 0;   ///< kinds of rays that end before it begins
  float nearest = 0;    ///< depth: nothing of the block is nearer in this piece
  PixelBounds rect;     ///< pixels in which it may be seen
};

/// An image divided into rectangles that are drawn one by one.
class RegionGrid {
 public:
  // Pixels a side, whole tiles: what is held of one stays in the cache of a core, and few blocks lie in several.
  static constexpr int kWidth = 320;
  static constexpr int kHeight = 96;

  RegionGrid(int width, int height)
      : width_(width),
        height_(height),
        across_((width + kWidth - 1) / kWidth),
        down_((height + kHeight - 1) / kHeight) {}

  int across() const { return across_; }
  int down() const { return down_; }
  size_t size() const { return static_cast<size_t>(across_) * static_cast<size_t>(down_); }
  PixelBounds rect(int column, int row) const {
    return {column * kWidth, row * kHeight, std::min((column + 1) * kWidth, width_),
            std::min((row + 1) * kHeight, height_)};
  }
  PixelBounds rect(size_t region) const {
    return rect(static_cast<int>(region) % across_, static_cast<int>(region) / across_);
  }

 private:
  int width_;
  int height_;
  int across_;
  int down_;
};

class PieceRasterizer {
 public:
  /// What a thread keeps from one block to the next; each kind of piece has its own.
  class Scratch {
   public:
    virtual ~Scratch() = default;
  };

  virtual ~PieceRasterizer() = default;

  /// In the order in which rays pass them; pieces of one order share no pixel.
  virtual uint8_t order() const = 0;
  /// The part of the image that it may be seen in, and the kind of the rays of each leaf (RegionBuffer::open()).
  virtual const PixelBounds& rect() const = 0;
  virtual std::span<const int16_t> kindOfLeaf() const = 0;

  /// Appends the blocks of some runs of its mesh that it may show, as tasks of piece `piece`.
  virtual void findBlocks(MeshBlocks::Runs runs, uint32_t piece, const RegionGrid& grid,
                          std::vector<BlockTask>& tasks) const = 0;
  virtual std::unique_ptr<Scratch> makeScratch() const = 0;
  /// Begins a region that is open for this piece, with rays of these kinds; `scratch` is one of its own.
  virtual void begin(const RegionBuffer& region, uint64_t kinds, Scratch& scratch) const = 0;
  /// Draws a block to the region that was begun last.
  virtual void draw(RegionBuffer& region, const BlockTask& task, Scratch& scratch) const = 0;
};

}  // namespace ocelli
