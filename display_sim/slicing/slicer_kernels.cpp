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
#include "oc_core/base/vector_targets.h"

// This file is compiled once for each of these instruction sets; foreach_target.h includes it again and again.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "display_sim/slicing/slicer_kernels.cpp"
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
  const FloatVec one = hn::Set(d, 1.0f);
  const FloatVec nearColumn = hn::Min(column, hn::Add(farthest, one));
  const FloatVec nearRow = hn::Max(hn::Neg(one), hn::Min(row, hn::Add(rows, one)));
  return {hn::ConvertTo(di, hn::Mul(sector, unit)), hn::ConvertTo(di, hn::Mul(nearColumn, unit)),
          hn::ConvertTo(di, hn::Mul(nearRow, unit)), hn::RebindMask(di, outside),
          hn::IfThenElseZero(hn::RebindMask(di, special), hn::Set(di, kSpecial))};
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
HWY_EXPORT(sample);
HWY_EXPORT(planesOf);
HWY_EXPORT(target);

}  // namespace

SliceKernelSetup::SliceKernelSetup(const DisplayProfile& profile, const SliceOptions& options)
    : stepsPerRadian(static_cast<float>(profile.slicesPerHalfTurn / kPi)),
      sectors(static_cast<float>(2 * profile.slicesPerHalfTurn)),
      sectorCount(2 * profile.slicesPerHalfTurn),
      slicesPerHalfTurn(profile.slicesPerHalfTurn),
      radiansPerStep(static_cast<float>(kPi / profile.slicesPerHalfTurn)),
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
