// What happens within steps along rays, in the instruction set that the file which includes this is compiled for
// (hwy/foreach_target.h): places along pieces, the light there, and the order of colours.
#if defined(OCELLI_MARCH_STEPS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef OCELLI_MARCH_STEPS_INL_H
#undef OCELLI_MARCH_STEPS_INL_H
#else
#define OCELLI_MARCH_STEPS_INL_H
#endif

#include "oc_core/volume_render/march_field-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ocelli::HWY_NAMESPACE {

/// A piece, in single precision, and where it begins along the rays' part that it belongs to.
struct MarchPiece {
  glm::vec3 from;
  glm::vec3 way;
  glm::vec3 direction;  ///< unit, in the scene's world
  float begin;
  float end;
  float t;
  float tByLength;
  bool continues;  ///< the piece before
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
  Point direction;  ///< of the ray
};

/// The places at these lengths, which do not fall, from the piece `first` on.
template <bool kWithDirection>
HWY_ATTR HWY_INLINE Places placesAt(const MarchPart& part, size_t first, FloatVec length, float last) {
  const Floats d;
  const auto along = [&](const MarchPiece& piece) HWY_ATTR {
    const FloatVec rest = hn::Sub(length, hn::Set(d, piece.begin));
    Places p{{hn::MulAdd(rest, hn::Set(d, piece.way.x), hn::Set(d, piece.from.x)),
              hn::MulAdd(rest, hn::Set(d, piece.way.y), hn::Set(d, piece.from.y)),
              hn::MulAdd(rest, hn::Set(d, piece.way.z), hn::Set(d, piece.from.z))},
             {hn::Zero(d), hn::Zero(d), hn::Zero(d)}};
    if constexpr (kWithDirection) {
      p.direction = {hn::Set(d, piece.direction.x), hn::Set(d, piece.direction.y), hn::Set(d, piece.direction.z)};
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
    if constexpr (kWithDirection) {
      choose(places.direction.x, next.direction.x);
      choose(places.direction.y, next.direction.y);
      choose(places.direction.z, next.direction.z);
    }
  }
  return places;
}

/// The colour of a place becomes colour * factor + added.
struct Light {
  FloatVec factor;
  FloatVec added;
};

/// GradientLight::at(), at the first `count` places.
template <class Field>
HWY_ATTR HWY_NOINLINE Light lightAt(const MarchSetup& setup, const Field& field, const Places& places, size_t count) {
  const Floats d;
  const GradientLight<float>& rule = setup.light;
  const FloatVec one = hn::Set(d, 1.0f);
  const FloatVec half = hn::Set(d, 0.5f);
  HWY_ALIGN float slopes[3 * kLanes];
  field.readSlopes(places.index, count, slopes);
  const FloatVec gx = hn::Load(d, slopes);
  const FloatVec gy = hn::Load(d, slopes + kLanes);
  const FloatVec gz = hn::Load(d, slopes + 2 * kLanes);
  const glm::mat3& m = rule.worldFromIndexGradient;
  const auto row = [&](int i) HWY_ATTR {
    return hn::Mul(half, hn::MulAdd(gx, hn::Set(d, m[0][i]),
                                    hn::MulAdd(gy, hn::Set(d, m[1][i]), hn::Mul(gz, hn::Set(d, m[2][i])))));
  };
  const Point g{row(0), row(1), row(2)};
  const auto dot = [&](const Point& a, const Point& b)
                       HWY_ATTR { return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z))); };
  const FloatVec length = hn::Sqrt(dot(g, g));
  const FloatVec perLength = hn::Div(one, hn::Max(length, hn::Set(d, 1e-30f)));
  const FloatVec lit = hn::Min(one, hn::Mul(length, hn::Set(d, rule.litByGradient)));
  const Point toLight{hn::Set(d, rule.toLight.x), hn::Set(d, rule.toLight.y), hn::Set(d, rule.toLight.z)};
  const FloatVec cosine = hn::Mul(hn::Abs(dot(g, toLight)), perLength);
  const FloatVec shade = hn::MulAdd(cosine, hn::Set(d, rule.diffuse), hn::Set(d, rule.ambient));
  Light light{hn::MulAdd(lit, hn::Sub(shade, one), one), hn::Zero(d)};
  if (rule.specular > 0) {
    // The direction between that to the light and that to the eye.
    const Point between{hn::Sub(toLight.x, places.direction.x), hn::Sub(toLight.y, places.direction.y),
                        hn::Sub(toLight.z, places.direction.z)};
    const FloatVec perBetween = hn::Div(one, hn::Max(hn::Sqrt(dot(between, between)), hn::Set(d, 1e-6f)));
    const FloatVec highlight = hn::Mul(hn::Mul(hn::Abs(dot(g, between)), perBetween), perLength);
    const FloatVec power =
        hn::Exp(d, hn::Mul(hn::Set(d, rule.shininess), hn::Log(d, hn::Max(highlight, hn::Set(d, 1e-30f)))));
    light.added = hn::Mul(hn::Mul(lit, hn::Set(d, rule.specular)), power);
  }
  return light;
}

/// At one end of each step of a group: extinction, and its products with colours.
struct Ends {
  FloatVec extinction;
  FloatVec red;
  FloatVec green;
  FloatVec blue;
};

/// What the order of colours within a step changes: those nearer to the eye count more. With the colour linear in the
/// optical depth that lies before it, from c0 to c1 over a depth of tau, the light of the step is that of its mean
/// colour and, besides,
///
///   (c1 - c0) ((1 - exp(-tau)) / tau - (1 + exp(-tau)) / 2).
///
/// The last factor is exp(-tau / 2) (-tau^2 / 12) (1 + tau^2 / 40 + tau^4 / 4480 + ...), from which steps of tau below
/// 1 are reckoned, as the difference above loses digits there. What passes nothing shows c0 alone.
class ColorOrder {
 public:
  /// How much light passes all before the step, and all before its end.
  struct Passes {
    FloatVec before;
    FloatVec after;
  };
  /// `before` and `after` are the extinctions at both ends, `depth` is tau, and `likeEnds` how much this is to count.
  HWY_ATTR HWY_INLINE ColorOrder(FloatVec before, FloatVec after, FloatVec depth, FloatVec perDepth,
                                 const Passes& passes, FloatVec likeEnds) {
    const Floats d;
    const FloatVec zero = hn::Zero(d);
    const FloatVec one = hn::Set(d, 1.0f);
    isBefore_ = hn::Gt(before, zero);
    isAfter_ = hn::Gt(after, zero);
    perBefore_ = hn::Div(one, hn::IfThenElse(isBefore_, before, one));
    perAfter_ = hn::Div(one, hn::IfThenElse(isAfter_, after, one));
    const auto isSteep = hn::Gt(depth, one);
    const FloatVec bounded = hn::Min(depth, one);
    const FloatVec square = hn::Mul(bounded, bounded);
    const FloatVec series = hn::MulAdd(square, hn::MulAdd(square, hn::Set(d, 1.0f / 4480), hn::Set(d, 1.0f / 40)), one);
    const FloatVec through = hn::Sqrt(hn::Mul(passes.before, passes.after));
    const FloatVec bySeries = hn::Mul(hn::Mul(hn::Mul(square, hn::Set(d, -1.0f / 12)), series), through);
    const FloatVec kept = hn::Sub(passes.before, passes.after);
    const FloatVec halfSum = hn::Mul(hn::Add(passes.before, passes.after), hn::Set(d, 0.5f));
    const FloatVec closed = hn::MulSub(kept, perDepth, halfSum);
    weight_ = hn::Mul(hn::IfThenElse(isSteep, closed, bySeries), likeEnds);
    steep_ = hn::IfThenElseZero(isSteep, hn::Sub(one, perDepth));
  }

  /// Of a channel, whose mean is `mean`. An end that shows nothing has no colour: it lies as far from the mean as the
  /// other. Where colours are not linear in the depth, c1 - c0 is not twice what the mean is more than c0: steps that
  /// pass next to nothing go by the latter, which makes c0 of them.
  HWY_ATTR HWY_INLINE FloatVec light(FloatVec mean, FloatVec before, FloatVec after) const {
    FloatVec first = hn::Mul(before, perBefore_);
    FloatVec last = hn::Mul(after, perAfter_);
    first = hn::IfThenElse(isBefore_, first, hn::Sub(hn::Add(mean, mean), last));
    last = hn::IfThenElse(isAfter_, last, hn::Sub(hn::Add(mean, mean), first));
    const FloatVec change = hn::Sub(last, first);
    const FloatVec fromFirst = hn::Sub(mean, first);
    const FloatVec order = hn::MulAdd(steep_, hn::Sub(hn::Add(fromFirst, fromFirst), change), change);
    return hn::IfThenZeroElse(hn::AndNot(isBefore_, hn::Not(isAfter_)), hn::Mul(order, weight_));
  }

 private:
  hn::Mask<Floats> isBefore_;
  hn::Mask<Floats> isAfter_;
  FloatVec perBefore_;
  FloatVec perAfter_;
  FloatVec weight_;
  FloatVec steep_;  ///< 0 up to a depth of 1, towards 1 behind
};

}  // namespace ocelli::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
