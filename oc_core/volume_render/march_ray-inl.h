// One ray on its way through a volume, in the instruction set that the file which includes this is compiled for
// (hwy/foreach_target.h). For march_kernel.cpp.
#if defined(OCELLI_MARCH_RAY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef OCELLI_MARCH_RAY_INL_H
#undef OCELLI_MARCH_RAY_INL_H
#else
#define OCELLI_MARCH_RAY_INL_H
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "oc_core/volume/volume_bricks.h"
#include "oc_core/volume_render/march_steps-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ocelli::HWY_NAMESPACE {

/// What a step needs of the sample before it.
struct Before {
  Quad integral;
  Quad rest;
  Quad at;
  float entry;
};

/// A ray on its way, a group of samples after the other. The work on a group comes in phases, so that those of several
/// rays can take turns: what one phase writes number by number, the next reads as vectors, and that waits where it
/// follows at once.
template <class Field>
class March {
 public:
  void attach(const MarchSetup& setup, const Field& field, bool stopsAtDepth) {
    setup_ = &setup;
    field_ = &field;
    stopsAtDepth_ = stopsAtDepth;
  }
  /// The ray that is to be followed.
  HWY_ATTR void begin(std::span<const VolumeRayPiece> pieces);
  /// Finds the next group, skipping what is empty. False where the ray has ended.
  HWY_ATTR bool prepare();
  // The phases of a group, in order.
  HWY_ATTR void read() { field_->read(index_, count_, values_); }
  HWY_ATTR void findEntries();
  HWY_ATTR void weighChanges();
  HWY_ATTR void lookUp();
  HWY_ATTR void sum();
  HWY_ATTR void pass();
  HWY_ATTR void add();

  const MarchResult& result() const { return result_; }

 private:
  static constexpr float kUnlit = 2e-4f;  ///< of all light: as much of a part may go without shade

  HWY_ATTR bool nextPart();
  float lengthAt(int sample) const { return std::min(float(sample) * setup_->step, part_.length); }
  HWY_ATTR HWY_INLINE FloatVec lengthsFrom(int sample) const {
    const Floats d;
    const FloatVec number = hn::Add(hn::Set(d, float(sample)), hn::Iota(d, 0.0f));
    // The last sample is at the end, however long the rest is.
    const FloatVec length = hn::Min(hn::Mul(number, hn::Set(d, setup_->step)), hn::Set(d, part_.length));
    return hn::IfThenElse(hn::Ge(number, hn::Set(d, float(last_))), hn::Set(d, part_.length), length);
  }
  /// The places of the samples from next_ on.
  HWY_ATTR HWY_INLINE void placeGroup() {
    while (piece_ > 0 && part_.pieces[piece_].begin > lengthAt(next_)) {
      --piece_;
    }
    while (piece_ + 1 < part_.count && part_.pieces[piece_ + 1].begin <= lengthAt(next_)) {
      ++piece_;
    }
    const int lastOfGroup = next_ + int(kLanes) - 1;
    end_ = lastOfGroup >= last_ ? part_.length : lengthAt(lastOfGroup);
    count_ = std::min(kLanes, size_t(last_ + 1 - next_));
    length_ = lengthsFrom(next_);
    index_ = placesAt<false>(part_, piece_, length_, end_).index;
  }

  struct Bricks {
    uint32_t seen;  ///< bit i: that of place i shows something
    int distance;   ///< of that of the last place
  };
  HWY_ATTR HWY_INLINE Bricks lookAtBricks(const Point& index, size_t count) const {
    const Floats d;
    const Ints di;
    const FloatVec bricksByVoxel = hn::Set(d, 1.0f / float(VolumeBricks::kEdge));
    const auto along = [&](FloatVec x, int bricks) HWY_ATTR {
      return hn::Min(hn::Max(hn::ConvertTo(di, hn::Mul(x, bricksByVoxel)), hn::Zero(di)), hn::Set(di, bricks - 1));
    };
    const IntVec i = along(index.x, setup_->bricks.x);
    const IntVec j = along(index.y, setup_->bricks.y);
    const IntVec k = along(index.z, setup_->bricks.z);
    const IntVec brick =
        hn::Add(hn::Mul(hn::Add(hn::Mul(k, hn::Set(di, setup_->bricks.y)), j), hn::Set(di, setup_->bricks.x)), i);
    const IntVec distances = hn::And(gatherWords(setup_->distances, brick), hn::Set(di, 0xff));
    HWY_ALIGN int32_t all[kLanes];
    hn::Store(distances, di, all);
    uint8_t bits[8] = {};
    hn::StoreMaskBits(di, hn::Eq(distances, hn::Zero(di)), bits);
    return {bits[0] & ((1u << count) - 1), all[count - 1]};
  }

  /// At these lengths along the ray, where `isWanted`.
  HWY_ATTR HWY_INLINE Light lightOfSteps(FloatVec length, hn::Mask<Floats> isWanted) const {
    const Floats d;
    const size_t count = hn::CountTrue(d, isWanted);
    if (count == 0) {
      return {hn::Set(d, 1.0f), hn::Zero(d)};
    }
    size_t piece = piece_;
    while (piece > 0 && part_.pieces[piece].begin > hn::GetLane(length)) {
      --piece;
    }
    Places places = placesAt<true>(part_, piece, length, end_);
    if (count == kLanes) {
      return lightAt(*setup_, *field_, places, count);
    }
    const auto keep = [&](FloatVec& x) HWY_ATTR { x = hn::Compress(x, isWanted); };
    keep(places.index.x);
    keep(places.index.y);
    keep(places.index.z);
    if (setup_->light.specular > 0) {
      keep(places.direction.x);
      keep(places.direction.y);
      keep(places.direction.z);
    }
    const Light light = lightAt(*setup_, *field_, places, count);
    HWY_ALIGN float factors[kLanes];
    HWY_ALIGN float added[kLanes];
    HWY_ALIGN float spreadFactors[kLanes];
    HWY_ALIGN float spreadAdded[kLanes];
    hn::Store(light.factor, d, factors);
    hn::Store(light.added, d, added);
    hn::Store(hn::Set(d, 1.0f), d, spreadFactors);
    hn::Store(hn::Zero(d), d, spreadAdded);
    uint8_t bits[8] = {};
    hn::StoreMaskBits(d, isWanted, bits);
    uint32_t left = bits[0];
    for (size_t i = 0; i < count; ++i, left &= left - 1) {
      const auto lane = static_cast<size_t>(std::countr_zero(left));
      spreadFactors[lane] = factors[i];
      spreadAdded[lane] = added[i];
    }
    return {hn::Load(d, spreadFactors), hn::Load(d, spreadAdded)};
  }

  /// Where the opacity reaches its threshold within a group: sets t; returns the step, and how much of it, as a sum.
  HWY_ATTR float findDepth() {
    const Floats d;
    HWY_ALIGN float lengths[kLanes];
    HWY_ALIGN float stepLengths[kLanes];
    hn::Store(length_, d, lengths);
    hn::Store(step_, d, stepLengths);
    const float wanted = std::max(0.0f, std::log(result_.transmittance / (1 - setup_->depthOpacity)));
    size_t i = 0;
    while (i + 1 < kLanes && sums_[i] < wanted) {
      ++i;
    }
    const float first = i > 0 ? sums_[i - 1] : 0;
    const float share = sums_[i] > first ? std::clamp((wanted - first) / (sums_[i] - first), 0.0f, 1.0f) : 0.0f;
    const float at = lengths[i] - (1 - share) * stepLengths[i];
    size_t piece = 0;
    while (piece + 1 < part_.count && part_.pieces[piece + 1].begin <= at) {
      ++piece;
    }
    result_.t = part_.pieces[piece].t + (at - part_.pieces[piece].begin) * part_.pieces[piece].tByLength;
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
    float left = result_.transmittance - (1 - setup_->depthOpacity);  // to be kept before the threshold is reached
    for (size_t i = 0; i <= whole; ++i) {
      const float share = i < whole ? 1 : seen[i] > 0 ? std::clamp(left / seen[i], 0.0f, 1.0f) : 0;
      for (size_t c = 0; c < 3; ++c) {
        result_.color[c] += channels[c][i] * share;
      }
      left -= seen[i];
    }
    result_.transmittance = 1 - setup_->depthOpacity;
    isDone_ = true;
  }

  const MarchSetup* setup_;
  const Field* field_;
  bool stopsAtDepth_;
  MarchResult result_;
  bool isDone_;

  std::array<MarchPiece, RayPath::kMaxPoints> pieces_;
  size_t pieceCount_;
  size_t nextPiece_;  ///< the first of the next part

  MarchPart part_;
  size_t piece_;   ///< of the first sample of the group
  int next_;       ///< sample of the part
  int last_;       ///< sample of the part
  bool isBefore_;  ///< whether before_ is that of the sample before the group
  bool wasSeen_;   ///< whether that sample's brick shows something
  Before before_;

  // Of the group.
  size_t count_;  ///< samples; the other lanes mean nothing
  float end_;     ///< length of the last lane
  FloatVec length_;
  FloatVec step_;  ///< lengths of the steps that end at each sample
  Point index_;
  FloatVec entry_;
  HWY_ALIGN float values_[kLanes];
  HWY_ALIGN float entries_[2 * kLanes];  ///< that of the sample before comes first
  HWY_ALIGN int32_t which_[kLanes];
  HWY_ALIGN float shares_[kLanes];
  HWY_ALIGN float byChange_[kLanes];
  HWY_ALIGN float byMean_[kLanes];
  HWY_ALIGN float depths_[4 * kLanes];    ///< by step: optical depth, and red, green and blue times it
  HWY_ALIGN float ends_[4 * kLanes + 4];  ///< at the sample before and at each: OpticalTable::Entry::at
  FloatVec depth_;
  FloatVec red_;
  FloatVec green_;
  FloatVec blue_;
  bool isSeen_;
  HWY_ALIGN float sums_[kLanes];        ///< of optical depths
  HWY_ALIGN float passes_[2 * kLanes];  ///< how much light passes all steps up to this one
};

template <class Field>
HWY_ATTR void March<Field>::begin(std::span<const VolumeRayPiece> pieces) {
  result_ = {};
  isDone_ = false;
  pieceCount_ = pieces.size();
  nextPiece_ = 0;
  double length = 0;
  for (size_t i = 0; i < pieces.size(); ++i) {
    const VolumeRayPiece& p = pieces[i];
    length = p.continues ? length : 0;
    pieces_[i] = {glm::vec3(p.from),
                  glm::vec3(p.way),
                  glm::vec3(p.direction),
                  static_cast<float>(length),
                  static_cast<float>(length + p.length),
                  static_cast<float>(p.t),
                  static_cast<float>(p.tByLength),
                  p.continues};
    length += p.length;
  }
  isDone_ = !nextPart();
}

/// The pieces from nextPiece_ on that continue each other. False where there are none.
template <class Field>
HWY_ATTR bool March<Field>::nextPart() {
  if (nextPiece_ >= pieceCount_) {
    return false;
  }
  part_ = {&pieces_[nextPiece_], 0, 0, 0};
  do {
    const MarchPiece& piece = pieces_[nextPiece_++];
    ++part_.count;
    part_.length = piece.end;
    part_.voxelsByLength =
        std::max({part_.voxelsByLength, std::abs(piece.way.x), std::abs(piece.way.y), std::abs(piece.way.z)});
  } while (nextPiece_ < pieceCount_ && pieces_[nextPiece_].continues);
  piece_ = 0;
  next_ = 0;
  last_ = static_cast<int>(std::max(1.0f, std::ceil(part_.length / setup_->step - 1e-4f)));
  isBefore_ = false;
  wasSeen_ = false;
  before_ = {setQuad(0), setQuad(0), setQuad(0), 0};
  return true;
}

template <class Field>
HWY_ATTR bool March<Field>::prepare() {
  while (!isDone_) {
    if (next_ > last_) {
      isDone_ = !nextPart();
      continue;
    }
    placeGroup();
    if (setup_->distances == nullptr) {
      break;
    }
    Bricks bricks = lookAtBricks(index_, count_);
    if (bricks.seen == 0 && !wasSeen_) {
      const float way = float((bricks.distance - 1) * VolumeBricks::kEdge);
      next_ += int(count_) + int(way / (part_.voxelsByLength * setup_->step) * 0.9999f);
      isBefore_ = false;
      continue;
    }
    const int first = std::max(next_ + std::countr_zero(bricks.seen) - 1, 0);
    if (!isBefore_ && first != next_) {
      // Begin with the sample before the first one that is seen.
      next_ = first;
      placeGroup();
      bricks = lookAtBricks(index_, count_);
    }
    // And end with the sample behind the last one.
    const auto behind = static_cast<size_t>(std::bit_width(bricks.seen)) + 1;
    wasSeen_ = behind > count_;
    count_ = std::min(count_, behind);
    break;
  }
  if (isDone_) {
    return false;
  }
  // None ends at the first sample of all, and what is behind the last one has none.
  const Floats d;
  const FloatVec lane = hn::Iota(d, 0.0f);
  const auto isStep =
      hn::And(hn::Lt(lane, hn::Set(d, float(count_))), hn::Ge(lane, hn::Set(d, isBefore_ ? 0.0f : 1.0f)));
  step_ = hn::IfThenElseZero(isStep, hn::Sub(length_, lengthsFrom(next_ - 1)));
  result_.samples += uint32_t(count_);
  next_ += int(count_);
  return true;
}

template <class Field>
HWY_ATTR void March<Field>::findEntries() {
  const Floats d;
  const Ints di;
  const FloatVec number = hn::Sub(hn::Load(d, values_), hn::Set(d, static_cast<float>(field_->first())));
  entry_ = hn::Mul(number, hn::Set(d, setup_->entriesByNumber));
  // Beyond the table it is constant: the first and the last two entries are the same.
  const FloatVec bounded = hn::Min(hn::Max(entry_, hn::Zero(d)), hn::Set(d, float(OpticalTable::kEntries - 2)));
  const IntVec index = hn::ConvertTo(di, bounded);
  hn::Store(index, di, which_);
  hn::Store(hn::Sub(entry_, hn::ConvertTo(d, index)), d, shares_);
  entries_[0] = isBefore_ ? before_.entry : hn::GetLane(entry_);
  hn::StoreU(entry_, d, entries_ + 1);
}

template <class Field>
HWY_ATTR void March<Field>::weighChanges() {
  const Floats d;
  const FloatVec change = hn::Sub(entry_, hn::Load(d, entries_));
  // Where the field hardly changes, by the mean of both ends.
  const auto isSmall = hn::Lt(hn::Abs(change), hn::Set(d, 1.0f));
  const FloatVec byChange = hn::Div(step_, hn::IfThenElse(isSmall, hn::Set(d, 1.0f), change));
  hn::Store(hn::IfThenZeroElse(isSmall, byChange), d, byChange_);
  hn::Store(hn::IfThenElseZero(isSmall, hn::Mul(step_, hn::Set(d, 0.5f))), d, byMean_);
}

template <class Field>
HWY_ATTR void March<Field>::lookUp() {
  Before before = before_;
  storeQuad(before.at, ends_);
  for (size_t i = 0; i < count_; ++i) {
    const OpticalTable::Entry& e = setup_->entries[which_[i]];
    const Quad share = setQuad(shares_[i]);
    const Quad integral = loadQuad(e.integral.data());
    const Quad half = loadQuad(e.halfChange.data());
    const Quad middle = multiplyAddQuads(share, half, loadQuad(e.at.data()));
    const Quad at = multiplyAddQuads(share, half, middle);
    const Quad rest = multiplyAddQuads(share, middle, loadQuad(e.rest.data()));
    const Quad difference = addQuads(subtractQuads(integral, before.integral), subtractQuads(rest, before.rest));
    const Quad sum = multiplyQuads(addQuads(at, before.at), setQuad(byMean_[i]));
    storeQuad(multiplyAddQuads(difference, setQuad(byChange_[i]), sum), depths_ + 4 * i);
    storeQuad(at, ends_ + 4 * (i + 1));
    before.integral = integral;
    before.rest = rest;
    before.at = at;
  }
  for (size_t i = count_; i < kLanes; ++i) {
    storeQuad(setQuad(0), depths_ + 4 * i);
    storeQuad(setQuad(0), ends_ + 4 * (i + 1));
  }
  before.entry = entries_[count_];
  before_ = before;
  isBefore_ = true;
}

template <class Field>
HWY_ATTR void March<Field>::sum() {
  const Floats d;
  hn::LoadInterleaved4(d, depths_, depth_, red_, green_, blue_);
  depth_ = hn::Max(depth_, hn::Zero(d));
  isSeen_ = !hn::AllFalse(d, hn::Gt(depth_, hn::Zero(d)));
  if (!isSeen_) {
    return;
  }
  float sum = 0;
  for (size_t i = 0; i < kLanes; ++i) {
    sum += std::max(depths_[4 * i], 0.0f);
    sums_[i] = sum;
  }
}

template <class Field>
HWY_ATTR void March<Field>::pass() {
  if (isSeen_) {
    const Floats d;
    passes_[0] = 1;
    hn::StoreU(hn::Exp(d, hn::Neg(hn::Load(d, sums_))), d, passes_ + 1);
  }
}

/// Composites the steps of the group behind all before.
template <class Field>
HWY_ATTR void March<Field>::add() {
  if (!isSeen_) {
    return;
  }
  const Floats d;
  const FloatVec one = hn::Set(d, 1.0f);
  const FloatVec before = hn::Load(d, passes_);
  const FloatVec after = hn::LoadU(d, passes_ + 1);
  const FloatVec transmittance = hn::Set(d, result_.transmittance);
  const FloatVec kept = hn::Mul(transmittance, hn::Sub(before, after));
  const FloatVec perDepth = hn::Div(one, hn::IfThenElse(hn::Gt(depth_, hn::Zero(d)), depth_, one));
  Ends first;
  Ends last;
  hn::LoadInterleaved4(d, ends_, first.extinction, first.red, first.green, first.blue);
  hn::LoadInterleaved4(d, ends_ + 4, last.extinction, last.red, last.green, last.blue);
  // Of a step that is seen by a peak within it, rather than by what its ends have, these say little. An end that shows
  // nothing, as at the surface of what is dense, takes nothing from what the other says.
  const auto isOneSided = hn::Or(hn::Eq(first.extinction, hn::Zero(d)), hn::Eq(last.extinction, hn::Zero(d)));
  const FloatVec bothEnds = hn::Mul(hn::Add(first.extinction, last.extinction), step_);
  const FloatVec byEnds = hn::IfThenElse(isOneSided, bothEnds, hn::Mul(bothEnds, hn::Set(d, 0.5f)));
  const FloatVec likeEnds = hn::Min(hn::Mul(byEnds, perDepth), one);
  const ColorOrder order(first.extinction, last.extinction, depth_, perDepth,
                         {hn::Mul(transmittance, before), hn::Mul(transmittance, after)}, likeEnds);
  const auto seen = [&](FloatVec byDepth, FloatVec atFirst, FloatVec atLast) HWY_ATTR {
    const FloatVec mean = hn::Mul(byDepth, perDepth);
    return hn::MulAdd(mean, kept, order.light(mean, atFirst, atLast));
  };
  red_ = seen(red_, first.red, last.red);
  green_ = seen(green_, first.green, last.green);
  blue_ = seen(blue_, first.blue, last.blue);
  if (setup_->isShaded) {
    // In the middle of each step.
    const FloatVec place = hn::NegMulAdd(step_, hn::Set(d, 0.5f), length_);
    const Light light = lightOfSteps(place, hn::Gt(kept, hn::Set(d, kUnlit / float(last_ + 1))));
    const FloatVec white = hn::Mul(kept, light.added);
    red_ = hn::MulAdd(red_, light.factor, white);
    green_ = hn::MulAdd(green_, light.factor, white);
    blue_ = hn::MulAdd(blue_, light.factor, white);
  }
  const float left = result_.transmittance * passes_[kLanes];
  if (!result_.isDeep && 1 - left >= setup_->depthOpacity) {
    const float depth = findDepth();
    if (stopsAtDepth_) {
      addBeforeDepth(red_, green_, blue_, kept, depth);
      return;
    }
  }
  result_.color[0] += hn::GetLane(hn::SumOfLanes(d, red_));
  result_.color[1] += hn::GetLane(hn::SumOfLanes(d, green_));
  result_.color[2] += hn::GetLane(hn::SumOfLanes(d, blue_));
  result_.transmittance = left;
  isDone_ = left <= setup_->endTransmittance;
}

}  // namespace ocelli::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
