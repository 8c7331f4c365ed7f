#include "oc_core/volume_render/index_points.h"

#include "oc_core/base/vector_targets.h"

// This file is compiled once for each of these instruction sets; foreach_target.h includes it again and again.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "oc_core/volume_render/index_points.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ocelli::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, 8>;
using Bits = hn::RebindToUnsigned<Doubles>;
using PointFloats = hn::Rebind<float, Doubles>;
using DoubleVec = hn::Vec<Doubles>;
using DoubleMask = hn::Mask<Doubles>;

/// For each face of a box whether all points so far lie beyond it.
class FacesBeyond {
 public:
  HWY_ATTR explicit FacesBeyond(const IndexBox& box) : box_(box) {
    for (DoubleMask& each : all_) {
      each = hn::FirstN(Doubles(), kLanes);
    }
  }
  /// The bits of the faces that points lie beyond. Where not `counts`, lanes hold no point.
  HWY_ATTR HWY_INLINE hn::Vec<Bits> look(DoubleVec x, DoubleVec y, DoubleVec z, DoubleMask counts) {
    const Doubles d;
    const auto below = [&](DoubleVec v, double limit) HWY_ATTR { return hn::Lt(v, hn::Set(d, limit)); };
    const auto above = [&](DoubleVec v, double limit) HWY_ATTR { return hn::Gt(v, hn::Set(d, limit)); };
    const DoubleMask beyond[kFaces] = {below(x, box_.lower.x), below(y, box_.lower.y), below(z, box_.lower.z),
                                       above(x, box_.upper.x), above(y, box_.upper.y), above(z, box_.upper.z)};
    const Bits bits;
    hn::Vec<Bits> all = hn::Zero(bits);
    for (size_t face = 0; face < kFaces; ++face) {
      all_[face] = hn::And(all_[face], hn::Or(beyond[face], hn::Not(counts)));
      const hn::Vec<Bits> lanes = hn::BitCast(bits, hn::VecFromMask(d, beyond[face]));
      all = hn::Or(all, hn::And(lanes, hn::Set(bits, uint64_t(1) << face)));
    }
    return all;
  }
  HWY_ATTR bool any() const {
    for (const DoubleMask& each : all_) {
      if (hn::AllTrue(Doubles(), each)) {
        return true;
      }
    }
    return false;
  }

 private:
  static constexpr size_t kFaces = 6;
  static constexpr size_t kLanes = hn::MaxLanes(Doubles());
  const IndexBox& box_;
  DoubleMask all_[kFaces];
};

HWY_ATTR bool place(const RayPath& ray, const glm::dmat4& m, const IndexBox& box, const IndexBox& seen,
                    IndexPoints& points) {
  const Doubles d;
  constexpr size_t kLanes = hn::MaxLanes(Doubles());
  static_assert(RayPath::kMaxPoints % kLanes == 0, "the last vector is read whole");
  const float* const p = &ray.begin()->x;
  FacesBeyond ofBox(box);
  FacesBeyond ofSeen(seen);
  for (size_t i = 0; i < ray.size(); i += kLanes) {
    hn::Vec<PointFloats> fx;
    hn::Vec<PointFloats> fy;
    hn::Vec<PointFloats> fz;
    hn::LoadInterleaved3(PointFloats(), p + 3 * i, fx, fy, fz);
    const DoubleVec px = hn::PromoteTo(d, fx);
    const DoubleVec py = hn::PromoteTo(d, fy);
    const DoubleVec pz = hn::PromoteTo(d, fz);
    const auto row = [&](int r) HWY_ATTR {
      return hn::MulAdd(px, hn::Set(d, m[0][r]),
                        hn::MulAdd(py, hn::Set(d, m[1][r]), hn::MulAdd(pz, hn::Set(d, m[2][r]), hn::Set(d, m[3][r]))));
    };
    const DoubleVec x = row(0);
    const DoubleVec y = row(1);
    const DoubleVec z = row(2);
    hn::Store(x, d, points.x.data() + i);
    hn::Store(y, d, points.y.data() + i);
    hn::Store(z, d, points.z.data() + i);
    const DoubleMask counts = hn::FirstN(d, ray.size() - i);
    hn::Store(ofBox.look(x, y, z, counts), Bits(), points.beyond.data() + i);
    ofSeen.look(x, y, z, counts);
  }
  return !ofBox.any() && !ofSeen.any();
}

}  // namespace ocelli::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ocelli {

HWY_EXPORT(place);

bool placePoints(const RayPath& ray, const glm::dmat4& indexFromWorld, const IndexBox& box, const IndexBox& seen,
                 IndexPoints& points) {
  return HWY_DYNAMIC_DISPATCH(place)(ray, indexFromWorld, box, seen, points);
}

}  // namespace ocelli
#endif  // HWY_ONCE
