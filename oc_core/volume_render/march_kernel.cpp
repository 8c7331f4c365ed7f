#include "oc_core/volume_render/march_kernel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>

#include "oc_core/volume/volume_bricks.h"

// This file is compiled once for each of these instruction sets; foreach_target.h includes it again and again.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "oc_core/volume_render/march_kernel.cpp"
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "oc_core/volume_render/march_field-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ocelli::HWY_NAMESPACE {

/// A piece, in single precision, and where it begins along the rays' part that it belongs to.
struct MarchPiece {
  glm::vec3 from;
  glm::vec3 way;
  glm::vec3 half;  ///< the direction between that to the light and that to the eye
  float begin;
  float t;
  float tByLength;
};

/// Pieces that continue each other.
struct MarchPart {
  const MarchPiece* pieces;
  size_t count;
  float length;
  float voxelsByLength;  ///< no index coordinate changes faster
};

struct Places {
  Point index;
  Point half;
};

/// The places at these lengths, which do not fall, from the piece `first` on.
template <bool kWithHalf>
HWY_ATTR HWY_INLINE Places placesAt(const MarchPart& part, size_t first, FloatVec length, float last) {
  const Floats d;
  const auto along = [&](const MarchPiece& piece) HWY_ATTR {
    const FloatVec rest = hn::Sub(length, hn::Set(d, piece.begin));
    Places p{{hn::MulAdd(rest, hn::Set(d, piece.way.x), hn::Set(d, piece.from.x)),
              hn::MulAdd(rest, hn::Set(d, piece.way.y), hn::Set(d, piece.from.y)),
              hn::MulAdd(rest, hn::Set(d, piece.way.z), hn::Set(d, piece.from.z))},
             {hn::Zero(d), hn::Zero(d), hn::Zero(d)}};
    if constexpr (kWithHalf) {
      p.half = {hn::Set(d, piece.half.x), hn::Set(d, piece.half.y), hn::Set(d, piece.half.z)};
    }
    return p;
  };
  Places places = along(part.pieces[first]);
  for (size_t i = first + 1; i < part.count && part.pieces[i].begin <= last; ++i) {
    const Places next = along(part.pieces[i]);
    const auto isNext = hn::Ge(length, hn::Set(d, part.pieces[i].begin));
    const auto choose = [&](FloatVec& a, FloatVec b) HWY_ATTR { a = hn::IfThenElse(isNext, b, a); };
    choose(places.index.x, next.index.x);
    choose(places.index.y, next.index.y);
    choose(places.index.z, next.index.z);
    if constexpr (kWithHalf) {
      choose(places.half.x, next.half.x);
      choose(places.half.y, next.half.y);
      choose(places.half.z, next.half.z);
    }
  }
  return places;
}

/// The colour of a place becomes colour * factor + added.
struct Light {
  FloatVec factor;
  FloatVec added;
};

/// As VolumeLighting::at(). Gradients are central differences.
template <class Field>
HWY_ATTR HWY_NOINLINE Light lightAt(const MarchSetup& setup, const Field& field, const Places& places) {
  const Floats d;
  const Point p = field.centerNear(places.index);
  const FloatVec one = hn::Set(d, 1.0f);
  const FloatVec half = hn::Set(d, 0.5f);
  const FloatVec gx = hn::Sub(field.at({hn::Add(p.x, one), p.y, p.z}), field.at({hn::Sub(p.x, one), p.y, p.z}));
  const FloatVec gy = hn::Sub(field.at({p.x, hn::Add(p.y, one), p.z}), field.at({p.x, hn::Sub(p.y, one), p.z}));
  const FloatVec gz = hn::Sub(field.at({p.x, p.y, hn::Add(p.z, one)}), field.at({p.x, p.y, hn::Sub(p.z, one)}));
  const glm::mat3& m = setup.worldFromIndexGradient;
  const auto row = [&](int i) HWY_ATTR {
    return hn::Mul(half, hn::MulAdd(gx, hn::Set(d, m[0][i]),
                                    hn::MulAdd(gy, hn::Set(d, m[1][i]), hn::Mul(gz, hn::Set(d, m[2][i])))));
  };
  const Point g{row(0), row(1), row(2)};
  const auto dot = [&](const Point& a, const Point& b)
                       HWY_ATTR { return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z))); };
  const FloatVec length = hn::Sqrt(dot(g, g));
  const FloatVec perLength = hn::Div(one, hn::Max(length, hn::Set(d, 1e-30f)));
  const FloatVec lit = hn::Min(one, hn::Mul(length, hn::Set(d, setup.litByGradient)));
  const Point toLight{hn::Set(d, setup.toLight.x), hn::Set(d, setup.toLight.y), hn::Set(d, setup.toLight.z)};
  const FloatVec cosine = hn::Mul(hn::Abs(dot(g, toLight)), perLength);
  const FloatVec shade = hn::MulAdd(cosine, hn::Set(d, setup.diffuse), hn::Set(d, setup.ambient));
  Light light{hn::MulAdd(lit, hn::Sub(shade, one), one), hn::Zero(d)};
  if (setup.specular > 0) {
    const FloatVec highlight = hn::Mul(hn::Abs(dot(g, places.half)), perLength);
    const FloatVec power =
        hn::Exp(d, hn::Mul(hn::Set(d, setup.shininess), hn::Log(d, hn::Max(highlight, hn::Set(d, 1e-30f)))));
    light.added = hn::Mul(hn::Mul(lit, hn::Set(d, setup.specular)), power);
  }
  return light;
}

constexpr size_t kLanes = HWY_LANES(float);

/// Extinction, and light of each channel, of the steps of a group: each is that of one sample and the one before it.
struct Steps {
  HWY_ALIGN float four[4 * kLanes];  ///< by step: optical depth, and red, green and blue times it
};

/// What a step needs of the sample before it.
struct Before {
  Quad integral;
  Quad rest;
  Quad at;
  float entry;
};

/// `entry` are places in the table. `length` are those of the steps that end at each sample.
HWY_ATTR HWY_INLINE void lookUp(const MarchSetup& setup, FloatVec entry, FloatVec length, Before& before,
                                Steps& steps) {
  const Floats d;
  const Ints di;
  HWY_ALIGN float entries[kLanes + 1 + 15];
  HWY_ALIGN int32_t which[kLanes];
  HWY_ALIGN float shares[kLanes];
  HWY_ALIGN float byChange[kLanes];
  HWY_ALIGN float byMean[kLanes];
  // Beyond the table it is constant: the first and the last two entries are the same.
  const FloatVec bounded = hn::Min(hn::Max(entry, hn::Zero(d)), hn::Set(d, float(OpticalTable::kEntries - 2)));
  const IntVec index = hn::ConvertTo(di, bounded);
  hn::Store(index, di, which);
  hn::Store(hn::Sub(entry, hn::ConvertTo(d, index)), d, shares);
  entries[0] = before.entry;
  hn::StoreU(entry, d, entries + 1);
  const FloatVec change = hn::Sub(entry, hn::Load(d, entries));
  // Where the field hardly changes, by the mean of both ends.
  const auto isSmall = hn::Lt(hn::Abs(change), hn::Set(d, 1.0f));
  const FloatVec zero = hn::Zero(d);
  hn::Store(hn::IfThenElse(isSmall, zero, hn::Div(length, hn::IfThenElse(isSmall, hn::Set(d, 1.0f), change))), d,
            byChange);
  hn::Store(hn::IfThenElse(isSmall, hn::Mul(length, hn::Set(d, 0.5f)), zero), d, byMean);
  for (size_t i = 0; i < kLanes; ++i) {
    const OpticalTable::Entry& e = setup.entries[which[i]];
    const Quad share = setQuad(shares[i]);
    const Quad integral = loadQuad(e.integral.data());
    const Quad first = loadQuad(e.at.data());
    const Quad growth = multiplyQuads(share, loadQuad(e.change.data()));
    const Quad at = addQuads(first, growth);
    const Quad middle = addQuads(first, multiplyQuads(growth, setQuad(0.5f)));
    const Quad rest = addQuads(loadQuad(e.rest.data()), multiplyQuads(share, middle));
    const Quad difference = addQuads(subtractQuads(integral, before.integral), subtractQuads(rest, before.rest));
    const Quad sum = multiplyQuads(addQuads(at, before.at), setQuad(byMean[i]));
    storeQuad(addQuads(sum, multiplyQuads(difference, setQuad(byChange[i]))), steps.four + 4 * i);
    before.integral = integral;
    before.rest = rest;
    before.at = at;
  }
  before.entry = entries[kLanes];
}

/// A ray on its way.
template <class Field>
class March {
 public:
  HWY_ATTR March(const MarchSetup& setup, const Field& field, bool stopsAtDepth)
      : setup_(setup), field_(field), stopsAtDepth_(stopsAtDepth) {}

  const MarchResult& result() const { return result_; }
  bool isDone() const { return isDone_; }

  HWY_ATTR void run(const MarchPart& part) {
    const Floats d;
    const auto last = static_cast<int>(std::max(1.0f, std::ceil(part.length / setup_.step - 1e-4f)));  // sample
    const FloatVec lane = hn::Iota(d, 0.0f);
    Before before{setQuad(0), setQuad(0), setQuad(0), 0};
    bool isBefore = false;  // whether `before` is that of the sample before the group
    bool wasSeen = false;   // whether the brick of that sample shows something
    size_t piece = 0;
    for (int k = 0; k <= last && !isDone_;) {
      const auto lengthAt = [&](int sample) { return std::min(float(sample) * setup_.step, part.length); };
      while (piece + 1 < part.count && part.pieces[piece + 1].begin <= lengthAt(k)) {
        ++piece;
      }
      const auto lengthsFrom = [&](int sample) HWY_ATTR {
        const FloatVec number = hn::Add(hn::Set(d, float(sample)), lane);
        // The last sample is at the end, however long the rest is.
        const FloatVec length = hn::Min(hn::Mul(number, hn::Set(d, setup_.step)), hn::Set(d, part.length));
        return hn::IfThenElse(hn::Ge(number, hn::Set(d, float(last))), hn::Set(d, part.length), length);
      };
      FloatVec length = lengthsFrom(k);
      const auto endOf = [&](int sample) {
        return sample + int(kLanes) - 1 >= last ? part.length : lengthAt(sample + int(kLanes) - 1);
      };
      Point index = placesAt<false>(part, piece, length, endOf(k)).index;
      if (setup_.distances != nullptr) {
        int distance = 0;
        const bool isSeen = lookAtBricks(index, distance, lastIsSeen_);
        if (!isSeen && !wasSeen) {
          const float way = float((distance - 1) * VolumeBricks::kEdge);
          k += int(kLanes) + int(way / (part.voxelsByLength * setup_.step) * 0.9999f);
          isBefore = false;
          continue;
        }
        wasSeen = lastIsSeen_;
      }
      if (!isBefore && k > 0) {
        --k;
        while (piece > 0 && part.pieces[piece].begin > lengthAt(k)) {
          --piece;
        }
        length = lengthsFrom(k);
        index = placesAt<false>(part, piece, length, endOf(k)).index;
        if (setup_.distances != nullptr) {
          int distance = 0;
          lookAtBricks(index, distance, lastIsSeen_);
          wasSeen = lastIsSeen_;
        }
      }
      // The lengths of the steps that end at the samples; none ends at the first one.
      const FloatVec previous = lengthsFrom(k - 1);
      FloatVec step = hn::Sub(length, previous);
      const FloatVec entry = hn::Mul(field_.at(index), hn::Set(d, setup_.entriesByNumber));
      if (!isBefore) {
        step = hn::IfThenElse(hn::Lt(lane, hn::Set(d, 0.5f)), hn::Zero(d), step);
        before.entry = hn::GetLane(entry);
      }
      Steps steps;
      lookUp(setup_, entry, step, before, steps);
      result_.samples += uint32_t(std::min(int(kLanes), last + 1 - k));
      add(part, piece, k, length, step, endOf(k), steps);
      isBefore = true;
      k += int(kLanes);
    }
  }

 private:
  /// Whether the brick of one of the places shows something; the distance of that of the last one, and whether it does.
  HWY_ATTR HWY_INLINE bool lookAtBricks(const Point& index, int& distance, bool& lastIsSeen) const {
    const Floats d;
    const Ints di;
    const FloatVec bricksByVoxel = hn::Set(d, 1.0f / float(VolumeBricks::kEdge));
    const auto along = [&](FloatVec x, int count) HWY_ATTR {
      return hn::Min(hn::Max(hn::ConvertTo(di, hn::Mul(x, bricksByVoxel)), hn::Zero(di)), hn::Set(di, count - 1));
    };
    const IntVec i = along(index.x, setup_.bricks.x);
    const IntVec j = along(index.y, setup_.bricks.y);
    const IntVec k = along(index.z, setup_.bricks.z);
    const IntVec brick =
        hn::Add(hn::Mul(hn::Add(hn::Mul(k, hn::Set(di, setup_.bricks.y)), j), hn::Set(di, setup_.bricks.x)), i);
    const IntVec distances = hn::And(gatherWords(setup_.distances, brick), hn::Set(di, 0xff));
    HWY_ALIGN int32_t all[kLanes];
    hn::Store(distances, di, all);
    distance = all[kLanes - 1];
    lastIsSeen = distance == 0;
    return !hn::AllFalse(di, hn::Eq(distances, hn::Zero(di)));
  }

  /// Composites the steps of a group behind all before.
  HWY_ATTR HWY_INLINE void add(const MarchPart& part, size_t piece, int sample, FloatVec length, FloatVec step,
                               float end, const Steps& steps) {
    const Floats d;
    FloatVec depth;
    FloatVec red;
    FloatVec green;
    FloatVec blue;
    hn::LoadInterleaved4(d, steps.four, depth, red, green, blue);
    const FloatVec zero = hn::Zero(d);
    depth = hn::Max(depth, zero);
    const auto isSome = hn::Gt(depth, zero);
    if (hn::AllFalse(d, isSome)) {
      return;
    }
    HWY_ALIGN float sums[kLanes];
    HWY_ALIGN float passes[kLanes + 16];  // how much light passes all steps up to this one
    hn::Store(depth, d, sums);
    float sum = 0;
    for (size_t i = 0; i < kLanes; ++i) {
      sum += sums[i];
      sums[i] = sum;
    }
    passes[0] = 1;
    hn::StoreU(hn::Exp(d, hn::Neg(hn::Load(d, sums))), d, passes + 1);
    const FloatVec before = hn::Set(d, result_.transmittance);
    const FloatVec kept = hn::Mul(before, hn::Sub(hn::Load(d, passes), hn::LoadU(d, passes + 1)));
    const FloatVec byDepth = hn::Div(kept, hn::IfThenElse(isSome, depth, hn::Set(d, 1.0f)));
    red = hn::Mul(red, byDepth);
    green = hn::Mul(green, byDepth);
    blue = hn::Mul(blue, byDepth);
    if (setup_.isShaded && !hn::AllFalse(d, hn::Gt(kept, hn::Set(d, kUnseen)))) {
      // In the middle of each step.
      const FloatVec middle = hn::MulAdd(step, hn::Set(d, -0.5f), length);
      while (piece > 0 && part.pieces[piece].begin > hn::GetLane(middle)) {
        --piece;
      }
      const Light light = lightAt(setup_, field_, placesAt<true>(part, piece, middle, end));
      const FloatVec white = hn::Mul(kept, light.added);
      red = hn::MulAdd(red, light.factor, white);
      green = hn::MulAdd(green, light.factor, white);
      blue = hn::MulAdd(blue, light.factor, white);
    }
    const float transmittance = result_.transmittance * passes[kLanes];
    if (!result_.isDeep && 1 - transmittance >= setup_.depthOpacity) {
      const float share = findDepth(part, sample, length, step, sums);
      if (stopsAtDepth_) {
        addBeforeDepth(red, green, blue, kept, share);
        return;
      }
    }
    result_.color[0] += hn::GetLane(hn::SumOfLanes(d, red));
    result_.color[1] += hn::GetLane(hn::SumOfLanes(d, green));
    result_.color[2] += hn::GetLane(hn::SumOfLanes(d, blue));
    result_.transmittance = transmittance;
    isDone_ = transmittance <= setup_.endTransmittance;
  }

  /// Where the opacity reaches its threshold within a group: sets t; returns the step, and how much of it, as a sum.
  HWY_ATTR float findDepth(const MarchPart& part, int /*sample*/, FloatVec length, FloatVec step, const float* sums) {
    const Floats d;
    HWY_ALIGN float lengths[kLanes];
    HWY_ALIGN float stepLengths[kLanes];
    hn::Store(length, d, lengths);
    hn::Store(step, d, stepLengths);
    const float wanted = std::max(0.0f, std::log(result_.transmittance / (1 - setup_.depthOpacity)));
    size_t i = 0;
    while (i + 1 < kLanes && sums[i] < wanted) {
      ++i;
    }
    const float first = i > 0 ? sums[i - 1] : 0;
    const float share = sums[i] > first ? std::clamp((wanted - first) / (sums[i] - first), 0.0f, 1.0f) : 0.0f;
    const float at = lengths[i] - (1 - share) * stepLengths[i];
    size_t piece = 0;
    while (piece + 1 < part.count && part.pieces[piece + 1].begin <= at) {
      ++piece;
    }
    result_.t = part.pieces[piece].t + (at - part.pieces[piece].begin) * part.pieces[piece].tByLength;
    result_.isDeep = true;
    return float(i) + share;
  }

  /// Adds the steps before the depth that was found, and of its step the part before it.
  HWY_ATTR void addBeforeDepth(FloatVec red, FloatVec green, FloatVec blue, FloatVec kept, float depth) {
    const Floats d;
    HWY_ALIGN float channels[3][kLanes];
    HWY_ALIGN float seen[kLanes];
    hn::Store(red, d, channels[0]);
    hn::Store(green, d, channels[1]);
    hn::Store(blue, d, channels[2]);
    hn::Store(kept, d, seen);
    const auto whole = std::min(static_cast<size_t>(depth), kLanes - 1);
    float left = result_.transmittance - (1 - setup_.depthOpacity);  // to be kept before the threshold is reached
    for (size_t i = 0; i <= whole; ++i) {
      const float share = i < whole ? 1 : seen[i] > 0 ? std::clamp(left / seen[i], 0.0f, 1.0f) : 0;
      for (size_t c = 0; c < 3; ++c) {
        result_.color[c] += channels[c][i] * share;
      }
      left -= seen[i];
    }
    result_.transmittance = 1 - setup_.depthOpacity;
    isDone_ = true;
  }

  static constexpr float kUnseen = 1e-5f;  ///< of a step: less light than this needs no shade

  const MarchSetup& setup_;
  const Field& field_;
  bool stopsAtDepth_;
  MarchResult result_;
  bool isDone_ = false;
  bool lastIsSeen_ = false;
};

template <class Field>
HWY_ATTR MarchResult marchWith(const MarchSetup& setup, std::span<const RayPiece> pieces, bool stopsAtDepth) {
  const Field field(setup);
  March<Field> march(setup, field, stopsAtDepth);
  std::array<MarchPiece, RayPath::kMaxPoints> marched;
  size_t begin = 0;
  while (begin < pieces.size() && !march.isDone()) {
    double length = 0;
    double rate = 0;
    size_t end = begin;
    do {
      const RayPiece& p = pieces[end];
      const glm::vec3 between = setup.toLight - glm::vec3(p.direction);
      const float betweenLength = glm::length(between);
      marched[end - begin] = {glm::vec3(p.from),
                              glm::vec3(p.way),
                              betweenLength > 0 ? between / betweenLength : glm::vec3(0),
                              static_cast<float>(length),
                              static_cast<float>(p.t),
                              static_cast<float>(p.tByLength)};
      length += p.length;
      rate = std::max({rate, std::abs(p.way.x), std::abs(p.way.y), std::abs(p.way.z)});
      ++end;
    } while (end < pieces.size() && pieces[end].continues);
    march.run({marched.data(), end - begin, static_cast<float>(length), static_cast<float>(rate)});
    begin = end;
  }
  return march.result();
}

HWY_ATTR MarchResult marchRay(const MarchSetup& setup, std::span<const RayPiece> pieces, bool stopsAtDepth) {
  if (pieces.empty()) {
    return {};
  }
  if (fitsWords(*setup.volume)) {
    switch (setup.volume->type()) {
      case VoxelType::kUint8:
        return marchWith<NativeField<uint8_t>>(setup, pieces, stopsAtDepth);
      case VoxelType::kInt8:
        return marchWith<NativeField<int8_t>>(setup, pieces, stopsAtDepth);
      case VoxelType::kUint16:
        return marchWith<NativeField<uint16_t>>(setup, pieces, stopsAtDepth);
      case VoxelType::kInt16:
        return marchWith<NativeField<int16_t>>(setup, pieces, stopsAtDepth);
      case VoxelType::kFloat32:
        return marchWith<NativeField<float>>(setup, pieces, stopsAtDepth);
      case VoxelType::kUint32:
      case VoxelType::kInt32:
      case VoxelType::kFloat64:
        break;
    }
  }
  return marchWith<AnyField>(setup, pieces, stopsAtDepth);
}

const char* marchTarget() {
  return hwy::TargetName(HWY_TARGET);
}

}  // namespace ocelli::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ocelli {

HWY_EXPORT(marchRay);
HWY_EXPORT(marchTarget);

MarchResult march(const MarchSetup& setup, std::span<const RayPiece> pieces, bool stopsAtDepth) {
  return HWY_DYNAMIC_DISPATCH(marchRay)(setup, pieces, stopsAtDepth);
}

std::string marchInstructionSet() {
  return HWY_DYNAMIC_DISPATCH(marchTarget)();
}

}  // namespace ocelli
#endif  // HWY_ONCE
