// Fills rows of a region (region_buffer.h) with a triangle, many pixels at once, with the widest vectors that the CPU
// has.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "oc_core/render/visibility_buffer.h"

namespace ocelli {

/// What the pixels of a region hold, each number by itself. Behind the last pixel there is room for kMost more.
struct RegionPixels {
  static constexpr size_t kMost = 8;  ///< pixels at once

  uint32_t* fronts = nullptr;  ///< bits of the depth, and 1 more: what is not nearer is dropped
  float* depths = nullptr;
  uint32_t* triangles = nullptr;
  float* b1s = nullptr;
  float* b2s = nullptr;
};

/// A triangle, its corners so turned that the edge functions of scanTriangle() are positive inside.
struct RowTriangle {
  /// An edge function is row + x * stepX, of whole numbers whose products stay below 2^53.
  struct Edge {
    int64_t stepX = 0;
    int64_t stepY = 0;
    int64_t row = 0;
  };

  uint32_t index = 0;
  RasterVertex a;
  RasterVertex b;
  RasterVertex c;
  float perArea = 0;
  std::array<Edge, 3> edges;  ///< opposite of a, b and c, at the first pixel of the first row
};

/// Rows of pixels that lie below each other.
struct PixelRows {
  size_t first = 0;   ///< the first pixel of the first row
  size_t stride = 0;  ///< from a row to the next
  int64_t width = 0;
  int64_t height = 0;
};

/// The samples are those of scanTriangle(), bit by bit; of two at the same depth the one of the lesser triangle stays.
void fillRows(const RegionPixels& pixels, const PixelRows& rows, const RowTriangle& triangle);

}  // namespace ocelli
