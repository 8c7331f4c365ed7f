// What an I-node of a sea does not see itself, but images that hang on it do: samples of the proxy behind others, as
// the occlusion camera reference images of section 3.5.4.4.3 add them. They fill what a warp over the proxy leaves
// open.
//
// DEVIATION: the text keeps the samples in the image of the occlusion camera, with what undoes its distortion. Here
// they lie in the projection of the I-node itself, in layers one behind the other: each pixel of a layer has one
// sample, on the ray of that pixel. Readers then need no camera but the I-node's. The geometry takes little, since the
// proxy knows it: how far away samples are, for cells of a few pixels, only tells which surface they are of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "oc_core/sea/warped_image.h"

namespace ocelli {

struct HiddenLayer {
  Image<Rgb8> color;      ///< of the projection's size; filled smoothly where there are no samples
  Image<uint16_t> level;  ///< HiddenSamples::levelOf() the samples of each cell; 0 where there are none
};

struct HiddenSamples {
  static constexpr size_t kMaxLayers = 4;
  static constexpr int kCell = 4;             ///< pixels a side
  static constexpr float kLevelStep = 0.03f;  ///< of the distance
  /// What differs by so much at most from the level of a cell is of the surface of the cell.
  static constexpr float kMaxLevelsApart = 1.5f;

  float nearest = 1;  ///< the distance from the eye of level 1, world units
  std::vector<HiddenLayer> layers;

  /// In cells.
  static glm::ivec2 levelSize(const SeaProjection& projection) {
    return {(projection.width + kCell - 1) / kCell, (projection.height + kCell - 1) / kCell};
  }
  /// Cells with samples, of all layers.
  size_t cellCount() const;
  /// Not rounded; of a distance from `nearest` on.
  float levelOf(float distance) const;
};

/// Fills the pixels of `partial`, an image seen by `target`, that are not known where `hidden` has what their rays
/// meet. `inner` is the camera of the I-node. Bilinear among the samples of the surface that is met. On the calling
/// thread alone.
void addHidden(PartialImage& partial, const SeaProxy& proxy, const SeaCamera& target, const SeaCamera& inner,
               const HiddenSamples& hidden);

}  // namespace ocelli
