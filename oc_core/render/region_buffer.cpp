#include "oc_core/render/region_buffer.h"

#include "oc_core/base/check.h"

namespace ocelli {

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
  fronts_.assign(pixels, kClosed);
  orders_.assign(pixels, OrderedBuffer::kNone);
  samples_.assign(pixels, KeyedSample());
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
}

uint64_t RegionBuffer::open(const PixelBounds& rect, uint8_t order, std::span<const int16_t> kindOfLeaf) {
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
  }
  return kinds;
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

bool RegionBuffer::mayShow(const PixelBounds& rect, float nearest) {
  const uint32_t front = frontOf(nearest);
  const int x0 = (std::max(rect.x0, rect_.x0) - rect_.x0) / kTile;
  const int y0 = (std::max(rect.y0, rect_.y0) - rect_.y0) / kTile;
  const int x1 = (std::min(rect.x1, rect_.x1) - rect_.x0 + kTile - 1) / kTile;
  const int y1 = (std::min(rect.y1, rect_.y1) - rect_.y0 + kTile - 1) / kTile;
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) {
      Tile& tile = tiles_[static_cast<size_t>(y) * static_cast<size_t>(tilesAcross_) + static_cast<size_t>(x)];
      if (front > tile.farthest) {
        continue;
      }
      if (tile.stale) {
        tile = {farthestOf(x, y), false};
      }
      if (front <= tile.farthest) {
        return true;
      }
    }
  }
  return false;
}

void RegionBuffer::touch(const PixelBounds& rect) {
  const int x0 = (std::max(rect.x0, rect_.x0) - rect_.x0) / kTile;
  const int y0 = (std::max(rect.y0, rect_.y0) - rect_.y0) / kTile;
  const int x1 = (std::min(rect.x1, rect_.x1) - rect_.x0 + kTile - 1) / kTile;
  const int y1 = (std::min(rect.y1, rect_.y1) - rect_.y0 + kTile - 1) / kTile;
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) {
      tiles_[static_cast<size_t>(y) * static_cast<size_t>(tilesAcross_) + static_cast<size_t>(x)].stale = true;
    }
  }
}

}  // namespace ocelli
