#include "display_sim/slicing/wide_triangles.h"

#include <algorithm>

#include "display_sim/slicing/slice_mesh.h"
#include "display_sim/slicing/triangle_strips.h"
#include "oc_core/base/vector_targets.h"

// This file is compiled once for each of these instruction sets; foreach_target.h includes it again and again.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "display_sim/slicing/wide_triangles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ocelli::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Ints = hn::RebindToSigned<Floats>;
using FloatVec = hn::Vec<Floats>;
using IntVec = hn::Vec<Ints>;

/// Corners in the sweep, sectors counted from the first corner the shorter way around.
struct CornerVectors {
  IntVec sectors[3];
  IntVec columns[3];
  IntVec rows[3];
  IntVec special;  ///< not 0 where one of them is
};

HWY_ATTR HWY_INLINE CornerVectors loadCorners(const SliceKernelSetup& setup, const SweepPoint* const (&corners)[3]) {
  const Ints di;
  const IntVec halfTurn = hn::Set(di, setup.slicesPerHalfTurn * kSweepUnit);
  const IntVec turn = hn::Add(halfTurn, halfTurn);
  CornerVectors loaded;
  IntVec special[3];
  for (size_t k = 0; k < 3; ++k) {
    hn::LoadInterleaved4(di, &corners[k]->sector, loaded.sectors[k], loaded.columns[k], loaded.rows[k], special[k]);
  }
  for (size_t k = 1; k < 3; ++k) {
    IntVec sectors = hn::Sub(loaded.sectors[k], loaded.sectors[0]);
    sectors = hn::Sub(sectors, hn::IfThenElseZero(hn::Gt(sectors, halfTurn), turn));
    loaded.sectors[k] = hn::Add(sectors, hn::IfThenElseZero(hn::Lt(sectors, hn::Neg(halfTurn)), turn));
  }
  loaded.sectors[0] = hn::Zero(di);
  loaded.special = hn::Or(special[0], hn::Or(special[1], special[2]));
  return loaded;
}

HWY_ATTR HWY_INLINE IntVec lowestOf(const IntVec (&of)[3]) {
  return hn::Min(of[0], hn::Min(of[1], of[2]));
}

HWY_ATTR HWY_INLINE IntVec highestOf(const IntVec (&of)[3]) {
  return hn::Max(of[0], hn::Max(of[1], of[2]));
}

HWY_ATTR HWY_INLINE FloatVec largestOf(FloatVec a, FloatVec b, FloatVec c) {
  return hn::Max(a, hn::Max(b, c));
}

/// (3), multiplied by x y z; the corners of triangles suffice.
HWY_ATTR HWY_INLINE hn::Mask<Floats> doCornersSuffice(FloatVec x, FloatVec y, FloatVec z) {
  const Floats d;
  const FloatVec limit = hn::Set(d, kWidestPiece);
  const FloatVec xy = hn::Mul(x, y);
  return hn::And(hn::Lt(largestOf(x, y, z), limit), hn::Gt(hn::Mul(limit, hn::Add(xy, hn::Mul(z, hn::Add(x, y)))),
                                                           hn::Mul(hn::Set(d, 4.0f), hn::Mul(xy, z))));
}

/// In what triangles span in the sweep: dR columns, T = 2 a radians. Let Q and q be the largest and the least radius
/// of a corner, a <= 1/8. Then r0 >= q (1 - a^2 / 2), and all sides have |d.t| <= Q T + a dR, |d.r| <= dR + Q T^2 / 8,
/// so
///   U <= S (Q T + a (2 dR + Q T^2 / 8)) / r0,   V + 2 k <= dR (1 + a^2) + 7/8 Q T^2.
HWY_ATTR HWY_INLINE hn::Mask<Ints> mayBeWide(const SliceKernelSetup& setup, const CornerVectors& corners) {
  const Floats d;
  const Ints di;
  const FloatVec one = hn::Set(d, 1.0f);
  const FloatVec unit = hn::Set(d, 1.0f / kSweepUnit);
  const auto spanOf = [&](const IntVec(&of)[3])
                          HWY_ATTR { return hn::Mul(hn::ConvertTo(d, hn::Sub(highestOf(of), lowestOf(of))), unit); };
  const FloatVec sectors = spanOf(corners.sectors);
  const FloatVec columns = spanOf(corners.columns);
  const FloatVec turn = hn::Mul(sectors, hn::Set(d, setup.radiansPerStep));
  const FloatVec angle = hn::Mul(turn, hn::Set(d, 0.5f));
  const FloatVec square = hn::Mul(angle, angle);
  const FloatVec inner =
      hn::Sub(hn::Mul(hn::ConvertTo(d, lowestOf(corners.columns)), unit), hn::Set(d, setup.axisOffset));
  const FloatVec outer = hn::Add(inner, columns);
  const FloatVec nearest = hn::Max(hn::Mul(inner, hn::Sub(one, square)), hn::Set(d, 1e-3f));  // <= r0
  const FloatVec bend = hn::Mul(outer, square);                                               // Q T^2 / 4
  const FloatVec across = hn::Add(hn::Mul(outer, turn), hn::Mul(angle, hn::Add(hn::Add(columns, columns), bend)));
  const FloatVec x = hn::Div(hn::Mul(hn::Set(d, setup.stepsPerRadian), across), nearest);
  const FloatVec y = hn::Add(hn::Mul(columns, hn::Add(one, square)), hn::Mul(hn::Set(d, 3.5f), bend));
  const auto small = hn::And(doCornersSuffice(x, y, spanOf(corners.rows)), hn::Le(angle, hn::Set(d, 0.125f)));
  return hn::Or(hn::RebindMask(di, hn::Not(small)), hn::Ne(corners.special, hn::Zero(di)));
}

/// A point, or a difference, as in triangle_strips.h: r and t in columns, y in rows.
struct LocalVectors {
  FloatVec r;
  FloatVec t;
  FloatVec y;
};

HWY_ATTR HWY_INLINE LocalVectors operator-(const LocalVectors& a, const LocalVectors& b) {
  return {hn::Sub(a.r, b.r), hn::Sub(a.t, b.t), hn::Sub(a.y, b.y)};
}

HWY_ATTR HWY_INLINE LocalVectors choose(hn::Mask<Floats> first, const LocalVectors& a, const LocalVectors& b) {
  return {hn::IfThenElse(first, a.r, b.r), hn::IfThenElse(first, a.t, b.t), hn::IfThenElse(first, a.y, b.y)};
}

/// U, V and W of a difference.
struct SpanVectors {
  FloatVec sectors;
  FloatVec columns;
  FloatVec rows;
};

struct SpanMeasure {
  FloatVec sectorsPerColumn;  ///< S / r0
  FloatVec angle;             ///< a

  HWY_ATTR HWY_INLINE SpanVectors of(const LocalVectors& d) const {
    const FloatVec across = hn::Abs(d.t);
    const FloatVec outwards = hn::Abs(d.r);
    return {hn::Mul(sectorsPerColumn, hn::Add(across, hn::Mul(angle, outwards))),
            hn::Add(outwards, hn::Mul(angle, across)), hn::Abs(d.y)};
  }
};

HWY_ATTR HWY_INLINE FloatVec largest(const SpanVectors& span) {
  return hn::Max(span.sectors, hn::Max(span.columns, span.rows));
}

/// The patterns of triangles: triangle_strips.h.
HWY_ATTR HWY_INLINE void findPatterns(const SliceKernelSetup& setup, const CornerVectors& corners, int32_t* pattern,
                                      int32_t* order) {
  const Floats d;
  const Ints di;
  const FloatVec one = hn::Set(d, 1.0f);
  const FloatVec half = hn::Set(d, 0.5f);
  const FloatVec unit = hn::Set(d, 1.0f / kSweepUnit);
  const FloatVec limit = hn::Set(d, kWidestPiece);
  const IntVec first = lowestOf(corners.sectors);
  const FloatVec radians = hn::Mul(unit, hn::Set(d, setup.radiansPerStep));
  const FloatVec angle = hn::Mul(hn::Mul(hn::ConvertTo(d, hn::Sub(highestOf(corners.sectors), first)), radians), half);
  // Each corner seen from the middle of their angles.
  LocalVectors points[3];
  FloatVec radius[3];
  for (size_t k = 0; k < 3; ++k) {
    const FloatVec turn = hn::Sub(hn::Mul(hn::ConvertTo(d, hn::Sub(corners.sectors[k], first)), radians), angle);
    const FloatVec square = hn::Mul(turn, turn);
    // To 1e-8 of 1 in the angles that are good, below.
    const FloatVec sine = hn::Mul(
        turn, hn::Sub(one, hn::Mul(square, hn::Sub(hn::Set(d, 1.0f / 6), hn::Mul(square, hn::Set(d, 1.0f / 120))))));
    const FloatVec cosine =
        hn::Sub(one, hn::Mul(square, hn::Sub(half, hn::Mul(square, hn::Sub(hn::Set(d, 1.0f / 24),
                                                                           hn::Mul(square, hn::Set(d, 1.0f / 720)))))));
    radius[k] = hn::Sub(hn::Mul(hn::ConvertTo(d, corners.columns[k]), unit), hn::Set(d, setup.axisOffset));
    points[k] = {hn::Mul(radius[k], cosine), hn::Mul(radius[k], sine),
                 hn::Mul(hn::ConvertTo(d, corners.rows[k]), unit)};
  }
  const FloatVec innermost = hn::Min(points[0].r, hn::Min(points[1].r, points[2].r));
  constexpr float kWidestAngle = 0.25f;
  const auto good = hn::And(hn::And(hn::Le(angle, hn::Set(d, kWidestAngle)), hn::Ge(innermost, one)),
                            hn::RebindMask(d, hn::Eq(corners.special, hn::Zero(di))));
  const SpanMeasure measure{hn::Div(hn::Set(d, setup.stepsPerRadian), hn::Max(innermost, one)), angle};
  LocalVectors sides[3];
  SpanVectors spans[3];
  FloatVec length[3];
  for (size_t k = 0; k < 3; ++k) {
    sides[k] = points[(k + 1) % 3] - points[k];
    spans[k] = measure.of(sides[k]);
    length[k] = largest(spans[k]);
  }
  const FloatVec bend = hn::Mul(largestOf(radius[0], radius[1], radius[2]), hn::Mul(angle, angle));  // >= 2 k
  const FloatVec x = largestOf(spans[0].sectors, spans[1].sectors, spans[2].sectors);
  const FloatVec y = largestOf(spans[0].columns, spans[1].columns, spans[2].columns);
  const FloatVec z = largestOf(spans[0].rows, spans[1].rows, spans[2].rows);
  const auto latticeSuffices = [&](float parts) HWY_ATTR {
    const FloatVec share = hn::Set(d, 1 / parts);
    return doCornersSuffice(hn::Mul(x, share), hn::Add(hn::Mul(y, share), bend), hn::Mul(z, share));
  };
  // AB is the longest side.
  const auto secondIs = hn::Gt(length[1], length[0]);
  const auto thirdIs = hn::Gt(length[2], hn::Max(length[0], length[1]));
  IntVec corner = hn::IfThenElseZero(hn::RebindMask(di, secondIs), hn::Set(di, 1));
  corner = hn::IfThenElse(hn::RebindMask(di, thirdIs), hn::Set(di, 2), corner);
  const LocalVectors base = choose(thirdIs, sides[2], choose(secondIs, sides[1], sides[0]));
  const LocalVectors back = choose(thirdIs, sides[1], choose(secondIs, sides[0], sides[2]));  // from C to A
  const SpanVectors e = measure.of(base);
  // D is where C is in the direction in which AB is the longest, so that f does not add to it.
  const auto byRows = hn::And(hn::Gt(e.rows, e.sectors), hn::Gt(e.rows, e.columns));
  const auto byColumns = hn::Gt(e.columns, e.sectors);
  const FloatVec along = hn::IfThenElse(byRows, base.y, hn::IfThenElse(byColumns, base.r, base.t));
  const FloatVec toC = hn::IfThenElse(byRows, back.y, hn::IfThenElse(byColumns, back.r, back.t));
  constexpr auto kSteps = static_cast<float>(TriangleStrips::kFootSteps);
  const FloatVec steps = hn::Set(d, kSteps);
  const auto isPoint = hn::Eq(along, hn::Zero(d));
  const FloatVec ratio = hn::Div(hn::Neg(toC), hn::IfThenElse(isPoint, one, along));
  FloatVec foot = hn::Floor(hn::Add(hn::Mul(hn::Max(hn::Zero(d), hn::Min(ratio, one)), steps), half));
  const FloatVec share = hn::Mul(foot, hn::Set(d, 1 / kSteps));
  const SpanVectors f = measure.of({hn::Add(back.r, hn::Mul(share, base.r)), hn::Add(back.t, hn::Mul(share, base.t)),
                                    hn::Add(back.y, hn::Mul(share, base.y))});
  const auto mirrored = hn::Gt(foot, hn::Set(d, kSteps / 2));
  foot = hn::IfThenElse(mirrored, hn::Sub(steps, foot), foot);
  // The numbers of strips and pieces with the fewest samples, of the fewest strips that do and some more.
  const FloatVec most = hn::Set(d, TriangleStrips::kMaxPieces + 1.0f);
  const FloatVec fewest = hn::Floor(hn::Add(hn::Mul(hn::Min(largest(f), most), hn::Set(d, 1 / kWidestPiece)), one));
  const FloatVec tries[] = {fewest, hn::Add(fewest, one), hn::Add(fewest, hn::Set(d, 2.0f)), hn::Add(fewest, fewest)};
  FloatVec strips = fewest;
  FloatVec pieces = most;
  FloatVec leastCost = hn::Set(d, 1e9f);
  for (const FloatVec m : tries) {
    const FloatVec height = hn::Div(one, m);
    const auto needed = [&](FloatVec ofE, FloatVec ofF) HWY_ATTR {
      const FloatVec left = hn::Sub(limit, hn::Mul(ofF, height));
      return hn::Div(ofE, hn::Max(left, hn::Set(d, 1e-3f)));
    };
    const FloatVec n = hn::Min(
        most, hn::Ceil(hn::Max(
                  largestOf(needed(e.sectors, f.sectors), needed(e.columns, f.columns), needed(e.rows, f.rows)), one)));
    const FloatVec cost = hn::Add(hn::Mul(n, hn::Add(m, one)), m);  // about twice the samples
    const auto better = hn::Lt(cost, leastCost);
    leastCost = hn::Min(cost, leastCost);
    strips = hn::IfThenElse(better, m, strips);
    pieces = hn::IfThenElse(better, n, pieces);
  }
  const auto fits =
      hn::And(hn::Le(strips, hn::Set(d, static_cast<float>(TriangleStrips::kMaxStrips))), hn::Lt(pieces, most));
  const FloatVec row = hn::Add(hn::Mul(foot, hn::Set(d, TriangleStrips::kMaxStrips + 1.0f)), strips);
  IntVec found = hn::ConvertTo(di, hn::Add(hn::Mul(row, most), pieces));
  found = hn::IfThenElse(hn::RebindMask(di, fits), found, hn::Set(di, WideTriangles::kFoundExactly));
  // Lattices where strips have more samples: more than 7, and more than 3.
  const auto takeLattice = [&](int parts, float cost) HWY_ATTR {
    const auto fewer = hn::And(latticeSuffices(static_cast<float>(parts)), hn::Gt(leastCost, hn::Set(d, cost)));
    found = hn::IfThenElse(hn::RebindMask(di, fewer), hn::Set(di, TriangleStrips::latticePattern(parts)), found);
  };
  takeLattice(3, 15);
  takeLattice(2, 8);
  found = hn::IfThenElse(hn::RebindMask(di, latticeSuffices(1)), hn::Set(di, WideTriangles::kCornersSuffice), found);
  found = hn::IfThenElse(hn::RebindMask(di, good), found, hn::Set(di, WideTriangles::kFoundExactly));
  hn::StoreU(found, di, pattern);
  hn::StoreU(hn::IfThenElse(hn::RebindMask(di, mirrored), hn::Add(corner, hn::Set(di, 3)), corner), di, order);
}

HWY_ATTR void findWide(const SliceKernelSetup& setup, const SweepPoint* points, const uint16_t* corners,
                       size_t triangles, WideTriangles& wide) {
  const Ints di;
  const size_t lanes = hn::Lanes(di);
  uint16_t* const number = wide.number.data();
  SweepPoint* const found[3] = {wide.corners[0].data(), wide.corners[1].data(), wide.corners[2].data()};
  size_t count = 0;
  // Copied by blocks, so that a vector is not read while its points are still on their way to the cache.
  constexpr size_t kBlock = 128;
  static_assert(hn::MaxLanes(Ints()) <= 32);
  SweepPoint block[3][kBlock] = {};
  for (size_t start = 0; start < triangles; start += kBlock) {
    const size_t filled = std::min(kBlock, triangles - start);
    for (size_t i = 0; i < filled; ++i, corners += 3) {
      block[0][i] = points[corners[0]];
      block[1][i] = points[corners[1]];
      block[2][i] = points[corners[2]];
    }
    for (size_t first = 0; first < filled; first += lanes) {
      const auto mayBe =
          hn::And(mayBeWide(setup, loadCorners(setup, {&block[0][first], &block[1][first], &block[2][first]})),
                  hn::FirstN(di, filled - first));
      uint8_t bytes[8] = {};
      hn::StoreMaskBits(di, mayBe, bytes);
      uint32_t bits = bytes[0] | static_cast<uint32_t>(bytes[1]) << 8 | static_cast<uint32_t>(bytes[2]) << 16 |
                      static_cast<uint32_t>(bytes[3]) << 24;
      for (; bits != 0; bits &= bits - 1, ++count) {
        const size_t i = first + hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
        number[count] = static_cast<uint16_t>(start + i);
        found[0][count] = block[0][i];
        found[1][count] = block[1][i];
        found[2][count] = block[2][i];
      }
    }
  }
  wide.count = count;
  for (size_t i = 0; i < count; i += lanes) {
    findPatterns(setup, loadCorners(setup, {found[0] + i, found[1] + i, found[2] + i}), &wide.pattern[i],
                 &wide.order[i]);
  }
}

}  // namespace ocelli::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ocelli {
namespace {

HWY_EXPORT(findWide);

}  // namespace

WideTriangles::WideTriangles(size_t most)
    : number(most + 1), pattern(most + SliceMesh::kPadding), order(most + SliceMesh::kPadding) {
  for (std::vector<SweepPoint>& each : corners) {
    each.resize(most + SliceMesh::kPadding);
  }
}

void findWideTriangles(const SliceKernelSetup& setup, const SweepPoint* points, const uint16_t* corners,
                       size_t triangles, WideTriangles& wide) {
  HWY_DYNAMIC_DISPATCH(findWide)(setup, points, corners, triangles, wide);
}

}  // namespace ocelli
#endif  // HWY_ONCE
