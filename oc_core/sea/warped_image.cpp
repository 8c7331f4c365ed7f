#include "oc_core/sea/warped_image.h"

#include "oc_core/base/vector_targets.h"
#include "oc_core/sea/cubic_weights.h"

// This file is compiled once for each of these instruction sets; foreach_target.h includes it again and again.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "oc_core/sea/warped_image.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ocelli::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using PixelFloats = hn::CappedTag<float, 4>;  ///< the colours of one pixel
using PixelBytes = hn::Rebind<uint8_t, PixelFloats>;
using PixelWords = hn::Rebind<int32_t, PixelFloats>;
using PixelVec = hn::Vec<PixelFloats>;

HWY_ATTR HWY_INLINE PixelVec weighed(const uint8_t* bytes, float weight) {
  const PixelFloats floats;
  return hn::Mul(hn::ConvertTo(floats, hn::PromoteTo(PixelWords(), hn::LoadU(PixelBytes(), bytes))),
                 hn::Set(floats, weight));
}

HWY_ATTR void warpRow(const WarpReference& reference, const glm::vec2* places, int count, Rgb8* to) {
  const PixelFloats floats;
  constexpr size_t kLanes = hn::MaxLanes(floats);
  const bool wraps = reference.projection().wraps();
  const auto width = static_cast<float>(reference.width());
  const size_t rowBytes = 4 * reference.stride();
  for (int i = 0; i < count; ++i) {
    const glm::vec2 place = places[i];
    if (!isSeen(place)) {
      to[i] = Rgb8(0);
      continue;
    }
    const float u = wraps ? place.x - width * std::floor(place.x / width) : place.x;
    const float x = std::floor(u - 0.5f);
    const float y = std::floor(place.y - 0.5f);
    const std::array<float, 4> across = cubicWeights(u - 0.5f - x);
    const std::array<float, 4> down = cubicWeights(place.y - 0.5f - y);
    const uint8_t* corner = reference.at(static_cast<int>(x) - 1, static_cast<int>(y) - 1);
    uint8_t bytes[4];
    for (size_t c = 0; c < 4; c += kLanes) {
      auto sum = hn::Zero(floats);
      for (size_t row = 0; row < 4; ++row) {
        const uint8_t* from = corner + row * rowBytes + c;
        const auto line = hn::Add(hn::Add(weighed(from, across[0]), weighed(from + 4, across[1])),
                                  hn::Add(weighed(from + 8, across[2]), weighed(from + 12, across[3])));
        sum = hn::Add(sum, hn::Mul(line, hn::Set(floats, down[row])));
      }
      const auto within = hn::Min(hn::Max(sum, hn::Zero(floats)), hn::Set(floats, 255.0f));
      hn::StoreU(hn::DemoteTo(PixelBytes(), hn::NearestInt(within)), PixelBytes(), bytes + c);
    }
    to[i] = Rgb8(bytes[0], bytes[1], bytes[2]);
  }
}

}  // namespace ocelli::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ocelli {
namespace {

HWY_EXPORT(warpRow);

}  // namespace

Image<Rgb8> warpedImage(const WarpReference& reference, const WarpMap& map) {
  Image<Rgb8> image(map.width(), map.height());
  const auto warp = HWY_DYNAMIC_DISPATCH(warpRow);
  for (int y = 0; y < map.height(); ++y) {
    warp(reference, &map(0, y), map.width(), &image(0, y));
  }
  return image;
}

}  // namespace ocelli
#endif
