// Images drawn by a warp map: what an image of a sea looks like from another position, as far as it can know.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "oc_core/image/image.h"
#include "oc_core/image/png_file.h"
#include "oc_core/sea/sea_projection.h"
#include "oc_core/sea/warp_map.h"

namespace ocelli {

struct HiddenSamples;

/// An image of 8-bit sRGB prepared to be looked up between its pixels: a plane for each colour, with a rim on every
/// side that goes on round a panorama, over its poles, and repeats the border of other images.
class WarpReference {
 public:
  static constexpr int kRim = 4;

  WarpReference() = default;
  WarpReference(const Image<Rgb8>& image, const SeaProjection& projection);

  int width() const { return width_; }
  int height() const { return height_; }
  /// Of the first pixel of a colour (0, 1 or 2); the next row is stride() further. The rim lies around.
  const uint8_t* plane(int color) const {
    return pixels_.data() + static_cast<size_t>(color) * planeBytes() + kRim * stride() + kRim;
  }
  /// A pixel of the image or its rim.
  Rgb8 at(int x, int y) const {
    const ptrdiff_t offset = y * static_cast<ptrdiff_t>(stride()) + x;
    return {plane(0)[offset], plane(1)[offset], plane(2)[offset]};
  }
  /// As it was given.
  Image<Rgb8> image() const;
  size_t stride() const { return static_cast<size_t>(width_) + 2 * kRim; }
  const SeaProjection& projection() const { return projection_; }

  /// Of an I-node, what it does not see itself (hidden_samples.h); none by default.
  const HiddenSamples* hidden() const { return hidden_.get(); }
  void setHidden(std::shared_ptr<const HiddenSamples> hidden) { hidden_ = std::move(hidden); }

 private:
  size_t planeBytes() const { return stride() * (static_cast<size_t>(height_) + 2 * kRim); }

  int width_ = 0;
  int height_ = 0;
  SeaProjection projection_;
  std::vector<uint8_t> pixels_;
  std::shared_ptr<const HiddenSamples> hidden_;
};

/// Each pixel by cubic convolution (Catmull and Rom's) of the reference around its place; black where it is not seen.
Image<Rgb8> warpedImage(const WarpReference& reference, const WarpMap& map);
/// The same in plain steps: what the one above, which takes vectors of the CPU, is compared with.
Image<Rgb8> plainWarpedImage(const WarpReference& reference, const WarpMap& map);

/// An image and which of its pixels are known: 1, or 0.
struct PartialImage {
  Image<Rgb8> image;
  Image<uint8_t> isKnown;
};

/// What warpedImage() gives with makeWarpMap().
PartialImage warpedOver(const SeaProxy& proxy, const WarpReference& reference, const SeaPose& referencePose,
                        const SeaCamera& target, int cell);

/// Fills what is not known with what is around it, smoothly: by means of blocks, of larger blocks where whole blocks
/// are not known.
void fillUnknown(PartialImage& partial);

}  // namespace ocelli
