#include "oc_core/render/region_buffer.h"

#include <algorithm>
#include <array>

#include "oc_core/base/check.h"
#include "oc_core/render/region_fill.h"

namespace ocelli {
namespace {

/// From so many pixels on, rows are filled in lanes.
constexpr int64_t kLaneRow = 4;
/// Edge functions of triangles whose corners lie within that many pixels are whole numbers below 2^53.
constexpr int64_t kExactPixels = 1 << 16;

}  // namespace

void RegionBuffer::reset(const PixelBounds& rect, const PixelLeaves& leaves) {
  OC_CHECK(rect.x0 >= 0 && rect.x0 < rect.x1 && rect.x1 <= leaves.width() && rect.y0 >= 0 && rect.y0 < rect.y1 &&
               rect.y1 <= leaves.height(),
           "a region lies within its image");
  rect_ = rect;
  width_ = rect.x1 - rect.x0;
  const int height = rect.y1 - rect.y0;
  const auto pixels = static_cast<size_t>(width_) * static_cast<size_t>(height);
  first_ = static_cast<size_t>(rect.y0) * static_cast<size_t>(width_) + static_cast<size_t>(rect.x0);
  tilesAcross_ = (width_ + kTile - 1) / kTile;
  tiles_.assign(static_cast<size_t>(tilesAcross_) * static_cast<size_t>((height + kTile - 1) / kTile), Tile());
  fronts_.assign(pixels + RegionPixels::kMost, kClosed);
  orders_.assign(pixels, OrderedBuffer::kNone);
  hasPiece_ = false;
  depths_.resize(pixels + RegionPixels::kMost);
  triangles_.resize(pixels + RegionPixels::kMost);
  b1s_.resize(pixels + RegionPixels::kMost);
  b2s_.resize(pixels + RegionPixels::kMost);
  leaves_.resize(pixels);
  runs_.clear();
  uint32_t pixel = 0;
  for (int y = rect.y0; y < rect.y1; ++y) {
    for (int x = rect.x0; x < rect.x1; ++x, ++pixel) {
      const uint16_t leaf = leaves(x, y);
      leaves_[pixel] = leaf;
      // A run may go on in the next row, where all of a row is of one leaf.
      if (runs_.empty() || runs_.back().leaf != leaf) {
        runs_.push_back({pixel, pixel, leaf});
      }
      ++runs_.back().end;
    }
  }
  leavesOfTiles_.assign(tiles_.size(), leaves_.front());
  for (const Run& run : runs_) {
    for (uint32_t i = run.begin; i < run.end && runs_.size() > 1;) {
      const int x = static_cast<int>(i) % width_;
      const int y = static_cast<int>(i) / width_;
      const int last = std::min(width_, x + static_cast<int>(run.end - i));
      for (int column = x / kTile; column <= (last - 1) / kTile; ++column) {
        int32_t& leaf = leavesOfTiles_[static_cast<size_t>(y / kTile * tilesAcross_ + column)];
        const bool isFirst = y % kTile == 0 && x <= column * kTile;
        leaf = isFirst || leaf == run.leaf ? run.leaf : kMixed;
      }
      i += static_cast<uint32_t>(last - x);
    }
  }
}

uint64_t RegionBuffer::open(const PixelBounds& rect, uint8_t order, std::span<const int16_t> kindOfLeaf) {
  OC_CHECK(!hasPiece_, "a piece ends before the next one begins");
  order_ = order;
  const bool isApart = rect.x1 <= rect_.x0 || rect.x0 >= rect_.x1 || rect.y1 <= rect_.y0 || rect.y0 >= rect_.y1;
  if (isApart) {
    return 0;
  }
  uint64_t kinds = 0;
  for (const Run& run : runs_) {
    const int16_t kind = kindOfLeaf[run.leaf];
    if (kind < 0) {
      std::fill(fronts_.begin() + run.begin, fronts_.begin() + run.end, kClosed);
      continue;
    }
    uint32_t any = kClosed;
    for (uint32_t i = run.begin; i < run.end; ++i) {
      fronts_[i] = orders_[i] == OrderedBuffer::kNone ? kOpen : kClosed;
      any |= fronts_[i];
    }
    kinds |= any != kClosed ? kindBit(static_cast<size_t>(kind)) : 0;
  }
  if (kinds != 0) {
    std::fill(tiles_.begin(), tiles_.end(), Tile());
    hasPiece_ = true;
  }
  return kinds;
}

uint64_t RegionBuffer::kindsIn(const PixelBounds& rect, std::span<const int16_t> kindOfLeaf) const {
  const PixelBounds tiles = tilesOf(rect);
  uint64_t kinds = 0;
  for (int y = tiles.y0; y < tiles.y1; ++y) {
    for (int x = tiles.x0; x < tiles.x1; ++x) {
      const int32_t leaf = leavesOfTiles_[static_cast<size_t>(y * tilesAcross_ + x)];
      if (leaf == kMixed) {
        return ~uint64_t{0};
      }
      const int16_t kind = kindOfLeaf[static_cast<size_t>(leaf)];
      kinds |= kind >= 0 ? kindBit(static_cast<size_t>(kind)) : 0;
    }
  }
  return kinds;
}

void RegionBuffer::close() {
  if (hasPiece_) {
    for (size_t i = 0; i < orders_.size(); ++i) {
      const bool wasPut = fronts_[i] != kOpen && fronts_[i] != kClosed;
      orders_[i] = wasPut ? order_ : orders_[i];
    }
    hasPiece_ = false;
  }
}

uint32_t RegionBuffer::farthestOf(int tileX, int tileY) const {
  const int x0 = tileX * kTile;
  const int x1 = std::min(x0 + kTile, width_);
  const int y0 = tileY * kTile;
  const int y1 = std::min(y0 + kTile, rect_.y1 - rect_.y0);
  uint32_t farthest = kClosed;
  for (int y = y0; y < y1; ++y) {
    const uint32_t* row = &fronts_[static_cast<size_t>(y) * static_cast<size_t>(width_)];
    if (x1 - x0 == kTile) {
      for (int x = 0; x < kTile; ++x) {
        farthest = std::max(farthest, row[x0 + x]);
      }
    } else {
      farthest = std::max(farthest, *std::max_element(row + x0, row + x1));
    }
  }
  return farthest;
}

PixelBounds RegionBuffer::tilesOf(const PixelBounds& rect) const {
  return {(std::max(rect.x0, rect_.x0) - rect_.x0) / kTile, (std::max(rect.y0, rect_.y0) - rect_.y0) / kTile,
          (std::min(rect.x1, rect_.x1) - rect_.x0 + kTile - 1) / kTile,
          (std::min(rect.y1, rect_.y1) - rect_.y0 + kTile - 1) / kTile};
}

bool RegionBuffer::mayShow(const PixelBounds& rect, float nearest) {
  const uint32_t front = frontOf(nearest);
  const PixelBounds tiles = tilesOf(rect);
  for (int y = tiles.y0; y < tiles.y1; ++y) {
    for (int x = tiles.x0; x < tiles.x1; ++x) {
      Tile& held = tile(x, y);
      if (front > held.farthest) {
        continue;
      }
      if (held.stale) {
        held = {farthestOf(x, y), false};
      }
      if (front <= held.farthest) {
        return true;
      }
    }
  }
  return false;
}

void RegionBuffer::touch(const PixelBounds& rect) {
  const PixelBounds tiles = tilesOf(rect);
  for (int y = tiles.y0; y < tiles.y1; ++y) {
    for (int x = tiles.x0; x < tiles.x1; ++x) {
      tile(x, y).stale = true;
    }
  }
}

bool RegionBuffer::missesAll(const PixelBounds& rect, const RasterVertex& a, const RasterVertex& b,
                             const RasterVertex& c, float nearest) const {
  constexpr int64_t kOne = 1 << kSubPixelBits;
  constexpr int64_t kMaxPixels = 4;
  const int64_t ax = snapToSubPixel(a.u);
  const int64_t ay = snapToSubPixel(a.v);
  const int64_t bx = snapToSubPixel(b.u);
  const int64_t by = snapToSubPixel(b.v);
  const int64_t cx = snapToSubPixel(c.u);
  const int64_t cy = snapToSubPixel(c.v);
  const CentreBox box(rect, std::minmax({ax, bx, cx}), std::minmax({ay, by, cy}));
  if (box.empty()) {
    return true;
  }
  if (box.count() > kMaxPixels) {
    return false;
  }
  const uint32_t front = frontOf(nearest);
  const int64_t area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
  if (area == 0) {
    return true;
  }
  const int64_t turn = area < 0 ? -1 : 1;
  // Whether a pixel centre is outside of an edge, or on it and none of the triangle's; `turn` turns edges around.
  const auto isBeyond = [turn](int64_t px, int64_t py, int64_t qx, int64_t qy, int64_t x, int64_t y) {
    const int64_t dx = (qx - px) * turn;
    const int64_t dy = (qy - py) * turn;
    const bool topOrLeft = dy < 0 || (dy == 0 && dx > 0);
    return dx * (y - py) - dy * (x - px) - (topOrLeft ? 0 : 1) < 0;
  };
  for (int64_t y = box.y0; y <= box.y1; ++y) {
    for (int64_t x = box.x0; x <= box.x1; ++x) {
      const size_t pixel = static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x) - first_;
      const int64_t atX = x * kOne + kOne / 2;
      const int64_t atY = y * kOne + kOne / 2;
      if (front <= fronts_[pixel] && !isBeyond(ax, ay, bx, by, atX, atY) && !isBeyond(bx, by, cx, cy, atX, atY) &&
          !isBeyond(cx, cy, ax, ay, atX, atY)) {
        return false;
      }
    }
  }
  return true;
}

void RegionBuffer::fill(const PixelBounds& rect, uint32_t triangle, const RasterVertex& a, const RasterVertex& b0,
                        const RasterVertex& c0) {
  constexpr int64_t kOne = 1 << kSubPixelBits;
  struct Corner {
    int64_t x;
    int64_t y;
  };
  const Corner pa{snapToSubPixel(a.u), snapToSubPixel(a.v)};
  Corner pb{snapToSubPixel(b0.u), snapToSubPixel(b0.v)};
  Corner pc{snapToSubPixel(c0.u), snapToSubPixel(c0.v)};
  const auto [leastX, mostX] = std::minmax({pa.x, pb.x, pc.x});
  const auto [leastY, mostY] = std::minmax({pa.y, pb.y, pc.y});
  const CentreBox box(rect, {leastX, mostX}, {leastY, mostY});
  if (box.empty()) {
    return;
  }
  const int64_t x0 = box.x0;
  const int64_t x1 = box.x1;
  const int64_t y0 = box.y0;
  const int64_t y1 = box.y1;
  constexpr int64_t kExact = kExactPixels * kOne;
  if (x1 - x0 < kLaneRow || leastX < -kExact || mostX > kExact || leastY < -kExact || mostY > kExact) {
    scan(rect, a, b0, c0, [&](size_t pixel, float z, const PixelWeights& weights) {
      if (isNearest(pixel, z, triangle)) {
        put(pixel, z, triangle, weights());
      }
    });
    return;
  }
  int64_t area = (pb.x - pa.x) * (pc.y - pa.y) - (pb.y - pa.y) * (pc.x - pa.x);
  if (area == 0) {
    return;
  }
  const RasterVertex* b = &b0;
  const RasterVertex* c = &c0;
  if (area < 0) {  // both sides of a surface are drawn: turn it around
    std::swap(pb, pc);
    std::swap(b, c);
    area = -area;
  }
  const auto edge = [&](const Corner& p, const Corner& q) {
    const int64_t dx = q.x - p.x;
    const int64_t dy = q.y - p.y;
    const bool topOrLeft = dy < 0 || (dy == 0 && dx > 0);
    const int64_t startX = x0 * kOne + kOne / 2;
    const int64_t startY = y0 * kOne + kOne / 2;
    return RowTriangle::Edge{-dy * kOne, dx * kOne, dx * (startY - p.y) - dy * (startX - p.x) - (topOrLeft ? 0 : 1)};
  };
  const auto width = static_cast<size_t>(width_);
  fillRows({fronts_.data(), depths_.data(), triangles_.data(), b1s_.data(), b2s_.data()},
           {static_cast<size_t>(y0) * width + static_cast<size_t>(x0) - first_, width, x1 - x0 + 1, y1 - y0 + 1},
           {triangle, a, *b, *c, 1.0f / static_cast<float>(area), {edge(pb, pc), edge(pc, pa), edge(pa, pb)}});
}

}  // namespace ocelli
