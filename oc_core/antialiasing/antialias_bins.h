// Which triangles may show in which part of an image: its blocks of 8 x 8 pixels, with the triangles whose image meets
// the box around a block, in their order. What is drawn with many samples a pixel is drawn block by block, so that the
// memory that it takes does not grow with the samples.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "oc_core/antialiasing/antialias_view.h"
#include "oc_core/render/pinhole_triangles.h"

namespace ocelli {

class AntialiasBins {
 public:
  static constexpr int kBlock = 8;  ///< pixels a side

  /// `projected` is the mesh as the reference of `view` sees it; both must outlive it.
  AntialiasBins(const AntialiasView& view, const ProjectedMesh& projected);

  int across() const { return across_; }
  int down() const { return down_; }
  size_t blocks() const { return first_.size() - 1; }
  std::span<const uint32_t> trianglesOf(size_t block) const {
    return std::span(triangles_).subspan(first_[block], first_[block + 1] - first_[block]);
  }
  const PinholeTriangles& parts() const { return parts_; }

 private:
  PinholeTriangles parts_;
  int across_;
  int down_;
  std::vector<size_t> first_;  ///< of each block, and the end
  std::vector<uint32_t> triangles_;
};

/// Around the image of a triangle, as the reference of a view sees it; empty (lower beyond upper) where it shows none.
ImageBox boxOfTriangle(const ProjectedMesh& projected, const PinholeTriangles& parts, uint32_t triangle);

/// The pixels whose squares a box meets or touches at their left or top, clipped to an image; x1 and y1 lie beyond.
/// Empty where there are none.
inline PixelBounds pixelsOf(const ImageBox& box, int width, int height) {
  const auto w = static_cast<float>(width);
  const auto h = static_cast<float>(height);
  if (!(box.lower.x < w && box.lower.y < h && box.upper.x > 0 && box.upper.y > 0)) {
    return {};
  }
  const auto lastPixel = [](float at, float size) { return static_cast<int>(at < size ? at : size - 1); };
  return {static_cast<int>(std::max(box.lower.x, 0.0f)), static_cast<int>(std::max(box.lower.y, 0.0f)),
          lastPixel(box.upper.x, w) + 1, lastPixel(box.upper.y, h) + 1};
}

}  // namespace ocelli
