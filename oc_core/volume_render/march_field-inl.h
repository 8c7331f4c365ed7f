// The field of a volume at many places at once, in the instruction set that the file which includes this is compiled
// for (hwy/foreach_target.h).
//
// Two neighbours along i lie in one word of 32 bits where voxels are small, so a word is gathered for both. Nothing is
// read beyond the last voxel.
#if defined(OCELLI_MARCH_FIELD_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef OCELLI_MARCH_FIELD_INL_H
#undef OCELLI_MARCH_FIELD_INL_H
#else
#define OCELLI_MARCH_FIELD_INL_H
#endif

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include "oc_core/volume_render/march_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace ocelli::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
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
#endif

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
  constexpr size_t kCount = HWY_LANES(int32_t);
  HWY_ALIGN int32_t at[kCount];
  HWY_ALIGN int32_t words[kCount];
  hn::Store(offsets, di, at);
  for (size_t i = 0; i < kCount; ++i) {
    std::memcpy(&words[i], static_cast<const char*>(first) + at[i], sizeof(int32_t));
  }
  return hn::Load(di, words);
#endif
}

/// Whether NativeField can read it: offsets are words, and rows have neighbours.
inline bool fitsWords(const ScalarVolume& volume) {
  return std::endian::native == std::endian::little && volume.grid().size.x > 1 &&
         volume.voxels().size() >= sizeof(int32_t) &&
         volume.voxels().size() <= size_t(std::numeric_limits<int32_t>::max());
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

/// Any type and size: voxel by voxel.
class AnyField {
 public:
  explicit AnyField(const MarchSetup& setup) : volume_(*setup.volume), first_(setup.firstNumber), finder_(volume_) {}

  HWY_ATTR HWY_INLINE Point centerNear(const Point& p) const { return finder_.centerNear(p); }

  /// The numbers in the voxels, interpolated, less the first of the table.
  HWY_ATTR HWY_NOINLINE FloatVec at(const Point& index) const {
    const Floats d;
    const Ints di;
    constexpr size_t kCount = HWY_LANES(float);
    const auto cells = finder_.find(index);
    HWY_ALIGN int32_t i[kCount];
    HWY_ALIGN int32_t j[kCount];
    HWY_ALIGN int32_t k[kCount];
    HWY_ALIGN float u[kCount];
    HWY_ALIGN float v[kCount];
    HWY_ALIGN float w[kCount];
    HWY_ALIGN float values[kCount];
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
      for (size_t lane = 0; lane < kCount; ++lane) {
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
    return hn::Load(d, values);
  }

 private:
  const ScalarVolume& volume_;
  double first_;
  CellFinder finder_;
};

/// Of a volume that fitsWords().
template <class Voxel>
class NativeField {
 public:
  explicit NativeField(const MarchSetup& setup)
      : any_(setup),
        voxels_(reinterpret_cast<const Voxel*>(setup.volume->voxels().data())),
        first_(static_cast<float>(setup.firstNumber)),
        finder_(*setup.volume),
        nextJ_(finder_.size().y > 1 ? finder_.size().x : 0),
        nextK_(finder_.size().z > 1 ? finder_.size().x * finder_.size().y : 0),
        lastWord_(static_cast<int>(setup.volume->voxels().size() - sizeof(int32_t))) {}

  HWY_ATTR HWY_INLINE Point centerNear(const Point& p) const { return finder_.centerNear(p); }

  HWY_ATTR HWY_INLINE FloatVec at(const Point& index) const {
    const Floats d;
    const Ints di;
    const auto c = finder_.find(index);
    const IntVec cell =
        hn::Add(hn::Mul(hn::Add(hn::Mul(c.k, hn::Set(di, finder_.size().y)), c.j), hn::Set(di, finder_.size().x)), c.i);
    if constexpr (sizeof(Voxel) == 1) {
      // A word at one of the last voxels would end beyond them.
      if (HWY_UNLIKELY(!hn::AllFalse(di, hn::Gt(cell, hn::Set(di, lastWord_ - nextJ_ - nextK_))))) {
        return any_.at(index);
      }
    }
    const auto next = [&](int32_t step) HWY_ATTR { return hn::Add(cell, hn::Set(di, step)); };
    const FloatVec near = mix(row(cell, c.share.x), row(next(nextJ_), c.share.x), c.share.y);
    const FloatVec far = mix(row(next(nextK_), c.share.x), row(next(nextJ_ + nextK_), c.share.x), c.share.y);
    return hn::Sub(mix(near, far, c.share.z), hn::Set(d, first_));
  }

 private:
  HWY_ATTR static HWY_INLINE FloatVec mix(FloatVec a, FloatVec b, FloatVec share) {
    return hn::MulAdd(hn::Sub(b, a), share, a);
  }

  /// Between a voxel and its neighbour along i.
  HWY_ATTR HWY_INLINE FloatVec row(IntVec voxel, FloatVec share) const {
    const Floats d;
    const Ints di;
    if constexpr (std::is_same_v<Voxel, float>) {
      const FloatVec a = hn::GatherIndex(d, voxels_, voxel);
      const FloatVec b = hn::GatherIndex(d, voxels_ + 1, voxel);
      return mix(a, b, share);
    } else {
      constexpr int kBits = 8 * int(sizeof(Voxel));
      const IntVec words = gatherWords(voxels_, sizeof(Voxel) == 1 ? voxel : hn::ShiftLeft<1>(voxel));
      // Little-endian: the first voxel is the lowest.
      const IntVec first = hn::ShiftLeft<32 - kBits>(words);
      const IntVec second = kBits == 16 ? words : hn::ShiftLeft<32 - 2 * kBits>(words);
      return mix(number(d, di, first), number(d, di, second), share);
    }
  }
  /// Of the topmost bits.
  HWY_ATTR static HWY_INLINE FloatVec number(Floats d, Ints di, IntVec words) {
    constexpr int kShift = 32 - 8 * int(sizeof(Voxel) < 4 ? sizeof(Voxel) : 2);
    if constexpr (std::is_signed_v<Voxel>) {
      return hn::ConvertTo(d, hn::ShiftRight<kShift>(words));
    } else {
      const hn::RebindToUnsigned<Ints> dw;
      return hn::ConvertTo(d, hn::BitCast(di, hn::ShiftRight<kShift>(hn::BitCast(dw, words))));
    }
  }

  AnyField any_;
  const Voxel* voxels_;
  float first_;
  CellFinder finder_;
  int32_t nextJ_;
  int32_t nextK_;
  int32_t lastWord_;
};

}  // namespace ocelli::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
