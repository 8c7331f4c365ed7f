#include "oc_core/sea/warped_image.h"

#include "oc_core/base/vector_targets.h"

// This file is compiled once for each of these instruction sets; foreach_target.h includes it again and again.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "oc_core/sea/warped_image.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ocelli::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using WarpFloats = hn::CappedTag<float, 16>;  ///< a number for each of some pixels in a row
using WarpInts = hn::Rebind<int32_t, WarpFloats>;
using WarpBytes = hn::Rebind<uint8_t, WarpFloats>;
using WarpFloat = hn::Vec<WarpFloats>;
using WarpInt = hn::Vec<WarpInts>;

/// What cubicWeights() gives.
struct CubicVectors {
  HWY_ATTR explicit CubicVectors(WarpFloat f) {
    const WarpFloats floats;
    const auto number = [&](float x) HWY_ATTR { return hn::Set(floats, x); };
    const auto square = hn::Mul(f, f);
    w[0] = hn::Mul(hn::Sub(hn::Mul(hn::Add(hn::Mul(number(-0.5f), f), number(1)), f), number(0.5f)), f);
    w[1] = hn::Add(hn::Mul(hn::Sub(hn::Mul(number(1.5f), f), number(2.5f)), square), number(1));
    w[2] = hn::Mul(hn::Add(hn::Mul(hn::Add(hn::Mul(number(-1.5f), f), number(2)), f), number(0.5f)), f);
    w[3] = hn::Mul(hn::Sub(hn::Mul(number(0.5f), f), number(0.5f)), square);
  }

  WarpFloat w[4];
};

/// Four neighbours in a row of a plane, of which each offset is the first, by their weights.
HWY_ATTR HWY_INLINE WarpFloat alongRow(const uint8_t* plane, WarpInt offsets, const CubicVectors& across) {
  const WarpFloats floats;
  const WarpInts ints;
  // Four bytes at a time, wherever they lie.
  const auto four = hn::GatherOffset(ints, reinterpret_cast<const int32_t*>(plane), offsets);
  const auto byte = hn::Set(ints, 0xff);
  const auto first = hn::ConvertTo(floats, hn::And(four, byte));
  const auto second = hn::ConvertTo(floats, hn::And(hn::ShiftRight<8>(four), byte));
  const auto third = hn::ConvertTo(floats, hn::And(hn::ShiftRight<16>(four), byte));
  const auto fourth = hn::ConvertTo(floats, hn::And(hn::ShiftRight<24>(four), byte));
  return hn::Add(hn::Add(hn::Mul(first, across.w[0]), hn::Mul(second, across.w[1])),
                 hn::Add(hn::Mul(third, across.w[2]), hn::Mul(fourth, across.w[3])));
}

HWY_ATTR void warpRow(const WarpReference& reference, const glm::vec2* places, int count, Rgb8* to) {
  const WarpFloats floats;
  const WarpInts ints;
  const WarpBytes bytes;
  constexpr size_t kLanes = hn::MaxLanes(floats);
  const auto width = hn::Set(floats, static_cast<float>(reference.width()));
  const auto perWidth =
      hn::Set(floats, reference.projection().wraps() ? 1 / static_cast<float>(reference.width()) : 0.0f);
  const auto half = hn::Set(floats, 0.5f);
  const auto stride = hn::Set(ints, static_cast<int32_t>(reference.stride()));
  const auto most = hn::Set(floats, 255.0f);
  for (size_t i = 0; i < static_cast<size_t>(count); i += kLanes) {
    const size_t some = std::min(kLanes, static_cast<size_t>(count) - i);
    HWY_ALIGN float x[kLanes] = {};
    HWY_ALIGN float y[kLanes] = {};
    for (size_t lane = 0; lane < some; ++lane) {
      x[lane] = places[i + lane].x;
      y[lane] = places[i + lane].y;
    }
    auto u = hn::Load(floats, x);
    const auto isThere = hn::Eq(u, u);  // not NaN
    u = hn::IfThenElseZero(isThere, u);
    u = hn::Sub(hn::Sub(u, hn::Mul(width, hn::Floor(hn::Mul(u, perWidth)))), half);
    const auto v = hn::Sub(hn::IfThenElseZero(isThere, hn::Load(floats, y)), half);
    const auto left = hn::Floor(u);
    const auto top = hn::Floor(v);
    const CubicVectors across(hn::Sub(u, left));
    const CubicVectors down(hn::Sub(v, top));
    const auto corner = hn::Add(hn::Mul(hn::ConvertTo(ints, top), stride), hn::ConvertTo(ints, left));
    WarpFloat sums[3];
    for (int plane = 0; plane < 3; ++plane) {
      const uint8_t* from = reference.plane(plane) - reference.stride() - 1;
      auto offsets = corner;
      sums[plane] = hn::Mul(alongRow(from, offsets, across), down.w[0]);
      for (int row = 1; row < 4; ++row) {
        offsets = hn::Add(offsets, stride);
        sums[plane] = hn::Add(sums[plane], hn::Mul(alongRow(from, offsets, across), down.w[row]));
      }
      sums[plane] = hn::IfThenElseZero(isThere, hn::Min(hn::Max(sums[plane], hn::Zero(floats)), most));
    }
    uint8_t colors[3][kLanes];
    for (int plane = 0; plane < 3; ++plane) {
      hn::StoreU(hn::DemoteTo(bytes, hn::NearestInt(sums[plane])), bytes, colors[plane]);
    }
    for (size_t lane = 0; lane < some; ++lane) {
      to[i + lane] = Rgb8(colors[0][lane], colors[1][lane], colors[2][lane]);
    }
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

PartialImage warpedOver(const SeaProxy& proxy, const WarpReference& reference, const SeaPose& referencePose,
                        const SeaCamera& target, int cell) {
  PartialImage partial{Image<Rgb8>(target.projection.width, target.projection.height),
                       Image<uint8_t>(target.projection.width, target.projection.height)};
  const auto warp = HWY_DYNAMIC_DISPATCH(warpRow);
  const SeaCamera from{reference.projection(), referencePose};
  forEachWarpStrip(proxy, target, from, cell, [&](int top, const WarpMap& strip) {
    for (int y = 0; y < strip.height(); ++y) {
      warp(reference, &strip(0, y), strip.width(), &partial.image(0, top + y));
      for (int x = 0; x < strip.width(); ++x) {
        partial.isKnown(x, top + y) = isSeen(strip(x, y)) ? 1 : 0;
      }
    }
  });
  return partial;
}

}  // namespace ocelli
#endif
