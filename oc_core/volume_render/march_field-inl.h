// The field of a volume at many places at once, in the instruction set that the file which includes this is compiled
// for (hwy/foreach_target.h).
//
// Nothing is read beyond the last voxel.
#if defined(OCELLI_MARCH_FIELD_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef OCELLI_MARCH_FIELD_INL_H
#undef OCELLI_MARCH_FIELD_INL_H
#else
#define OCELLI_MARCH_FIELD_INL_H
#endif

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include "oc_core/volume_render/march_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace ocelli::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Eight at most: in wider groups more of a ray is looked at beyond where it ends.
using Floats = hn::CappedTag<float, 8>;
using Ints = hn::RebindToSigned<Floats>;
using FloatVec = hn::Vec<Floats>;
using IntVec = hn::Vec<Ints>;

// Four numbers, as an entry of OpticalTable has them.
#if HWY_TARGET == HWY_SCALAR
struct Quad {
  float v[4];
};
template <class Each>
HWY_INLINE Quad eachOfQuad(const Each& each) {
  return {{each(0), each(1), each(2), each(3)}};
}
HWY_INLINE Quad setQuad(float x) {
  return {{x, x, x, x}};
}
HWY_INLINE Quad loadQuad(const float* from) {
  return {{from[0], from[1], from[2], from[3]}};
}
HWY_INLINE void storeQuad(const Quad& q, float* to) {
  std::memcpy(to, q.v, sizeof(q.v));
}
HWY_INLINE Quad addQuads(const Quad& a, const Quad& b) {
  return eachOfQuad([&](int i) { return a.v[i] + b.v[i]; });
}
HWY_INLINE Quad subtractQuads(const Quad& a, const Quad& b) {
  return eachOfQuad([&](int i) { return a.v[i] - b.v[i]; });
}
HWY_INLINE Quad multiplyQuads(const Quad& a, const Quad& b) {
  return eachOfQuad([&](int i) { return a.v[i] * b.v[i]; });
}
HWY_INLINE Quad multiplyAddQuads(const Quad& a, const Quad& b, const Quad& c) {
  return eachOfQuad([&](int i) { return a.v[i] * b.v[i] + c.v[i]; });
}
#else
using Quads = hn::Full128<float>;
using Quad = hn::Vec<Quads>;
HWY_ATTR HWY_INLINE Quad setQuad(float x) {
  return hn::Set(Quads(), x);
}
HWY_ATTR HWY_INLINE Quad loadQuad(const float* from) {
  return hn::Load(Quads(), from);
}
HWY_ATTR HWY_INLINE void storeQuad(Quad q, float* to) {
  hn::Store(q, Quads(), to);
}
HWY_ATTR HWY_INLINE Quad addQuads(Quad a, Quad b) {
  return hn::Add(a, b);
}
HWY_ATTR HWY_INLINE Quad subtractQuads(Quad a, Quad b) {
  return hn::Sub(a, b);
}
HWY_ATTR HWY_INLINE Quad multiplyQuads(Quad a, Quad b) {
  return hn::Mul(a, b);
}
HWY_ATTR HWY_INLINE Quad multiplyAddQuads(Quad a, Quad b, Quad c) {
  return hn::MulAdd(a, b, c);
}
#endif

constexpr size_t kLanes = HWY_LANES(float) < 8 ? HWY_LANES(float) : 8;

struct Point {
  FloatVec x;
  FloatVec y;
  FloatVec z;
};

/// The words at these offsets, in bytes, which need not be multiples of 4.
HWY_ATTR HWY_INLINE IntVec gatherWords(const void* first, IntVec offsets) {
  const Ints di;
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
  return hn::GatherOffset(di, static_cast<const int32_t*>(first), offsets);
#else
  HWY_ALIGN int32_t at[kLanes];
  HWY_ALIGN int32_t words[kLanes];
  hn::Store(offsets, di, at);
  for (size_t i = 0; i < kLanes; ++i) {
    std::memcpy(&words[i], static_cast<const char*>(first) + at[i], sizeof(int32_t));
  }
  return hn::Load(di, words);
#endif
}

/// Whether NativeField can read it: numbers of voxels are words, and all have neighbours along i.
inline bool fitsWords(const ScalarVolume& volume) {
  return std::endian::native == std::endian::little && volume.grid().size.x > 1 &&
         volume.grid().voxelCount() <= size_t(std::numeric_limits<int32_t>::max());
}

/// The cell of eight voxels around a point, and where in the cell it is. A volume may be one voxel thick.
class CellFinder {
 public:
  explicit CellFinder(const ScalarVolume& volume)
      : size_(volume.grid().size), cells_(glm::max(volume.grid().size - 2, glm::ivec3(0))) {}

  HWY_ATTR HWY_INLINE Point centerNear(const Point& p) const {
    return {inside(p.x, size_.x), inside(p.y, size_.y), inside(p.z, size_.z)};
  }

  struct Cells {
    IntVec i, j, k;
    Point share;
  };
  HWY_ATTR HWY_INLINE Cells find(const Point& index) const {
    const Floats d;
    const Ints di;
    const Point p = centerNear(index);
    const IntVec i = hn::Min(hn::ConvertTo(di, p.x), hn::Set(di, cells_.x));
    const IntVec j = hn::Min(hn::ConvertTo(di, p.y), hn::Set(di, cells_.y));
    const IntVec k = hn::Min(hn::ConvertTo(di, p.z), hn::Set(di, cells_.z));
    return {i,
            j,
            k,
            {hn::Sub(p.x, hn::ConvertTo(d, i)), hn::Sub(p.y, hn::ConvertTo(d, j)), hn::Sub(p.z, hn::ConvertTo(d, k))}};
  }

  const glm::ivec3& size() const { return size_; }

 private:
  HWY_ATTR static HWY_INLINE FloatVec inside(FloatVec x, int count) {
    const Floats d;
    return hn::Max(hn::Zero(d), hn::Min(x, hn::Set(d, float(count - 1))));
  }

  glm::ivec3 size_;
  glm::ivec3 cells_;
};

/// Differences of a field between a voxel after and a voxel before places, along i, j and k: kLanes of each.
template <class Field>
HWY_ATTR HWY_INLINE void readSlopesByField(const Field& field, const Point& index, size_t count, float* slopes) {
  const Floats d;
  const FloatVec one = hn::Set(d, 1.0f);
  const Point p = field.centerNear(index);
  HWY_ALIGN float after[kLanes];
  HWY_ALIGN float before[kLanes];
  const auto difference = [&](const Point& a, const Point& b, float* slope) HWY_ATTR {
    field.read(a, count, after);
    field.read(b, count, before);
    hn::Store(hn::Sub(hn::Load(d, after), hn::Load(d, before)), d, slope);
  };
  difference({hn::Add(p.x, one), p.y, p.z}, {hn::Sub(p.x, one), p.y, p.z}, slopes);
  difference({p.x, hn::Add(p.y, one), p.z}, {p.x, hn::Sub(p.y, one), p.z}, slopes + kLanes);
  difference({p.x, p.y, hn::Add(p.z, one)}, {p.x, p.y, hn::Sub(p.z, one)}, slopes + 2 * kLanes);
}

/// Any type and size: voxel by voxel.
class AnyField {
 public:
  explicit AnyField(const MarchSetup& setup) : volume_(*setup.volume), first_(setup.firstNumber), finder_(volume_) {}

  HWY_ATTR HWY_INLINE Point centerNear(const Point& p) const { return finder_.centerNear(p); }

  /// What findEntries() has to take from what read() gives: of numbers that floats hold badly, that is done here.
  double first() const { return 0; }
  /// The numbers in the voxels, interpolated, at the first `count` places; 0 at the others.
  HWY_ATTR HWY_NOINLINE void read(const Point& index, size_t count, float* values) const {
    const Floats d;
    const Ints di;
    const auto cells = finder_.find(index);
    HWY_ALIGN int32_t i[kLanes];
    HWY_ALIGN int32_t j[kLanes];
    HWY_ALIGN int32_t k[kLanes];
    HWY_ALIGN float u[kLanes];
    HWY_ALIGN float v[kLanes];
    HWY_ALIGN float w[kLanes];
    hn::Store(hn::Zero(d), d, values);
    hn::Store(cells.i, di, i);
    hn::Store(cells.j, di, j);
    hn::Store(cells.k, di, k);
    hn::Store(cells.share.x, d, u);
    hn::Store(cells.share.y, d, v);
    hn::Store(cells.share.z, d, w);
    const auto size = [&](int axis) { return static_cast<size_t>(finder_.size()[axis]); };
    const size_t nextI = size(0) > 1 ? 1 : 0;
    const size_t nextJ = size(1) > 1 ? size(0) : 0;
    const size_t nextK = size(2) > 1 ? size(0) * size(1) : 0;
    visitVoxels(volume_, [&](const auto* voxels) {
      for (size_t lane = 0; lane < count; ++lane) {
        const auto* cell = voxels + (static_cast<size_t>(k[lane]) * size(1) + static_cast<size_t>(j[lane])) * size(0) +
                           static_cast<size_t>(i[lane]);
        const auto mix = [](double a, double b, float share) { return a + (b - a) * static_cast<double>(share); };
        const auto row = [&](const auto* p) {
          return mix(static_cast<double>(*p), static_cast<double>(p[nextI]), u[lane]);
        };
        const auto plane = [&](const auto* p) { return mix(row(p), row(p + nextJ), v[lane]); };
        values[lane] = static_cast<float>(mix(plane(cell), plane(cell + nextK), w[lane]) - first_);
      }
    });
  }
  HWY_ATTR void readSlopes(const Point& index, size_t count, float* slopes) const {
    readSlopesByField(*this, index, count, slopes);
  }

 private:
  const ScalarVolume& volume_;
  double first_;
  CellFinder finder_;
};

#if HWY_TARGET != HWY_SCALAR
/// Of a volume that fitsWords(): the eight voxels of a cell are read as four pairs, which takes less time than to
/// gather them for all places at once.
template <class Voxel>
class NativeField {
 public:
  explicit NativeField(const MarchSetup& setup)
      : voxels_(reinterpret_cast<const Voxel*>(setup.volume->voxels().data())),
        first_(setup.firstNumber),
        finder_(*setup.volume),
        nextJ_(finder_.size().y > 1 ? finder_.size().x : 0),
        nextK_(finder_.size().z > 1 ? finder_.size().x * finder_.size().y : 0) {}

  HWY_ATTR HWY_INLINE Point centerNear(const Point& p) const { return finder_.centerNear(p); }

  double first() const { return first_; }
  /// As AnyField.
  HWY_ATTR HWY_INLINE void read(const Point& index, size_t count, float* values) const {
    const Floats d;
    const Ints di;
    const auto c = finder_.find(index);
    const IntVec cell =
        hn::Add(hn::Mul(hn::Add(hn::Mul(c.k, hn::Set(di, finder_.size().y)), c.j), hn::Set(di, finder_.size().x)), c.i);
    HWY_ALIGN int32_t cells[kLanes];
    HWY_ALIGN float u[kLanes];
    HWY_ALIGN float v[kLanes];
    HWY_ALIGN float w[kLanes];
    hn::Store(cell, di, cells);
    hn::Store(c.share.x, d, u);
    hn::Store(c.share.y, d, v);
    hn::Store(c.share.z, d, w);
    hn::Store(hn::Zero(d), d, values);
    const Voxel* near = voxels_;
    const Voxel* nearNext = near + nextJ_;
    const Voxel* far = near + nextK_;
    const Voxel* farNext = far + nextJ_;
    for (size_t lane = 0; lane < count; ++lane) {
      const auto at = static_cast<size_t>(cells[lane]);
      const Quad first = twoPairs(near + at, nearNext + at);
      const Quad second = twoPairs(far + at, farNext + at);
      // Along k, then j, then i.
      const Quad plane = hn::MulAdd(hn::Sub(second, first), setQuad(w[lane]), first);
      const hn::Half<Quads> pair;
      const auto row = hn::LowerHalf(pair, plane);
      const auto rows = hn::MulAdd(hn::Sub(hn::UpperHalf(pair, plane), row), hn::Set(pair, v[lane]), row);
      const hn::Half<hn::Half<Quads>> one;
      const auto left = hn::LowerHalf(one, rows);
      const auto right = hn::UpperHalf(one, rows);
      values[lane] = hn::GetLane(hn::MulAdd(hn::Sub(right, left), hn::Set(one, u[lane]), left));
    }
  }

  /// As readSlopesByField(), but for rounding: what the six points have in common is read once.
  HWY_ATTR void readSlopes(const Point& index, size_t count, float* slopes) const {
    const Floats d;
    const Ints di;
    const auto c = finder_.find(index);
    HWY_ALIGN int32_t i[kLanes];
    HWY_ALIGN int32_t j[kLanes];
    HWY_ALIGN int32_t k[kLanes];
    HWY_ALIGN float u[kLanes];
    HWY_ALIGN float v[kLanes];
    HWY_ALIGN float w[kLanes];
    hn::Store(c.i, di, i);
    hn::Store(c.j, di, j);
    hn::Store(c.k, di, k);
    hn::Store(c.share.x, d, u);
    hn::Store(c.share.y, d, v);
    hn::Store(c.share.z, d, w);
    for (int axis = 0; axis < 3; ++axis) {
      hn::Store(hn::Zero(d), d, slopes + static_cast<size_t>(axis) * kLanes);
    }
    const glm::ivec3& size = finder_.size();
    if (size.y < 2 || size.z < 2) {
      readSlopesByField(*this, index, count, slopes);
      return;
    }
    const auto mix = [](Quad a, Quad b, Quad share) HWY_ATTR { return hn::MulAdd(hn::Sub(b, a), share, a); };
    for (size_t lane = 0; lane < count; ++lane) {
      const Quad alongJ = setQuad(v[lane]);
      const Quad alongK = setQuad(w[lane]);
      // The row of the cell, and the ways from it to rows j - 1 and j + 2 and to planes k - 1 and k + 2; those at the
      // ends stand for what is beyond.
      const Voxel* row =
          voxels_ + (static_cast<size_t>(k[lane]) * static_cast<size_t>(size.y) + static_cast<size_t>(j[lane])) *
                        static_cast<size_t>(size.x);
      const std::ptrdiff_t nextJ = nextJ_;
      const std::ptrdiff_t nextK = nextK_;
      const std::ptrdiff_t lowJ = j[lane] > 0 ? -nextJ : 0;
      const std::ptrdiff_t highJ = j[lane] + 2 < size.y ? 2 * nextJ : nextJ;
      const std::ptrdiff_t lowK = k[lane] > 0 ? -nextK : 0;
      const std::ptrdiff_t highK = k[lane] + 2 < size.z ? 2 * nextK : nextK;
      // The rows of the cell, from the voxel before it to that behind it.
      const Quad rows[2][2] = {{fourAlong(row, i[lane]), fourAlong(row + nextJ, i[lane])},
                               {fourAlong(row + nextK, i[lane]), fourAlong(row + nextJ + nextK, i[lane])}};
      const Quad near = mix(rows[0][0], rows[0][1], alongJ);  // plane k
      const Quad far = mix(rows[1][0], rows[1][1], alongJ);   // plane k + 1
      const Quad low = mix(rows[0][0], rows[1][0], alongK);   // row j
      const Quad high = mix(rows[0][1], rows[1][1], alongK);  // row j + 1
      const Quad middle = mix(near, far, alongK);
      // The same beside the cell, of its own two columns alone: rows j - 1 and j + 2, planes k - 1 and k + 2.
      const Voxel* cell = row + i[lane];
      const auto mixPairs = [&](Quad pairs, float share) HWY_ATTR {
        const hn::Half<Quads> pair;
        const auto a = hn::LowerHalf(pair, pairs);
        return hn::MulAdd(hn::Sub(hn::UpperHalf(pair, pairs), a), hn::Set(pair, share), a);
      };
      const auto below = mixPairs(twoPairs(cell + lowJ, cell + lowJ + nextK), w[lane]);
      const auto above = mixPairs(twoPairs(cell + highJ, cell + highJ + nextK), w[lane]);
      const auto before = mixPairs(twoPairs(cell + lowK, cell + lowK + nextJ), v[lane]);
      const auto behind = mixPairs(twoPairs(cell + highK, cell + highK + nextJ), v[lane]);
      const hn::Half<Quads> pair;
      const hn::Half<hn::Half<Quads>> one;
      const auto alongI = [&](const auto& two) HWY_ATTR {
        const auto left = hn::LowerHalf(one, two);
        return hn::GetLane(hn::MulAdd(hn::Sub(hn::UpperHalf(one, two), left), hn::Set(one, u[lane]), left));
      };
      slopes[lane] = alongI(hn::Sub(hn::UpperHalf(pair, middle), hn::LowerHalf(pair, middle)));
      const auto slopeAt = [&](const auto& outerBefore, Quad innerBefore, Quad innerAfter, const auto& outerAfter,
                               float share) HWY_ATTR {
        const auto inner = [&](Quad four)
                               HWY_ATTR { return hn::LowerHalf(pair, hn::ShiftRightLanes<1>(Quads(), four)); };
        const auto first = hn::Sub(inner(innerAfter), outerBefore);
        const auto second = hn::Sub(outerAfter, inner(innerBefore));
        return alongI(hn::MulAdd(hn::Sub(second, first), hn::Set(pair, share), first));
      };
      slopes[kLanes + lane] = slopeAt(below, low, high, above, v[lane]);
      slopes[2 * kLanes + lane] = slopeAt(before, near, far, behind, w[lane]);
    }
  }

 private:
  /// The voxels from i - 1 to i + 2 of a row; those at its ends stand for what is beyond.
  HWY_ATTR HWY_INLINE Quad fourAlong(const Voxel* row, int32_t i) const {
    const int32_t last = finder_.size().x - 1;
    if (i > 0 && i + 2 <= last) {
      if constexpr (std::is_same_v<Voxel, float>) {
        return hn::LoadU(Quads(), row + i - 1);
      } else {
        return twoPairs(row + i - 1, row + i + 1);
      }
    }
    HWY_ALIGN float four[4];
    for (int32_t n = 0; n < 4; ++n) {
      four[n] = static_cast<float>(row[std::clamp(i - 1 + n, 0, last)]);
    }
    return loadQuad(four);
  }

  /// The voxels at `a` and `b`, each with its neighbour along i.
  HWY_ATTR static HWY_INLINE Quad twoPairs(const Voxel* a, const Voxel* b) {
    const Quads quads;
    if constexpr (std::is_same_v<Voxel, float>) {
      const hn::Half<Quads> pair;
      return hn::Combine(quads, hn::LoadU(pair, b), hn::LoadU(pair, a));
    } else {
      using Word = std::conditional_t<sizeof(Voxel) == 1, uint16_t, uint32_t>;
      using Words = std::conditional_t<sizeof(Voxel) == 1, uint32_t, uint64_t>;
      Word first;
      Word second;
      std::memcpy(&first, a, sizeof(Word));
      std::memcpy(&second, b, sizeof(Word));
      const Words both = first | static_cast<Words>(static_cast<Words>(second) << (8 * sizeof(Word)));
      const auto narrow = hn::BitCast(hn::Simd<Voxel, 4, 0>(), hn::Set(hn::Simd<Words, 1, 0>(), both));
      return hn::ConvertTo(quads, hn::PromoteTo(hn::Full128<int32_t>(), narrow));
    }
  }

  const Voxel* voxels_;
  double first_;
  CellFinder finder_;
  int32_t nextJ_;
  int32_t nextK_;
};
#endif

}  // namespace ocelli::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
