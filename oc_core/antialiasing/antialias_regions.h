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

  int width = 1;
  int height = 1;
};

struct AntialiasRegion {
  PixelBounds box;
  int side = 1;                  ///< n of n x n samples a pixel
  double trianglesPerPixel = 0;  ///< that show, or are hidden, there
};

/// Samples along a pixel's side where one triangle lies over each pixel. With t of them, edges are about sqrt(t) as
/// long, and n x n samples, one in each stratum, are off by about t^(1/4) n^(-3/2): the same error takes n = this times
/// t^(1/6). It is about a step of 8 bits.
inline constexpr double kSideOfOneTriangle = 16;
/// The most that is asked for by itself: what masks take (pixel_masks.h).
inline constexpr int kMaxFittedSide = 32;

/// How many triangles lie over each pixel of a box, on the average; those that lie over several blocks
/// (antialias_bins.h) count in each.
double trianglesPerPixel(const AntialiasScene& scene, const PixelBounds& box);

/// The greatest n with which the box fits its tile, at least 1, and no more than its triangles ask for.
AntialiasRegion fittedRegion(const AntialiasScene& scene, const PixelBounds& box, const AntialiasTile& tile);

/// Rectangles of blocks that more than `dense` triangles a pixel lie over: one around all such blocks that touch.
std::vector<PixelBounds> denseRectangles(const AntialiasScene& scene, double dense);

/// Rectangles around those objects that have more than `dense` triangles for each of their pixels. Object 0, the
/// structure, is none. `objectOfTriangle` is that of the mesh.
std::vector<PixelBounds> objectRectangles(const AntialiasScene& scene, const std::vector<uint32_t>& objectOfTriangle,
                                          double dense);

/// The plan: in regions n x n samples a pixel, elsewhere as `outside` says. Where they overlap a pixel takes what has
/// the most samples, `outside` included.
AntialiasPlan regionPlan(const AntialiasView& view, const std::vector<AntialiasRegion>& regions,
                         const SamplePlacement& placement, size_t maxExactTriangles, const PixelRule& outside);

}  // namespace ocelli
