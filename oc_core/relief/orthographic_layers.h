// What parallel rays from above meet of an object, one behind the other: the images of conventional relief textures
// (one layer, [125] of the text) and of layered ones ([124]).
#pragma once

#include <vector>

#include "oc_core/image/image.h"
#include "oc_core/relief/surface_labels.h"

namespace ocelli {

struct OrthographicLayers {
  Box box;  ///< of the object; the images look down its y axis: columns go along x, rows along z
  int width = 0;
  int height = 0;
  /// Of each pixel, how many surfaces its ray meets, up to the number of layers.
  Image<uint8_t> counts;
  /// Heights over the bottom of the box, as a share of its height, from above to below; 0 where there is no surface.
  std::vector<Image<float>> heights;
  std::vector<Image<ReliefSurface>> surfaces;

  size_t layers() const { return heights.size(); }
  /// In pixels from the corner of the image, and a share of the height.
  glm::vec3 pixelsOf(const glm::vec3& point) const;
};

/// At most 255 layers. An object without an extent along x or z has one column or row; an empty one no pixel holds
/// anything of.
OrthographicLayers orthographicLayers(const SurfaceLabels& labels, int width, int height, int layers);

}  // namespace ocelli
