#include "display_sim/volume.h"

#include <bit>

namespace ocelli {

Volume::Volume(DisplayProfile profile) : profile_(std::move(profile)), layout_(profile_) {
  OC_CHECK(layout_.slices * layout_.sliceBytes <= kMostVolumeBytes, "the display profile was not validated");
  bytes_.resize(layout_.slices * layout_.sliceBytes);
}

unsigned Volume::colorBits(int sliceIndex, int column, int row) const {
  OC_CHECK(column >= 0 && column < width() && row >= 0 && row < height(), "voxel out of range");
  const std::span<const uint8_t> planes = slice(sliceIndex);
  const size_t at = static_cast<size_t>(row) * layout_.rowBytes + static_cast<size_t>(column / 8);
  unsigned bits = 0;
  for (size_t channel = 0; channel < kColorChannels; ++channel) {
    bits |= (planes[channel * layout_.planeBytes + at] >> (column % 8) & 1u) << channel;
  }
  return bits;
}

void Volume::light(int sliceIndex, int column, int row, unsigned colorBits) {
  OC_CHECK(column >= 0 && column < width() && row >= 0 && row < height(), "voxel out of range");
  const std::span<uint8_t> planes = slice(sliceIndex);
  const size_t at = static_cast<size_t>(row) * layout_.rowBytes + static_cast<size_t>(column / 8);
  for (size_t channel = 0; channel < kColorChannels; ++channel) {
    planes[channel * layout_.planeBytes + at] |= static_cast<uint8_t>((colorBits >> channel & 1u) << (column % 8));
  }
}

size_t Volume::litVoxels() const {
  size_t count = 0;
  for (int i = 0; i < slices(); ++i) {
    const uint8_t* planes = slice(i).data();
    for (size_t at = 0; at < layout_.planeBytes; ++at) {
      const unsigned any = planes[at] | planes[layout_.planeBytes + at] | planes[2 * layout_.planeBytes + at];
      count += static_cast<size_t>(std::popcount(any));
    }
  }
  return count;
}

Image<Rgb8> sliceImage(const Volume& volume, int slice) {
  Image<Rgb8> image(volume.width(), volume.height(), Rgb8(0));
  forEachLit(volume, slice, [&](int column, int row, unsigned bits) {
    image(column, row) = Rgb8((bits & 1u) != 0 ? 255 : 0, (bits & 2u) != 0 ? 255 : 0, (bits & 4u) != 0 ? 255 : 0);
  });
  return image;
}

}  // namespace ocelli
