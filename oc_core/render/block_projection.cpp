#include "oc_core/render/block_projection.h"

#include "oc_core/base/vector_targets.h"

// This file is compiled once for each of these instruction sets; foreach_target.h includes it again and again.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "oc_core/render/block_projection.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ocelli::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using BlockDoubles = hn::CappedTag<double, 8>;
using BlockFloats = hn::Rebind<float, BlockDoubles>;
using BlockVec = hn::Vec<BlockDoubles>;
using BlockMask = hn::Mask<BlockDoubles>;

/// A vector of points.
struct BlockVec3 {
  BlockVec x;
  BlockVec y;
  BlockVec z;
};

HWY_ATTR HWY_INLINE BlockVec numbers(double value) {
  return hn::Set(BlockDoubles(), value);
}
HWY_ATTR HWY_INLINE BlockVec3 numbers(const glm::dvec3& p) {
  return {numbers(p.x), numbers(p.y), numbers(p.z)};
}
HWY_ATTR HWY_INLINE BlockVec3 positions(const BlockVertices& points, size_t i) {
  const auto read = [i](const float* from)
                        HWY_ATTR { return hn::PromoteTo(BlockDoubles(), hn::Load(BlockFloats(), from + i)); };
  return {read(points.x()), read(points.y()), read(points.z())};
}
// As glm has them: the order of sums counts.
HWY_ATTR HWY_INLINE BlockVec dot(const BlockVec3& a, const BlockVec3& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_ATTR HWY_INLINE BlockVec3 cross(const BlockVec3& a, const BlockVec3& b) {
  return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(b.y, a.z)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(b.z, a.x)),
          hn::Sub(hn::Mul(a.x, b.y), hn::Mul(b.x, a.y))};
}
HWY_ATTR HWY_INLINE BlockVec3 sum(const BlockVec3& a, const BlockVec3& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_ATTR HWY_INLINE BlockVec3 difference(const BlockVec3& a, const BlockVec3& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_ATTR HWY_INLINE BlockVec3 times(const BlockVec3& a, BlockVec factor) {
  return {hn::Mul(a.x, factor), hn::Mul(a.y, factor), hn::Mul(a.z, factor)};
}
HWY_ATTR HWY_INLINE BlockVec3 over(const BlockVec3& a, BlockVec divisor) {
  return {hn::Div(a.x, divisor), hn::Div(a.y, divisor), hn::Div(a.z, divisor)};
}
HWY_ATTR HWY_INLINE BlockVec heightOver(const HalfSpace& space, const BlockVec3& p) {
  return hn::Add(dot(numbers(glm::dvec3(space)), p), numbers(space.w));
}
HWY_ATTR HWY_INLINE BlockVec affine(double x, double y, double z, double w, const BlockVec3& p) {
  const BlockVec xy = hn::Add(hn::Mul(numbers(x), p.x), hn::Mul(numbers(y), p.y));
  return hn::Add(hn::Add(xy, hn::Mul(numbers(z), p.z)), numbers(w));
}
/// A row of a matrix times (p, 1).
HWY_ATTR HWY_INLINE BlockVec rowTimes(const glm::dmat4& m, int row, const BlockVec3& p) {
  return hn::Add(hn::Add(hn::Mul(numbers(m[0][row]), p.x), hn::Mul(numbers(m[1][row]), p.y)),
                 hn::Add(hn::Mul(numbers(m[2][row]), p.z), numbers(m[3][row])));
}
/// As std::max().
HWY_ATTR HWY_INLINE BlockVec atLeast(BlockVec value, BlockVec least) {
  return hn::IfThenElse(hn::Lt(value, least), least, value);
}

HWY_ATTR void projectSegment(const SegmentSetup& setup, const BlockVertices& points, SegmentImages& images) {
  const BlockDoubles d;
  const BlockFloats f;
  const auto row = [](const glm::dvec4& r, const BlockVec3& p) HWY_ATTR { return affine(r.x, r.y, r.z, r.w, p); };
  // Where a coordinate is this, the cell is unknown().
  const auto noCell = hn::Set(f, 0.5f);
  alignas(64) float cellU[BlockVertices::kMaxCount];
  alignas(64) float cellV[BlockVertices::kMaxCount];
  for (size_t i = 0; i < points.size(); i += hn::Lanes(d)) {
    const BlockVec3 p = positions(points, i);
    const BlockVec inverse = hn::Div(numbers(1), row(setup.weightRow, p));
    const auto u = hn::DemoteTo(f, hn::Mul(row(setup.uRow, p), inverse));
    const auto v = hn::DemoteTo(f, hn::Mul(row(setup.vRow, p), inverse));
    const auto inverseZ = hn::DemoteTo(f, inverse);
    hn::Store(u, f, images.u.data() + i);
    hn::Store(v, f, images.v.data() + i);
    hn::Store(inverseZ, f, images.inverseZ.data() + i);
    const BlockVec height = hn::Sub(dot(numbers(setup.beginNormal), p), numbers(setup.beginDistance));
    const auto one = hn::IfThenElse(hn::Ge(height, numbers(setup.leastHeight)), numbers(1), numbers(0));
    const auto isBegun = hn::Gt(hn::DemoteTo(f, one), hn::Zero(f));
    const auto isImaged =
        hn::And(hn::And(hn::And(hn::Gt(u, hn::Set(f, setup.lower)), hn::Gt(v, hn::Set(f, setup.lower))),
                        hn::And(hn::Lt(u, hn::Set(f, setup.upperU)), hn::Lt(v, hn::Set(f, setup.upperV)))),
                hn::And(hn::Gt(inverseZ, hn::Zero(f)), isBegun));
    hn::Store(hn::IfThenElse(isImaged, u, noCell), f, cellU + i);
    hn::Store(hn::IfThenElse(isImaged, v, noCell), f, cellV + i);
  }
  for (size_t i = 0; i < points.size(); ++i) {
    images.cells[i] = CentreCell(cellU[i], cellV[i]);
  }
}

/// bernsteinRoot().
HWY_ATTR HWY_INLINE BlockVec rootOf(BlockVec b0, BlockVec b1, BlockVec b2) {
  const BlockVec zero = numbers(0);
  const BlockVec one = numbers(1);
  const BlockVec minus = numbers(-1);
  const BlockVec sign = hn::IfThenElse(hn::Gt(hn::Abs(b0), hn::Abs(b2)), hn::IfThenElse(hn::Gt(b0, zero), one, minus),
                                       hn::IfThenElse(hn::Lt(b2, zero), one, minus));
  b0 = hn::Mul(b0, sign);
  b1 = hn::Mul(b1, sign);
  b2 = hn::Mul(b2, sign);
  const BlockVec root = hn::Sqrt(hn::Sub(hn::Mul(b1, b1), hn::Mul(b0, b2)));
  const BlockMask isUp = hn::Ge(b1, zero);
  const BlockVec numerator = hn::IfThenElse(isUp, hn::Add(b1, root), b0);
  const BlockVec denominator = hn::IfThenElse(isUp, hn::Neg(b2), hn::Sub(root, b1));
  const BlockVec inside = hn::Div(numerator, hn::Add(numerator, denominator));
  const BlockMask differ = hn::And(hn::Gt(b0, zero), hn::Lt(b2, zero));
  return hn::IfThenElse(differ, inside, hn::IfThenElse(hn::Gt(b0, zero), one, zero));
}

/// Where the rays of points meet the middle plane, and whether they do: BendProjection::middleOf().
HWY_ATTR HWY_INLINE BlockMask middlesOf(const BendSetup& setup, const BlockVec3& point, BlockVec3& middle) {
  const BlockVec one = numbers(1);
  const BlockVec3 axis = numbers(setup.axis);
  const BlockVec3 direction = numbers(setup.lineDirection);
  const BlockVec3 linePoint = numbers(setup.linePoint);
  const BlockVec3 border = numbers(setup.border);
  const BlockVec3 p = difference(point, numbers(setup.origin));
  const BlockVec3 normal = cross(axis, p);
  const BlockVec along = dot(normal, direction);
  const BlockMask hasArc = hn::Gt(hn::Mul(along, along), hn::Mul(numbers(1e-24), dot(normal, normal)));
  const BlockVec perAlong = hn::Div(one, along);
  const BlockVec3 a = difference(linePoint, times(direction, hn::Mul(dot(normal, linePoint), perAlong)));
  const BlockVec3 s = difference(border, times(direction, hn::Mul(dot(normal, border), perAlong)));
  const BlockVec fromW = numbers(setup.from.w);
  const BlockVec3 t = times(s, hn::Div(fromW, hn::Sub(fromW, heightOver(setup.from, s))));
  const BlockVec3 beyond = numbers(setup.beyond);
  const BlockVec heightBeyond = heightOver(setup.to, beyond);
  const BlockVec heightS = heightOver(setup.to, s);
  const BlockVec3 q = over(difference(times(s, heightBeyond), times(beyond, heightS)), hn::Sub(heightBeyond, heightS));
  const BlockVec3 up = cross(normal, axis);
  const BlockVec3 side = cross(normal, difference(p, a));
  const BlockVec u = rootOf(dot(side, difference(t, a)), dot(side, difference(s, a)), dot(side, difference(q, a)));
  const BlockVec rest = hn::Sub(one, u);
  const BlockVec3 onB =
      sum(sum(times(t, hn::Mul(rest, rest)), times(s, hn::Mul(hn::Mul(numbers(2), u), rest))), times(q, hn::Mul(u, u)));
  const BlockVec3 towards = difference(a, onB);
  const BlockVec share = hn::Div(dot(difference(p, onB), towards), dot(towards, towards));
  const BlockVec mu = hn::Div(hn::Mul(hn::Div(share, hn::Sub(one, share)), dot(up, s)), dot(up, onB));
  const BlockVec weight = hn::Add(one, mu);
  middle = sum(numbers(setup.origin), over(sum(s, times(a, mu)), weight));
  return hn::And(hasArc, hn::And(hn::Lt(share, one), hn::Gt(weight, numbers(0))));
}

HWY_ATTR void projectBend(const BendSetup& setup, const BlockVertices& points, BendImages& images) {
  const BlockDoubles d;
  const hn::RebindToUnsigned<BlockDoubles> bits;
  const BlockVec zero = numbers(0);
  for (size_t i = 0; i < points.size(); i += hn::Lanes(d)) {
    const BlockVec3 point = positions(points, i);
    const BlockVec behindFirst = atLeast(heightOver(setup.first, point), zero);
    const BlockVec beforeLast = atLeast(heightOver(setup.last, point), zero);
    const BlockVec share =
        hn::IfThenElse(hn::Gt(behindFirst, zero), hn::Div(behindFirst, hn::Add(behindFirst, beforeLast)), zero);
    BlockVec3 middle;
    const BlockMask isHeld = middlesOf(setup, point, middle);
    const BlockVec w = rowTimes(setup.before, 3, middle);
    const BlockVec u = hn::Div(rowTimes(setup.before, 0, middle), w);
    const BlockVec v = hn::Div(rowTimes(setup.before, 1, middle), w);
    const BlockVec leastWeight = hn::Mul(numbers(setup.minWeight), w);
    const auto weightBy = [&](const glm::dmat4& m) HWY_ATTR {
      return atLeast(affine(m[0][3], m[1][3], m[2][3], m[3][3], point), leastWeight);
    };
    const BlockVec weight =
        hn::Add(hn::Mul(hn::Sub(numbers(1), share), weightBy(setup.before)), hn::Mul(share, weightBy(setup.after)));
    const BlockVec most = numbers(setup.maxPixels);
    const BlockMask isImaged =
        hn::And(hn::And(isHeld, hn::Gt(w, zero)), hn::And(hn::Lt(hn::Abs(u), most), hn::Lt(hn::Abs(v), most)));
    hn::Store(hn::IfThenElse(isHeld, u, zero), d, images.u.data() + i);
    hn::Store(hn::IfThenElse(isHeld, v, zero), d, images.v.data() + i);
    hn::Store(hn::IfThenElse(isHeld, weight, zero), d, images.weight.data() + i);
    hn::Store(behindFirst, d, images.behindFirst.data() + i);
    hn::Store(beforeLast, d, images.beforeLast.data() + i);
    hn::Store(share, d, images.share.data() + i);
    hn::Store(hn::BitCast(bits, hn::VecFromMask(d, isImaged)), bits, images.imaged.data() + i);
    const auto outside = [&](const HalfSpace& space, uint64_t flag) HWY_ATTR {
      const BlockVec height = hn::Add(hn::Add(hn::Mul(numbers(space.x), point.x), hn::Mul(numbers(space.y), point.y)),
                                      hn::Add(hn::Mul(numbers(space.z), point.z), numbers(space.w)));
      return hn::And(hn::BitCast(bits, hn::VecFromMask(d, hn::Lt(height, zero))), hn::Set(bits, flag));
    };
    hn::Store(hn::Or(outside(setup.first, BendImages::kBeforeFirst), outside(setup.last, BendImages::kBeyondLast)),
              bits, images.outside.data() + i);
  }
  images.findCells(points.size());
}

}  // namespace ocelli::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ocelli {

HWY_EXPORT(projectSegment);
HWY_EXPORT(projectBend);

void projectBlock(const SegmentSetup& setup, const BlockVertices& points, SegmentImages& images) {
  HWY_DYNAMIC_DISPATCH(projectSegment)(setup, points, images);
}

void projectBlock(const BendSetup& setup, const BlockVertices& points, BendImages& images) {
  HWY_DYNAMIC_DISPATCH(projectBend)(setup, points, images);
}

}  // namespace ocelli
#endif  // HWY_ONCE
