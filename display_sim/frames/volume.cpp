#include "display_sim/frames/volume.h"

#include <algorithm>
#include <bit>
#include <glm/common.hpp>

namespace ocelli {

Volume::Volume(DisplayProfile profile) : profile_(std::move(profile)), layout_(profile_) {
  OC_CHECK(layout_.slices * layout_.sliceBytes <= kMaxVolumeBytes, "the display profile was not validated");
  bytes_.resize(layout_.slices * layout_.sliceBytes);
}

Rgb8 Volume::levels(int sliceIndex, int column, int row) const {
  OC_CHECK(column >= 0 && column < width() && row >= 0 && row < height(), "voxel out of range");
  const uint8_t* byte = slice(sliceIndex).data() + static_cast<size_t>(row) * layout_.rowBytes + column / 8;
  Rgb8 levels(0);
  for (int channel = 0; channel < kColorChannels; ++channel) {
    for (int bit = 0; bit < bitsPerChannel(); ++bit, byte += layout_.planeBytes) {
      levels[channel] |= static_cast<uint8_t>((*byte >> (column % 8) & 1u) << bit);
    }
  }
  return levels;
}

void Volume::raise(int sliceIndex, int column, int row, const Rgb8& levels) {
  const Rgb8 higher = glm::max(levels, this->levels(sliceIndex, column, row));
  uint8_t* byte = slice(sliceIndex).data() + static_cast<size_t>(row) * layout_.rowBytes + column / 8;
  const auto mask = static_cast<uint8_t>(1u << (column % 8));
  for (int channel = 0; channel < kColorChannels; ++channel) {
    OC_CHECK(levels[channel] <= fullLevel(), "a level beyond full light");
    for (int bit = 0; bit < bitsPerChannel(); ++bit, byte += layout_.planeBytes) {
      const bool set = (higher[channel] >> bit & 1u) != 0;
      *byte = static_cast<uint8_t>(set ? *byte | mask : *byte & ~mask);
    }
  }
}

unsigned Volume::colorBits(int sliceIndex, int column, int row) const {
  const Rgb8 light = levels(sliceIndex, column, row);
  return (light.r != 0 ? 1u : 0u) | (light.g != 0 ? 2u : 0u) | (light.b != 0 ? 4u : 0u);
}

void Volume::light(int sliceIndex, int column, int row, unsigned colorBits) {
  const auto full = static_cast<uint8_t>(fullLevel());
  raise(sliceIndex, column, row,
        Rgb8((colorBits & 1u) != 0 ? full : 0, (colorBits & 2u) != 0 ? full : 0, (colorBits & 4u) != 0 ? full : 0));
}

void Volume::clear() {
  std::ranges::fill(bytes_, uint8_t{0});
}

size_t Volume::litVoxels() const {
  size_t count = 0;
  for (int i = 0; i < slices(); ++i) {
    count += countLit(slice(i), layout_);
  }
  return count;
}

size_t countLit(std::span<const uint8_t> planes, const VolumeLayout& layout) {
  size_t count = 0;
  for (size_t at = 0; at < layout.planeBytes; ++at) {
    unsigned any = 0;
    for (size_t plane = 0; plane < layout.planes; ++plane) {
      any |= planes[plane * layout.planeBytes + at];
    }
    count += static_cast<size_t>(std::popcount(any));
  }
  return count;
}

Rgb8 levelBytes(const Rgb8& levels, int fullLevel) {
  return Rgb8((glm::ivec3(levels) * 255 + fullLevel / 2) / fullLevel);
}

Image<Rgb8> sliceImage(const Volume& volume, int slice) {
  Image<Rgb8> image(volume.width(), volume.height(), Rgb8(0));
  forEachLevel(volume, slice, [&](int column, int row, const Rgb8& levels) {
    image(column, row) = levelBytes(levels, volume.fullLevel());
  });
  return image;
}

}  // namespace ocelli
