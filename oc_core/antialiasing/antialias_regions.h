// Which regions of an image are supersampled, and how much (section 5.2.3.2): each gets as many samples as its
// off-screen tile holds, and no more than its triangles ask for.
#pragma once

#include <cstdint>
#include <vector>

#include "oc_core/antialiasing/antialias_image.h"

namespace ocelli {

/// A tile is an image of this many samples; the more, the better and slower.
struct AntialiasTile {
  static constexpr int kMaxSide = 32768;
  static constexpr int64_t kMaxSamples = int64_t{1} << 28;

  int width = 640;
  int height = 720;
};

struct AntialiasRegion {
  PixelBounds box;
  int side = 1;                  ///< n of n x n samples a pixel
  double trianglesPerPixel = 0;  ///< that show, or are hidden, there
};

/// Samples along a pixel's side for each triangle along it: with more, the error hardly becomes smaller.
inline constexpr double kSamplesATriangleSide = 8;

/// How many triangles lie over each pixel of a box, on the average; those that lie over several blocks
/// (antialias_bins.h) count in each.
double trianglesPerPixel(const AntialiasScene& scene, const PixelBounds& box);

/// The greatest n with which the box fits its tile, at most SamplePattern::kMaxSide, and at least 1; and no more than
/// its triangles ask for.
AntialiasRegion fittedRegion(const AntialiasScene& scene, const PixelBounds& box, const AntialiasTile& tile);

/// Rectangles of blocks that more than `dense` triangles a pixel lie over: one around all such blocks that touch.
std::vector<PixelBounds> denseRectangles(const AntialiasScene& scene, double dense);

/// Rectangles around those objects that have more than `dense` triangles for each of their pixels. Object 0, the
/// structure, is none. `objectOfTriangle` is that of the mesh.
std::vector<PixelBounds> objectRectangles(const AntialiasScene& scene, const std::vector<uint32_t>& objectOfTriangle,
                                          double dense);

/// The plan: in regions n x n samples a pixel, elsewhere as `outside` says. A pixel in several regions takes the one
/// with the most samples.
AntialiasPlan regionPlan(const AntialiasView& view, const std::vector<AntialiasRegion>& regions,
                         const SamplePlacement& placement, size_t maxExactTriangles, const PixelRule& outside);

}  // namespace ocelli
