#include "oc_core/render/region_fill.h"

#include "oc_core/base/vector_targets.h"

// This file is compiled once for each of these instruction sets; foreach_target.h includes it again and again.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "oc_core/render/region_fill.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ocelli::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using FillFloats = hn::CappedTag<float, RegionPixels::kMost>;
using FillWords = hn::RebindToUnsigned<FillFloats>;
using FillVec = hn::Vec<FillFloats>;

/// first, first + step, ... Worked out in double precision, in which they are exact, and rounded once.
HWY_ATTR HWY_INLINE FillVec stepsFrom(double first, [[maybe_unused]] double step) {
  const FillFloats floats;
#if HWY_TARGET == HWY_SCALAR
  return hn::Set(floats, static_cast<float>(first));
#else
  const hn::Half<FillFloats> half;
  const hn::Rebind<double, decltype(half)> doubles;
  const auto lower = hn::Add(hn::Set(doubles, first), hn::Mul(hn::Iota(doubles, 0), hn::Set(doubles, step)));
  const auto upper =
      hn::Add(hn::Set(doubles, first),
              hn::Mul(hn::Iota(doubles, static_cast<double>(hn::Lanes(doubles))), hn::Set(doubles, step)));
  return hn::Combine(floats, hn::DemoteTo(half, upper), hn::DemoteTo(half, lower));
#endif
}

HWY_ATTR HWY_INLINE FillVec mixed(FillVec ia, FillVec ib, FillVec ic, float a, float b, float c) {
  const FillFloats floats;
  return hn::Add(hn::Add(hn::Mul(ia, hn::Set(floats, a)), hn::Mul(ib, hn::Set(floats, b))),
                 hn::Mul(ic, hn::Set(floats, c)));
}

HWY_ATTR void fillRowsOf(const RegionPixels& pixels, const PixelRows& rows, const RowTriangle& t) {
  const FillFloats floats;
  const FillWords words;
  constexpr auto kLanes = static_cast<int64_t>(hn::MaxLanes(floats));
  const FillVec perArea = hn::Set(floats, t.perArea);
  const auto index = hn::Set(words, t.index);
  const bool isWide = rows.width > kWideRow;
  std::array<RowTriangle::Edge, 3> edges = t.edges;
  size_t row = rows.first;
  for (int64_t y = 0; y < rows.height; ++y, row += rows.stride) {
    // What all edges leave of a wide row.
    int64_t first = 0;
    int64_t last = rows.width - 1;
    if (isWide) {
      for (const RowTriangle::Edge& e : edges) {
        if (e.stepX > 0) {
          first = std::max(first, (-e.row + e.stepX - 1) / e.stepX);
        } else if (e.stepX < 0) {
          last = e.row < 0 ? -1 : std::min(last, e.row / -e.stepX);
        } else if (e.row < 0) {
          last = -1;
        }
      }
    }
    for (int64_t x = first; x <= last; x += kLanes) {
      const auto at = [x](const RowTriangle::Edge& e) HWY_ATTR {
        return stepsFrom(static_cast<double>(e.row + x * e.stepX), static_cast<double>(e.stepX));
      };
      const FillVec wb = at(edges[1]);
      const FillVec wc = at(edges[2]);
      auto covered = hn::FirstN(floats, static_cast<size_t>(std::min(last - x + 1, kLanes)));
      if (!isWide) {
        const FillVec zero = hn::Zero(floats);
        const auto inside = hn::And(hn::And(hn::Ge(at(edges[0]), zero), hn::Ge(wb, zero)), hn::Ge(wc, zero));
        covered = hn::And(covered, inside);
        if (hn::AllFalse(floats, covered)) {
          continue;
        }
      }
      const FillVec sb = hn::Mul(wb, perArea);
      const FillVec sc = hn::Mul(wc, perArea);
      const FillVec rest = hn::Sub(hn::Sub(hn::Set(floats, 1), sb), sc);
      const FillVec sa = hn::IfThenElseZero(hn::Gt(rest, hn::Zero(floats)), rest);
      const FillVec ia = hn::Mul(sa, hn::Set(floats, t.a.inverseZ));
      const FillVec ib = hn::Mul(sb, hn::Set(floats, t.b.inverseZ));
      const FillVec ic = hn::Mul(sc, hn::Set(floats, t.c.inverseZ));
      const FillVec z = hn::Div(hn::Set(floats, 1), hn::Add(hn::Add(ia, ib), ic));
      const size_t pixel = row + static_cast<size_t>(x);
      const auto front = hn::Add(hn::BitCast(words, z), hn::Set(words, 1));
      const auto held = hn::LoadU(words, pixels.fronts + pixel);
      const auto near = hn::AndNot(hn::Gt(front, held), hn::RebindMask(words, covered));
      if (hn::AllFalse(words, near)) {
        continue;
      }
      const auto heldIndex = hn::LoadU(words, pixels.triangles + pixel);
      const auto nearest = hn::And(near, hn::Or(hn::Lt(front, held), hn::Lt(index, heldIndex)));
      const auto put = hn::RebindMask(floats, nearest);
      hn::BlendedStore(front, nearest, words, pixels.fronts + pixel);
      hn::BlendedStore(index, nearest, words, pixels.triangles + pixel);
      hn::BlendedStore(z, put, floats, pixels.depths + pixel);
      hn::BlendedStore(hn::Mul(mixed(ia, ib, ic, t.a.b1, t.b.b1, t.c.b1), z), put, floats, pixels.b1s + pixel);
      hn::BlendedStore(hn::Mul(mixed(ia, ib, ic, t.a.b2, t.b.b2, t.c.b2), z), put, floats, pixels.b2s + pixel);
    }
    for (RowTriangle::Edge& e : edges) {
      e.row += e.stepY;
    }
  }
}

}  // namespace ocelli::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ocelli {

HWY_EXPORT(fillRowsOf);

void fillRows(const RegionPixels& pixels, const PixelRows& rows, const RowTriangle& triangle) {
  HWY_DYNAMIC_DISPATCH(fillRowsOf)(pixels, rows, triangle);
}

}  // namespace ocelli
#endif  // HWY_ONCE
