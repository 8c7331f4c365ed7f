// addResidual(), by vectors of bytes.
#include "oc_core/base/vector_targets.h"
#include "oc_core/sea/residual.h"

// This file is compiled once for each of these instruction sets; foreach_target.h includes it again and again.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "oc_core/sea/residual_sum.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ocelli::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// a + 2 (r - 128) within 0 and 255: what is above 128 is added, what is below is taken away. Twice a byte saturates at
/// 255 where 256 is meant, which takes all away as well.
template <class Tag>
HWY_ATTR HWY_INLINE void addResidualAt(Tag tag, uint8_t* to, const uint8_t* residual) {
  const auto zero = hn::Set(tag, uint8_t{128});
  const auto r = hn::LoadU(tag, residual);
  const auto above = hn::SaturatedSub(r, zero);
  const auto below = hn::SaturatedSub(zero, r);
  const auto sum = hn::SaturatedAdd(hn::LoadU(tag, to), hn::SaturatedAdd(above, above));
  hn::StoreU(hn::SaturatedSub(sum, hn::SaturatedAdd(below, below)), tag, to);
}

HWY_ATTR void addResidualBytes(uint8_t* to, const uint8_t* residual, size_t count) {
  const hn::ScalableTag<uint8_t> all;
  const hn::CappedTag<uint8_t, 1> one;
  size_t i = 0;
  for (; i + hn::Lanes(all) <= count; i += hn::Lanes(all)) {
    addResidualAt(all, to + i, residual + i);
  }
  for (; i < count; ++i) {
    addResidualAt(one, to + i, residual + i);
  }
}

}  // namespace ocelli::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ocelli {
namespace {

HWY_EXPORT(addResidualBytes);

}  // namespace

void addResidual(Image<Rgb8>& predicted, const Image<Rgb8>& residual) {
  OC_CHECK(residual.width() == predicted.width() && residual.height() == predicted.height(), "images of one size");
  if (!residual.empty()) {
    HWY_DYNAMIC_DISPATCH(addResidualBytes)(&predicted.data()->r, &residual.data()->r, 3 * residual.size());
  }
}

}  // namespace ocelli
#endif
