// Pictures of views from one image at the rate of a screen: what resample() (oc_core/ocri/resample.h) draws exactly, by
// a lookup for each pixel.
//
// A pixel's ray meets the pinhole of the image where a projective map says, and the image where the zones of a general
// pinhole do: their magnification is a table along f. From elsewhere the depth of the pixel is known first
// (depth_blocks.h); with it the place in the image is a projective map too, so there is one way to look up. Pixels that
// stand for several samples are their average, as resample() has it, but blocks of 4x4 pixels take the number of their
// middle, up to 1.5 samples count as one, and where a pixel has more than 1.8 (the geometric mean of both axes), they
// are those of the image at half its size, or a quarter, or an eighth.
//
// Beyond the borders of the image the nearest sample is taken. From elsewhere, pixels that the image knows nothing of
// get the colour of the farther one of those beside them in their row; whether it does is asked once for four pixels
// without a surface.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "oc_core/image/png_file.h"
#include "oc_core/ocri/reference_image.h"
#include "oc_core/remote/client/depth_blocks.h"

namespace ocelli {

struct QuickFrame {
  Image<Rgb8> color;
  double holes = 0;       ///< share of the pixels that the image knows nothing of, without those beyond its borders
  bool isWarped = false;  ///< by depth
};

class QuickImage {
 public:
  /// An image of a pinhole or a general one. Without `hasDepth` it is drawn from elsewhere as if all were at infinity.
  explicit QuickImage(const ReferenceImage& image, bool hasDepth = true);

  QuickFrame draw(const PinholeCamera& view) const;
  const PinholeCamera& reference() const { return reference_; }
  size_t depthBlocks() const { return blocks_ ? blocks_->size() : 0; }

 private:
  friend class QuickLookup;
  /// Linear red, green and blue; 1 where there is a sample. Four at once: half of the time of a picture is spent here.
  using Color = float __attribute__((vector_size(16)));
  struct Texel {
    Color values;
  };
  /// The image at a size of 1 / 2^n.
  struct Level {
    int width = 0;
    int height = 0;
    float scale = 1;  ///< its size by that of the image
    std::vector<Texel> texels;
  };
  static constexpr size_t kLevels = 4;
  static Level halved(const Level& level);

  /// A zone of the map (gpc_map.h) with its magnification in equal steps of f.
  struct Zone {
    float centerX, centerY, inverseHalfX, inverseHalfY, outer, zoom;
    float stepsPerF;
    std::vector<float> magnification;  ///< from f = 1 / zoom to outer, and the last one again
  };

  PinholeCamera reference_;
  GpcMap map_;
  std::vector<Level> levels_;
  std::vector<Zone> zones_;
  std::optional<DepthBlocks> blocks_;
};

}  // namespace ocelli
