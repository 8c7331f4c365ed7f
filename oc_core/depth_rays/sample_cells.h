// What of a reference image rays can hit: the surface between neighbouring samples, cell by cell.
//
// The surface is that of the image's bounded mesh (section 3.5.1): two triangles between four neighbouring samples of
// one surface, none across a depth discontinuity, and a square for a sample at the rim of a surface, as large as its
// pixel. So a ray hits exactly what a viewpoint would see, and passes where the image says nothing. Each triangle
// belongs to the cell of the pixel that its first corner comes from.
#pragma once

#include <cstdint>
#include <vector>

#include "oc_core/ocri/reference_image.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// The cells of one image of the union; each layer of a layered one has its own.
struct SampleGrid {
  size_t image = 0;
  int width = 0;
  int height = 0;
  uint32_t firstPixel = 0;  ///< in SampleCells::firstTriangle
};

struct SampleCells {
  Mesh mesh;  ///< of all images; triangles in the order of their cells
  std::vector<SampleGrid> grids;
  /// The first triangle of each pixel's cell, row by row and grid by grid, and one behind the last.
  std::vector<uint32_t> firstTriangle;

  /// The pixels of all grids.
  size_t cellCount() const { return firstTriangle.size() - 1; }
  /// Where a triangle lies.
  struct Place {
    size_t image = 0;  ///< of the union
    int x = 0;
    int y = 0;
  };
  Place placeOf(uint32_t triangle) const;
};

/// No image, and images without samples, give no triangle.
SampleCells sampleCells(const ReferenceImages& images);

/// A mesh in place of images, for what is met exactly: a cell a triangle, in their order.
SampleCells triangleCells(const Mesh& mesh);

}  // namespace ocelli
