#include "display_sim/slicing/slicer_kernels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "display_sim/dither/blue_noise.h"
#include "display_sim/dither/dither.h"
#include "display_sim/frames/volume.h"
#include "display_sim/slicing/slice_mesh.h"
#include "display_sim/slicing/slicer.h"
#include "oc_core/base/conventions.h"

// This file is compiled once for each of these instruction sets; foreach_target.h includes it again and again.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "display_sim/slicing/slicer_kernels.cpp"
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ocelli::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Ints = hn::RebindToSigned<Floats>;
using Words = hn::RebindToUnsigned<Floats>;
using FloatVec = hn::Vec<Floats>;
using IntVec = hn::Vec<Ints>;

/// The arc tangent of `ratio` in [0, 1]: an odd polynomial, minimax to 6e-9 before rounding.
HWY_ATTR HWY_INLINE FloatVec arcTangent(FloatVec ratio) {
  constexpr float kCoefficients[] = {0.00245672464f, -0.0144013586f, 0.039781224f,  -0.0723485723f, 0.104989462f,
                                     -0.141612291f,  0.199859068f,   -0.333325982f, 0.999999881f};
  const Floats d;
  const FloatVec square = hn::Mul(ratio, ratio);
  FloatVec sum = hn::Zero(d);
  for (const float coefficient : kCoefficients) {
    sum = hn::Add(hn::Mul(sum, square), hn::Set(d, coefficient));
  }
  return hn::Mul(sum, ratio);
}

/// In (-pi, pi]; 0 at the axis.
HWY_ATTR HWY_INLINE FloatVec angleAboutAxis(FloatVec x, FloatVec z) {
  const Floats d;
  const FloatVec zero = hn::Zero(d);
  const FloatVec absX = hn::Abs(x);
  const FloatVec absZ = hn::Abs(z);
  const FloatVec larger = hn::Max(hn::Max(absX, absZ), hn::Set(d, 1e-30f));
  FloatVec angle = arcTangent(hn::Div(hn::Min(absX, absZ), larger));
  angle = hn::IfThenElse(hn::Gt(absZ, absX), hn::Sub(hn::Set(d, static_cast<float>(kPi / 2)), angle), angle);
  angle = hn::IfThenElse(hn::Lt(x, zero), hn::Sub(hn::Set(d, static_cast<float>(kPi)), angle), angle);
  return hn::IfThenElse(hn::Lt(z, zero), hn::Neg(angle), angle);
}

struct SweepVectors {
  IntVec sector;
  IntVec column;
  IntVec row;
  hn::Mask<Ints> outside;
  IntVec special;
};

/// Where this near to the axis, in columns, triangles are looked at closely whatever they span: findPatterns().
constexpr float kNearAxisColumns = 16.5f;  // half a column for the offset of the axis

/// As SweepPoint. Where a point is far outside its column and row are just outside.
HWY_ATTR HWY_INLINE SweepVectors locate(const SliceKernelSetup& setup, FloatVec x, FloatVec y, FloatVec z) {
  const Floats d;
  const Ints di;
  constexpr float kNextToAxis = 2;  // columns
  const FloatVec unit = hn::Set(d, static_cast<float>(kSweepUnit));
  const FloatVec zero = hn::Zero(d);
  const FloatVec sectors = hn::Set(d, setup.sectors);
  FloatVec sector = hn::Add(hn::Mul(angleAboutAxis(x, z), hn::Set(d, setup.stepsPerRadian)), hn::Set(d, 0.5f));
  sector = hn::IfThenElse(hn::Lt(sector, zero), hn::Add(sector, sectors), sector);
  // Rounding may have taken a point just below the first sector to the end of the last one.
  sector = hn::IfThenElse(hn::Lt(sector, sectors), sector, zero);
  const FloatVec radius = hn::Sqrt(hn::Add(hn::Mul(x, x), hn::Mul(z, z)));
  const FloatVec column = hn::Add(hn::Mul(radius, hn::Set(d, setup.columnsPerRadius)), hn::Set(d, setup.axisOffset));
  const FloatVec row = hn::Sub(hn::Set(d, setup.rowOfCenter), hn::Mul(y, hn::Set(d, setup.rowsPerUnit)));
  const FloatVec farthest = hn::Set(d, setup.columnsOutwards);
  const FloatVec rows = hn::Set(d, setup.rows);
  const auto outside = hn::Or(hn::Gt(column, farthest), hn::Or(hn::Lt(row, zero), hn::Gt(row, rows)));
  const auto special = hn::Or(outside, hn::Lt(column, hn::Set(d, kNextToAxis)));
  const auto nearAxis = hn::Lt(column, hn::Set(d, kNearAxisColumns));
  const FloatVec one = hn::Set(d, 1.0f);
  const FloatVec nearColumn = hn::Min(column, hn::Add(farthest, one));
  const FloatVec nearRow = hn::Max(hn::Neg(one), hn::Min(row, hn::Add(rows, one)));
  return {hn::ConvertTo(di, hn::Mul(sector, unit)), hn::ConvertTo(di, hn::Mul(nearColumn, unit)),
          hn::ConvertTo(di, hn::Mul(nearRow, unit)), hn::RebindMask(di, outside),
          hn::IfThenElse(hn::RebindMask(di, special), hn::Set(di, kSpecial),
                         hn::IfThenElseZero(hn::RebindMask(di, nearAxis), hn::Set(di, kNearAxis)))};
}

/// In kLightSteps, less than all of them.
HWY_ATTR HWY_INLINE IntVec thresholdAt(const SliceKernelSetup& setup, IntVec slice, IntVec column, IntVec row) {
  const Ints di;
  const Words dw;
  if (setup.ordered) {
    const auto sum = hn::Add(hn::Mul(hn::BitCast(dw, column), hn::Set(dw, kDitherColumnStep)),
                             hn::Add(hn::Mul(hn::BitCast(dw, row), hn::Set(dw, kDitherRowStep)),
                                     hn::Mul(hn::BitCast(dw, slice), hn::Set(dw, kDitherSliceStep))));
    return hn::BitCast(di, hn::ShiftRight<17>(sum));
  }
  if (setup.mask.empty()) {
    return hn::Set(di, kLightSteps / 2);
  }
  static_assert(kBlueNoiseSide == 32);
  const IntVec last = hn::Set(di, kBlueNoiseSide - 1);
  const IntVec position = hn::Or(hn::ShiftLeft<10>(hn::And(slice, last)),
                                 hn::Or(hn::ShiftLeft<5>(hn::And(row, last)), hn::And(column, last)));
  return hn::GatherIndex(di, setup.mask.data(), position);
}

/// The level, of those of the display, that a light has at a threshold in [0, kLightSteps).
HWY_ATTR HWY_INLINE IntVec levelOf(const SliceKernelSetup& setup, IntVec light, IntVec threshold) {
  const Ints di;
  const IntVec full = hn::Set(di, setup.fullLevel);
  if (setup.occupancy) {
    return hn::IfThenElseZero(hn::Gt(light, hn::Zero(di)), full);
  }
  const IntVec rest = hn::Sub(hn::Set(di, kLightSteps - 1), threshold);
  return hn::ShiftRight<15>(hn::Add(hn::Mul(light, full), rest));
}

/// Which of the voxels that a sample may light is asked for.
enum class SampleVoxel {
  kOwn,        ///< the one that holds it; its share of the light if antialiased
  kNeighbour,  ///< the one of the nearest other sector, with the rest of the light
};

struct LightVectors {
  IntVec red;
  IntVec green;
  IntVec blue;
};

HWY_ATTR HWY_INLINE void appendLit(const SliceKernelSetup& setup, const SweepVectors& at, LightVectors light,
                                   SampleVoxel which, bool secondHalf, hn::Mask<Ints> counts, size_t to,
                                   LitSamples& lit) {
  const Ints di;
  const Words dw;
  const IntVec zero = hn::Zero(di);
  const IntVec half = hn::Set(di, setup.slicesPerHalfTurn);
  IntVec sector = hn::ShiftRight<16>(at.sector);
  if (setup.antialiased) {
    // From -1/2 to 1/2 of a sector around its middle, in kLightSteps.
    const IntVec rest =
        hn::Sub(hn::ShiftRight<1>(hn::And(at.sector, hn::Set(di, kSweepUnit - 1))), hn::Set(di, kLightSteps / 2));
    IntVec share = hn::Abs(rest);
    if (which == SampleVoxel::kOwn) {
      share = hn::Sub(hn::Set(di, kLightSteps), share);
    } else {
      const IntVec sectors = hn::Set(di, setup.sectorCount);
      const IntVec one = hn::Set(di, 1);
      sector = hn::IfThenElse(hn::Lt(rest, zero), hn::Sub(sector, one), hn::Add(sector, one));
      sector = hn::IfThenElse(hn::Lt(sector, zero), hn::Add(sector, sectors), sector);
      sector = hn::IfThenElse(hn::Lt(sector, sectors), sector, zero);
    }
    light.red = hn::ShiftRight<15>(hn::Mul(light.red, share));
    light.green = hn::ShiftRight<15>(hn::Mul(light.green, share));
    light.blue = hn::ShiftRight<15>(hn::Mul(light.blue, share));
  }
  const auto firstHalf = hn::Lt(sector, half);
  IntVec slice = hn::IfThenElse(firstHalf, sector, hn::Sub(sector, half));
  const IntVec outwards = hn::Min(hn::ShiftRight<16>(at.column), hn::Set(di, setup.lastColumn - setup.axisColumn));
  const IntVec right = hn::Add(hn::Set(di, setup.axisColumn), outwards);
  const IntVec left = hn::Sub(hn::Set(di, setup.lastColumn), right);
  IntVec column = hn::IfThenElse(firstHalf, right, left);
  if (secondHalf) {
    slice = hn::Add(slice, half);
    column = hn::Sub(hn::Set(di, setup.lastColumn), column);
  }
  const IntVec row = hn::Min(hn::ShiftRight<16>(at.row), hn::Set(di, setup.lastRow));
  const IntVec position = hn::Add(hn::Mul(row, hn::Set(di, setup.paddedColumns)), column);

  const IntVec threshold = thresholdAt(setup, slice, column, row);
  const IntVec red = levelOf(setup, light.red, threshold);
  const IntVec green = levelOf(setup, light.green, threshold);
  const IntVec blue = levelOf(setup, light.blue, threshold);
  const IntVec levels = setup.oneBit ? hn::Or(red, hn::Or(hn::ShiftLeft<1>(green), hn::ShiftLeft<2>(blue)))
                                     : hn::Or(red, hn::Or(hn::ShiftLeft<8>(green), hn::ShiftLeft<16>(blue)));
  const auto isDark = hn::Or(hn::Or(at.outside, hn::Not(counts)), hn::Eq(levels, zero));
  const IntVec bin = hn::IfThenElse(isDark, hn::Set(di, setup.noSlice), slice);
  hn::StoreU(hn::BitCast(dw, bin), dw, lit.slice.data() + to);
  if (setup.oneBit) {
    hn::StoreU(hn::BitCast(dw, hn::Or(hn::ShiftLeft<3>(position), levels)), dw, lit.position.data() + to);
  } else {
    hn::StoreU(hn::BitCast(dw, position), dw, lit.position.data() + to);
    hn::StoreU(hn::BitCast(dw, levels), dw, lit.levels.data() + to);
  }
}

HWY_ATTR SectorReach light(const SliceKernelSetup& setup, const SliceSamples& samples, SweepPoint* points,
                           LitSamples& lit) {
  const Floats d;
  const Ints di;
  const IntVec turn = hn::Set(di, setup.sectorCount * kSweepUnit);
  const IntVec halfTurn = hn::ShiftRight<1>(turn);
  IntVec first = turn;
  IntVec last = hn::Zero(di);
  IntVec shiftedFirst = turn;
  IntVec shiftedLast = hn::Neg(turn);
  IntVec innermost = turn;
  const auto lightAt = [&](const float* channel, size_t i)
                           HWY_ATTR { return hn::ConvertTo(di, hn::Add(hn::LoadU(d, channel + i), hn::Set(d, 0.5f))); };
  const IntVec full = hn::Set(di, kLightSteps);
  const size_t stride = hwy::RoundUpTo(samples.count, hn::Lanes(d));
  lit.count = stride * (setup.antialiased ? 2u : 1u) * (setup.ownSecondHalf ? 2u : 1u);
  for (size_t i = 0; i < samples.count; i += hn::Lanes(d)) {
    const SweepVectors at =
        locate(setup, hn::LoadU(d, samples.x + i), hn::LoadU(d, samples.y + i), hn::LoadU(d, samples.z + i));
    const auto counts = hn::FirstN(di, samples.count - i);
    if (points != nullptr) {
      hn::StoreInterleaved4(at.sector, at.column, at.row, at.special, di, &points[i].sector);
      const IntVec shifted = hn::IfThenElse(hn::Lt(at.sector, halfTurn), at.sector, hn::Sub(at.sector, turn));
      first = hn::Min(first, hn::IfThenElse(counts, at.sector, first));
      last = hn::Max(last, hn::IfThenElse(counts, at.sector, last));
      shiftedFirst = hn::Min(shiftedFirst, hn::IfThenElse(counts, shifted, shiftedFirst));
      shiftedLast = hn::Max(shiftedLast, hn::IfThenElse(counts, shifted, shiftedLast));
      innermost = hn::Min(innermost, hn::IfThenElse(counts, at.column, innermost));
    }
    LightVectors color{full, full, full};
    if (samples.red != nullptr) {
      color = {lightAt(samples.red, i), lightAt(samples.green, i), lightAt(samples.blue, i)};
    }
    // The samples once for each voxel that they may light, one after the other.
    size_t to = i;
    for (const SampleVoxel which : {SampleVoxel::kOwn, SampleVoxel::kNeighbour}) {
      if (which == SampleVoxel::kOwn || setup.antialiased) {
        for (int half = 0; half < (setup.ownSecondHalf ? 2 : 1); ++half) {
          appendLit(setup, at, color, which, half == 1, counts, to, lit);
          to += stride;
        }
      }
    }
  }
  const auto reachOf = [&](IntVec lowest, IntVec highest) HWY_ATTR {
    constexpr int kSectorShift = 16;
    const auto axis = static_cast<int32_t>(setup.axisOffset * static_cast<float>(kSweepUnit));
    return SectorReach{hn::GetLane(hn::MinOfLanes(di, lowest)) >> kSectorShift,
                       hn::GetLane(hn::MaxOfLanes(di, highest)) >> kSectorShift,
                       hn::GetLane(hn::MinOfLanes(di, innermost)) <= axis};
  };
  const SectorReach reach = reachOf(first, last);
  const SectorReach around = reachOf(shiftedFirst, shiftedLast);
  return reach.last - reach.first <= around.last - around.first ? reach : around;
}

/// Whether three points span more than the limits in any direction, or one of them is special.
HWY_ATTR HWY_INLINE bool isWide(const SweepPoint& p, const SweepPoint& q, const SweepPoint& r,
                                const SweepPoint& limits) {
#if HWY_TARGET == HWY_SCALAR
  const auto spans = [](int32_t a, int32_t b, int32_t c, int32_t limit) {
    return std::max({a, b, c}) - std::min({a, b, c}) > limit;
  };
  return spans(p.sector, q.sector, r.sector, limits.sector) || spans(p.column, q.column, r.column, limits.column) ||
         spans(p.row, q.row, r.row, limits.row) || std::max({p.special, q.special, r.special}) > 0;
#else
  const hn::FixedTag<int32_t, 4> d;
  alignas(16) constexpr int32_t kAllButSpecial[4] = {-1, -1, -1, 0};
  const auto a = hn::LoadU(d, &p.sector);
  const auto b = hn::LoadU(d, &q.sector);
  const auto c = hn::LoadU(d, &r.sector);
  const auto low = hn::And(hn::Min(a, hn::Min(b, c)), hn::Load(d, kAllButSpecial));
  const auto extent = hn::Sub(hn::Max(a, hn::Max(b, c)), low);
  return !hn::AllFalse(d, hn::Gt(extent, hn::LoadU(d, &limits.sector)));
#endif
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

HWY_ATTR HWY_INLINE FloatVec largestOf(FloatVec a, FloatVec b, FloatVec c) {
  return hn::Max(a, hn::Max(b, c));
}

/// The patterns of triangles that are given by their corners: triangle_strips.h.
HWY_ATTR HWY_INLINE void findPatterns(const SliceKernelSetup& setup, const SweepPoint* const (&corners)[3],
                                      int32_t* pattern, int32_t* order) {
  const Floats d;
  const Ints di;
  const FloatVec one = hn::Set(d, 1.0f);
  const FloatVec half = hn::Set(d, 0.5f);
  const FloatVec unit = hn::Set(d, 1.0f / kSweepUnit);
  const FloatVec limit = hn::Set(d, kWidestPiece);
  IntVec sectors[3], columns[3], rows[3], special[3];
  for (size_t k = 0; k < 3; ++k) {
    hn::LoadInterleaved4(di, &corners[k]->sector, sectors[k], columns[k], rows[k], special[k]);
  }
  const IntVec first = hn::Min(sectors[0], hn::Min(sectors[1], sectors[2]));
  const IntVec last = hn::Max(sectors[0], hn::Max(sectors[1], sectors[2]));
  const FloatVec radians = hn::Mul(unit, hn::Set(d, setup.radiansPerStep));
  const FloatVec angle = hn::Mul(hn::Mul(hn::ConvertTo(d, hn::Sub(last, first)), radians), half);
  // Each corner seen from the middle of their angles.
  LocalVectors points[3];
  FloatVec radius[3];
  for (size_t k = 0; k < 3; ++k) {
    const FloatVec turn = hn::Sub(hn::Mul(hn::ConvertTo(d, hn::Sub(sectors[k], first)), radians), angle);
    const FloatVec square = hn::Mul(turn, turn);
    // To 1e-8 of 1 in the angles that are good, below.
    const FloatVec sine = hn::Mul(
        turn, hn::Sub(one, hn::Mul(square, hn::Sub(hn::Set(d, 1.0f / 6), hn::Mul(square, hn::Set(d, 1.0f / 120))))));
    const FloatVec cosine =
        hn::Sub(one, hn::Mul(square, hn::Sub(half, hn::Mul(square, hn::Sub(hn::Set(d, 1.0f / 24),
                                                                           hn::Mul(square, hn::Set(d, 1.0f / 720)))))));
    radius[k] = hn::Sub(hn::Mul(hn::ConvertTo(d, columns[k]), unit), hn::Set(d, setup.axisOffset));
    points[k] = {hn::Mul(radius[k], cosine), hn::Mul(radius[k], sine), hn::Mul(hn::ConvertTo(d, rows[k]), unit)};
  }
  const FloatVec innermost = hn::Min(points[0].r, hn::Min(points[1].r, points[2].r));
  constexpr float kWidestAngle = 0.25f;
  const auto good =
      hn::And(hn::And(hn::Le(angle, hn::Set(d, kWidestAngle)), hn::Ge(innermost, one)),
              hn::RebindMask(d, hn::Lt(hn::Max(special[0], hn::Max(special[1], special[2])), hn::Set(di, kSpecial))));
  const SpanMeasure measure{hn::Div(hn::Set(d, setup.stepsPerRadian), hn::Max(innermost, one)), angle};
  LocalVectors sides[3];
  SpanVectors spans[3];
  FloatVec length[3];
  for (size_t k = 0; k < 3; ++k) {
    sides[k] = points[(k + 1) % 3] - points[k];
    spans[k] = measure.of(sides[k]);
    length[k] = largest(spans[k]);
  }
  // Corners alone: (3), multiplied by x y z.
  const FloatVec chord = hn::Mul(largestOf(radius[0], radius[1], radius[2]), hn::Mul(angle, angle));  // >= 2 k
  const FloatVec x = largestOf(spans[0].sectors, spans[1].sectors, spans[2].sectors);
  const FloatVec y = hn::Add(largestOf(spans[0].columns, spans[1].columns, spans[2].columns), chord);
  const FloatVec z = largestOf(spans[0].rows, spans[1].rows, spans[2].rows);
  const FloatVec xy = hn::Mul(x, y);
  const auto cornersSuffice = hn::And(
      hn::Lt(largestOf(x, y, z), limit),
      hn::Gt(hn::Mul(limit, hn::Add(xy, hn::Mul(z, hn::Add(x, y)))), hn::Mul(hn::Set(d, 4.0f), hn::Mul(xy, z))));
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
  found = hn::IfThenElse(hn::RebindMask(di, cornersSuffice), hn::Set(di, WideTriangles::kCornersSuffice), found);
  found = hn::IfThenElse(hn::RebindMask(di, good), found, hn::Set(di, WideTriangles::kFoundExactly));
  hn::StoreU(found, di, pattern);
  hn::StoreU(hn::IfThenElse(hn::RebindMask(di, mirrored), hn::Add(corner, hn::Set(di, 3)), corner), di, order);
}

HWY_ATTR void findWide(const SliceKernelSetup& setup, const SweepPoint* points, const uint16_t* corners,
                       size_t triangles, WideTriangles& wide) {
  const Ints di;
  const SweepPoint limits{setup.smallSectors, setup.smallColumns, setup.smallRows, 0};
  uint16_t* number = wide.number.data();
  size_t count = 0;
  for (size_t t = 0; t < triangles; ++t, corners += 3) {
    number[count] = static_cast<uint16_t>(t);
    count += isWide(points[corners[0]], points[corners[1]], points[corners[2]], limits) ? 1 : 0;
  }
  corners -= 3 * triangles;
  const int32_t halfTurn = setup.slicesPerHalfTurn * kSweepUnit;
  size_t kept = 0;
  for (size_t i = 0; i < count; ++i) {
    SweepPoint corner[3];
    for (size_t k = 0; k < 3; ++k) {
      corner[k] = points[corners[3 * number[i] + k]];
    }
    const auto [lowest, highest] = std::minmax({corner[0].sector, corner[1].sector, corner[2].sector});
    if (HWY_UNLIKELY(highest - lowest > halfTurn)) {
      // Past the last sector comes the first: measured from -N to N.
      for (SweepPoint& each : corner) {
        each.sector -= each.sector < halfTurn ? 0 : 2 * halfTurn;
      }
    }
    for (size_t k = 0; k < 3; ++k) {
      wide.corners[k][kept] = corner[k];
    }
    number[kept++] = number[i];
  }
  wide.count = kept;
  for (size_t i = 0; i < kept; i += hn::Lanes(di)) {
    const SweepPoint* const of[3] = {&wide.corners[0][i], &wide.corners[1][i], &wide.corners[2][i]};
    findPatterns(setup, of, &wide.pattern[i], &wide.order[i]);
  }
}

int64_t target() {
  return HWY_TARGET;
}

/// Writes what a mixture of a triangle's corners has, where these have `values`.
template <class D>
HWY_ATTR HWY_INLINE void mixCorners(D d, const float* HWY_RESTRICT values, const SampledTriangle& t, hn::Vec<D> ofB,
                                    hn::Vec<D> ofC, float* HWY_RESTRICT to) {
  const float a = values[t.corners[0]];
  const auto second = hn::Mul(ofB, hn::Set(d, values[t.corners[1]] - a));
  const auto third = hn::Mul(ofC, hn::Set(d, values[t.corners[2]] - a));
  hn::StoreU(hn::Add(hn::Set(d, a), hn::Add(second, third)), d, to);
}

HWY_ATTR size_t sample(const SliceSamples& mesh, const TriangleStrips& strips, const SampledTriangle* triangles,
                       size_t count, SampleRoom& room) {
  const hn::CappedTag<float, 8> d;
  const SliceSamples from = mesh;
  const float* HWY_RESTRICT weightsOfB = strips.weightsOfB();
  const float* HWY_RESTRICT weightsOfC = strips.weightsOfC();
  float* const x = room.x.data();
  float* const y = room.y.data();
  float* const z = room.z.data();
  float* const red = room.red.data();
  float* const green = room.green.data();
  float* const blue = room.blue.data();
  size_t done = 0;
  size_t end = room.count;
  for (; done < count && end + triangles[done].samples <= room.capacity; ++done) {
    const SampledTriangle t = triangles[done];
    for (size_t i = 0; i < t.samples; i += hn::Lanes(d)) {
      const auto ofB = hn::LoadU(d, weightsOfB + t.firstWeight + i);
      const auto ofC = hn::LoadU(d, weightsOfC + t.firstWeight + i);
      mixCorners(d, from.x, t, ofB, ofC, x + end + i);
      mixCorners(d, from.y, t, ofB, ofC, y + end + i);
      mixCorners(d, from.z, t, ofB, ofC, z + end + i);
      if (from.red != nullptr) {
        mixCorners(d, from.red, t, ofB, ofC, red + end + i);
        mixCorners(d, from.green, t, ofB, ofC, green + end + i);
        mixCorners(d, from.blue, t, ofB, ofC, blue + end + i);
      }
    }
    end += t.samples;
  }
  room.count = end;
  return done;
}

HWY_ATTR void planesOf(uint32_t* levels, std::span<const uint32_t> bytes, int bitsPerChannel, uint8_t* planes,
                       size_t planeBytes) {
  const hn::CappedTag<uint32_t, 8> d;
  for (const uint32_t byte : bytes) {
    uint32_t* eight = levels + 8 * size_t{byte};
    uint8_t* plane = planes + byte;
    for (int channel = 0; channel < kColorChannels; ++channel) {
      for (int bit = 0; bit < bitsPerChannel; ++bit, plane += planeBytes) {
        const auto wanted = hn::Set(d, 1u << (8 * channel + bit));
        unsigned lit = 0;
        for (size_t i = 0; i < 8; i += hn::Lanes(d)) {
          uint8_t bits[8] = {};
          hn::StoreMaskBits(d, hn::TestBit(hn::LoadU(d, eight + i), wanted), bits);
          lit |= static_cast<unsigned>(bits[0]) << i;
        }
        *plane = static_cast<uint8_t>(lit);
      }
    }
    std::fill_n(eight, 8, 0u);
  }
}

}  // namespace ocelli::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ocelli {
namespace {

HWY_EXPORT(light);
HWY_EXPORT(findWide);
HWY_EXPORT(sample);
HWY_EXPORT(planesOf);
HWY_EXPORT(target);

int32_t inSweepUnits(double voxels) {
  return static_cast<int32_t>(voxels * kSweepUnit);
}

/// A triangle that spans the angle T = 2 a, no more than so many sectors and 0.68 columns and rows 0.74, and lies
/// kNearAxisColumns from the axis or farther, has (triangle_strips.h; R columns at the rim, |d.r| <= 0.68 + R T^2 / 8,
/// |d.t| <= R T + 0.68 a)
///   V + 2 k <= 0.68 (1 + a^2) + (1/8 + 1/2 + 1/4) R T^2 <= 0.73
///   U <= 0.68 (16.68 / 16 + (2 x 0.68 + R T^2 / 8) / (2 x 16)) (1 + a^2) <= 0.74
/// and 1/0.74 + 1/0.73 + 1/0.74 > 4.07: its corners suffice.
double smallSectorsOf(const DisplayProfile& profile) {
  const double steps = profile.slicesPerHalfTurn / kPi;
  return std::min(0.68, std::min(0.1, std::sqrt(0.04 / (0.875 * profile.width / 2))) * steps);
}

}  // namespace

SliceKernelSetup::SliceKernelSetup(const DisplayProfile& profile, const SliceOptions& options)
    : stepsPerRadian(static_cast<float>(profile.slicesPerHalfTurn / kPi)),
      sectors(static_cast<float>(2 * profile.slicesPerHalfTurn)),
      sectorCount(2 * profile.slicesPerHalfTurn),
      slicesPerHalfTurn(profile.slicesPerHalfTurn),
      radiansPerStep(static_cast<float>(kPi / profile.slicesPerHalfTurn)),
      smallSectors(inSweepUnits(smallSectorsOf(profile))),
      smallColumns(inSweepUnits(0.68)),
      smallRows(inSweepUnits(0.74)),
      columnsPerRadius(static_cast<float>(profile.width) / 2),
      axisOffset(profile.width % 2 == 0 ? 0.0f : 0.5f),
      columnsOutwards(static_cast<float>(profile.width - profile.width / 2)),
      lastColumn(profile.width - 1),
      axisColumn(profile.width / 2),
      rowsPerUnit(static_cast<float>(profile.height / 2.0 / profile.halfHeightRadii)),
      rowOfCenter(static_cast<float>(profile.height) / 2),
      rows(static_cast<float>(profile.height)),
      lastRow(profile.height - 1),
      paddedColumns(static_cast<int32_t>(8 * VolumeLayout(profile).rowBytes)),
      fullLevel((1 << profile.colorBitsPerChannel) - 1),
      occupancy(options.colors == ColorReduction::kOccupancy),
      ordered(options.colors == ColorReduction::kDither),
      oneBit(profile.colorBitsPerChannel == 1),
      antialiased(options.angularAntialiasing),
      ownSecondHalf(profile.secondHalfTurn == SecondHalfTurn::kOwn),
      noSlice(profile.storedSlices()) {
  static_assert(kBlueNoiseRanks == kLightSteps, "the mask's ranks are thresholds");
  if (options.colors == ColorReduction::kBlueNoise) {
    mask.assign(blueNoiseMask().begin(), blueNoiseMask().end());
  }
}

LitSamples::LitSamples(size_t samples) {
  constexpr size_t kMaxPerSample = 4;  // in two slices, of both half turns
  for (std::vector<uint32_t>* words : {&slice, &position, &levels}) {
    words->resize(kMaxPerSample * (samples + SliceMesh::kPadding));
  }
}

WideTriangles::WideTriangles(size_t most)
    : number(most + 1), pattern(most + SliceMesh::kPadding), order(most + SliceMesh::kPadding) {
  for (std::vector<SweepPoint>& each : corners) {
    each.resize(most + SliceMesh::kPadding);
  }
}

SampleRoom::SampleRoom(size_t room) : capacity(room) {
  for (std::vector<float>* values : {&x, &y, &z, &red, &green, &blue}) {
    values->resize(capacity + SliceMesh::kPadding);
  }
}

SliceSamples SampleRoom::samples(bool white) const {
  SliceSamples samples{x.data(), y.data(), z.data(), red.data(), green.data(), blue.data(), count};
  if (white) {
    samples.red = samples.green = samples.blue = nullptr;
  }
  return samples;
}

SectorReach lightSamples(const SliceKernelSetup& setup, const SliceSamples& samples, SweepPoint* points,
                         LitSamples& lit) {
  return HWY_DYNAMIC_DISPATCH(light)(setup, samples, points, lit);
}

void findWideTriangles(const SliceKernelSetup& setup, const SweepPoint* points, const uint16_t* corners,
                       size_t triangles, WideTriangles& wide) {
  HWY_DYNAMIC_DISPATCH(findWide)(setup, points, corners, triangles, wide);
}

size_t sampleTriangles(const SliceSamples& mesh, const TriangleStrips& strips, const SampledTriangle* triangles,
                       size_t count, SampleRoom& room) {
  return HWY_DYNAMIC_DISPATCH(sample)(mesh, strips, triangles, count, room);
}

void writePlanes(uint32_t* levels, std::span<const uint32_t> bytes, int bitsPerChannel, uint8_t* planes,
                 size_t planeBytes) {
  HWY_DYNAMIC_DISPATCH(planesOf)(levels, bytes, bitsPerChannel, planes, planeBytes);
}

std::string sliceInstructionSet() {
  return hwy::TargetName(HWY_DYNAMIC_DISPATCH(target)());
}

}  // namespace ocelli
#endif  // HWY_ONCE
