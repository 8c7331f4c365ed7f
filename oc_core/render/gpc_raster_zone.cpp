#include "oc_core/render/gpc_raster_zone.h"

#include <algorithm>
#include <bit>

namespace ocelli {
namespace {

/// `a` or `b`, both of which are worked out: loops that branch cannot be vectorised.
float chosen(bool first, float a, float b) {
  const uint32_t mask = first ? ~uint32_t{0} : 0;
  return std::bit_cast<float>((std::bit_cast<uint32_t>(a) & mask) | (std::bit_cast<uint32_t>(b) & ~mask));
}

float lesserOf(float a, float b) {
  return chosen(a < b, a, b);
}
float greaterOf(float a, float b) {
  return chosen(a > b, a, b);
}

/// Pixels whose centres lie within `half` of a place on an axis; both ends included.
struct GpcPixels {
  int first;
  int last;
};
GpcPixels gpcPixelsAlong(double center, double half, int count) {
  const auto clamped = [&](double pixel) {
    return static_cast<int>(std::clamp(pixel, -1.0, static_cast<double>(count)));
  };
  return {std::max(clamped(std::ceil(center - half - 0.5)), 0),
          std::min(clamped(std::floor(center + half - 0.5)), count - 1)};
}

PixelBounds gpcPixelBounds(const glm::dvec2& center, const glm::dvec2& half, const glm::ivec2& size) {
  const GpcPixels x = gpcPixelsAlong(center.x, half.x, size.x);
  const GpcPixels y = gpcPixelsAlong(center.y, half.y, size.y);
  return {x.first, y.first, std::max(x.last + 1, x.first), std::max(y.last + 1, y.first)};
}

ImageBox slackBox(const glm::dvec2& center, const glm::dvec2& half) {
  return {glm::vec2(center - half) - GpcRasterZone::kBoxSlack, glm::vec2(center + half) + GpcRasterZone::kBoxSlack};
}

}  // namespace

GpcRasterZone::GpcRasterZone(const GpcZone& zone, uint32_t index, const glm::ivec2& size)
    : zone_(&zone),
      firstPart_(index * kParts),
      innerPixels_(gpcPixelBounds(zone.center(), zone.half(), size)),
      outerPixels_(gpcPixelBounds(zone.center(), zone.outerHalf(), size)),
      innerBox_(slackBox(zone.center(), zone.innerHalfInPinhole())),
      outerBox_(slackBox(zone.center(), zone.outerHalf())),
      center_(zone.center()),
      perHalf_(1.0 / zone.half()),
      zoom_(static_cast<float>(zone.profile().zoom())),
      inner_(static_cast<float>(1 / zone.profile().zoom())),
      outer_(static_cast<float>(zone.profile().outer())),
      c1_(static_cast<float>(zone.profile().coefficients()[1])),
      c2_(static_cast<float>(zone.profile().coefficients()[2])),
      c3_(static_cast<float>(zone.profile().coefficients()[3])),
      columns_(lines({outerPixels_.x0, outerPixels_.x1 - 1}, {innerPixels_.x0, innerPixels_.x1 - 1}, 0)),
      rows_(lines({outerPixels_.y0, outerPixels_.y1 - 1}, {innerPixels_.y0, innerPixels_.y1 - 1}, 1)) {
  tabulateInverse();
  const double longest = std::min(zone.half().x, zone.half().y) * (zone.profile().outer() - 1) / 8;
  longestSquared_ = static_cast<float>(longest * longest);
}

std::vector<GpcRasterZone::Line> GpcRasterZone::lines(const Range& outer, const Range& inner, int axis) const {
  const GpcProfile& profile = zone_->profile();
  std::vector<Line> result;
  result.reserve(static_cast<size_t>(outer.last - outer.first + 1));
  for (int i = outer.first; i <= outer.last; ++i) {
    const double offset = i + 0.5 - zone_->center()[axis];
    const double distance = std::abs(offset) / zone_->half()[axis];
    const bool isInner = i >= inner.first && i <= inner.last;
    const double r = isInner ? std::min(distance, 1.0) : std::max(distance, std::nextafter(1.0, 2.0));
    const double scale = isInner ? 1 / profile.zoom() : profile.sampled(r) / r;
    result.push_back({r, offset, scale, std::max(scale, profile.slope(r))});
  }
  return result;
}

void GpcRasterZone::tabulateInverse() {
  constexpr size_t kMinSteps = 64;
  constexpr size_t kMaxSteps = 4096;
  for (size_t steps = kMinSteps; steps <= kMaxSteps && !tabulateInverse(steps); steps *= 2) {
  }
}

/// Whether the table was fine enough; it is empty where not.
bool GpcRasterZone::tabulateInverse(size_t steps) {
  const GpcProfile& profile = zone_->profile();
  const double inner = 1 / profile.zoom();
  const double width = profile.outer() - inner;
  // Where the inverse of a quadratic, (-c1 + sqrt(c1^2 + 4 c2 g)) / (2 c2) with g = f - f(1), bends most.
  const double bends = profile.coefficients()[1] * profile.coefficients()[1] / std::abs(profile.coefficients()[2]);
  const double compression = std::clamp(bends, width / 64, width * 4);
  compression_ = static_cast<float>(compression);
  steps_ = static_cast<float>(static_cast<double>(steps) * (width + compression) / width);
  nodes_.assign(steps, Node{});
  std::vector<double> s(steps + 1);
  s[steps] = profile.outer() - 1;
  for (size_t i = 1; i < steps; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(steps);
    s[i] = profile.inverse(inner + t * width * compression / (width * (1 - t) + compression)) - 1;
  }
  for (size_t i = 0; i < steps; ++i) {
    nodes_[i] = {static_cast<float>(s[i]), static_cast<float>(s[i + 1] - s[i])};
  }
  constexpr size_t kPlaces = 4;
  for (size_t i = 0; i < steps; ++i) {
    std::array<float, kPlaces> f{};
    std::array<double, kPlaces> r{};
    for (size_t k = 0; k < kPlaces; ++k) {
      const double exact = 1 + s[i] + (s[i + 1] - s[i]) * (static_cast<double>(k) + 0.5) / kPlaces;
      f[k] = static_cast<float>(profile.sampled(exact));
      r[k] = exact + (static_cast<double>(f[k]) - profile.sampled(exact)) / profile.slope(exact);
    }
    std::array<float, kPlaces> magnification{};
    magnify(f, magnification);
    for (size_t k = 0; k < kPlaces; ++k) {
      const double error = std::abs(static_cast<double>(magnification[k]) * static_cast<double>(f[k]) - r[k]);
      if (!(error * glm::length(zone_->half()) <= kMaxErrorPixels)) {
        nodes_.clear();
        return false;
      }
    }
  }
  return true;
}

template <size_t kCount>
void GpcRasterZone::magnify(const std::array<float, kCount>& f, std::array<float, kCount>& magnification) const {
  if (!isTabulated()) {
    for (size_t i = 0; i < kCount; ++i) {
      magnification[i] = static_cast<float>(zone_->magnification(static_cast<double>(f[i])));
    }
    return;
  }
  // In loops that the compiler can vectorise, but for the one that looks up.
  const float inner = inner_;
  const float outer = outer_;
  const float steps = steps_;
  const float compression = compression_;
  const float zoom = zoom_;
  const float c1 = c1_;
  const float c2 = c2_;
  const float c3 = c3_;
  std::array<float, kCount> within{};
  std::array<float, kCount> at{};
  std::array<float, kCount> s{};
  for (size_t i = 0; i < kCount; ++i) {
    within[i] = lesserOf(greaterOf(f[i], inner), outer);
    const float g = within[i] - inner;
    at[i] = g * steps / (g + compression);
  }
  const auto last = static_cast<int32_t>(nodes_.size()) - 1;
  for (size_t i = 0; i < kCount; ++i) {
    const int32_t node = std::min(static_cast<int32_t>(at[i]), last);
    const Node& held = nodes_[static_cast<size_t>(node)];
    s[i] = held.s + held.change * (at[i] - static_cast<float>(node));
  }
  for (size_t i = 0; i < kCount; ++i) {
    const float error = s[i] * (c1 + s[i] * (c2 + s[i] * c3)) - (within[i] - inner);
    const float slope = c1 + s[i] * (2 * c2 + s[i] * (3 * c3));
    const float r = 1 + (s[i] - error / slope);
    const float m = r / within[i];
    magnification[i] = chosen(f[i] <= inner, zoom, chosen(f[i] < outer, m, 1));
  }
}

void GpcRasterZone::place(GpcRun& run) const {
  const glm::vec2 center = center_;
  const glm::vec2 perHalf = perHalf_;
  const float inner = inner_;
  const float outer = outer_;
  const uint32_t innerPart = firstPart_;
  std::array<float, GpcRun::kSize> f{};
  for (size_t i = 0; i < GpcRun::kSize; ++i) {
    f[i] = greaterOf(std::abs(run.u[i] - center.x) * perHalf.x, std::abs(run.v[i] - center.y) * perHalf.y);
  }
  std::array<float, GpcRun::kSize> magnification{};
  magnify(f, magnification);
  for (size_t i = 0; i < GpcRun::kSize; ++i) {
    const float du = run.u[i] - center.x;
    const float dv = run.v[i] - center.y;
    const float x = du * magnification[i] + center.x;
    const float y = dv * magnification[i] + center.y;
    run.x[i] = chosen(f[i] < outer, x, run.x[i]);
    run.y[i] = chosen(f[i] < outer, y, run.y[i]);
  }
  for (size_t i = 0; i < GpcRun::kSize; ++i) {
    const float du = run.u[i] - center.x;
    const float dv = run.v[i] - center.y;
    const float x = std::abs(du) * perHalf.x;
    const float y = std::abs(dv) * perHalf.y;
    const uint32_t sideways = du > 0 ? 1 : 2;
    const uint32_t updown = dv > 0 ? 3 : 4;
    const uint32_t side = x >= y ? sideways : updown;
    const uint32_t part = innerPart + (f[i] <= inner ? 0 : side);
    run.part[i] = f[i] < outer ? part : run.part[i];
  }
  bend(run, f, magnification);
}

/// A point moves along its line to the centre by m(f) = r / f. Let E be a step of the image, E_a its component along
/// the axis of the side, and E_t the other one. While the pinhole's point moves on a straight line by what E is the
/// image of, the image has the second derivative (R E_a^2, S E_a E_t + Q E_a^2) with R = r'' f'^2 / h, S = 2 m' f' / (m
/// h), and Q = d_t f'^2 (m'' - 2 m'^2 / m) / h^2, where h is the half extent along the axis, d_t the point's distance
/// from the centre along the other one, and derivatives are by f, but for f'(r).
void GpcRasterZone::bend(GpcRun& run, const std::array<float, GpcRun::kSize>& f,
                         const std::array<float, GpcRun::kSize>& magnification) const {
  constexpr float kPer = 1 / kMaxBend;
  constexpr float kNoDistance = 1e-9f;
  const glm::vec2 center = center_;
  const glm::vec2 perHalfs = perHalf_;
  const ImageBox outerBox = outerBox_;
  const float inner = inner_;
  const float outer = outer_;
  const float c1 = c1_;
  const float c2 = c2_;
  const float c3 = c3_;
  const float perLongest = 1 / longestSquared_;
  for (size_t i = 0; i < GpcRun::kSize; ++i) {
    const float du = run.u[i] - center.x;
    const float dv = run.v[i] - center.y;
    const float m = magnification[i];
    const float s = m * f[i] - 1;
    const float slope = c1 + s * (2 * c2 + s * (3 * c3));
    const float perSlope = 1 / slope;
    const float perF = 1 / f[i];
    const float bend = -(2 * c2 + s * (6 * c3)) * perSlope;  // r'' f'^2
    const float m1 = (perSlope - m) * perF;
    const float m2 = (bend * perSlope * perSlope - 2 * m1) * perF;
    const float turn = 2 * m1 / m;
    const float besideX = std::abs(du) * perHalfs.x;
    const float besideY = std::abs(dv) * perHalfs.y;
    const float perHalf = chosen(besideX >= besideY, perHalfs.x, perHalfs.y);
    const float off = chosen(besideX >= besideY, dv, du);
    const float along = std::abs(bend) * perHalf;
    const float across = std::abs(slope * slope * (m2 - turn * m1) * off) * (perHalf * perHalf);
    const float mixed = std::abs(turn * slope) * perHalf * kPer;
    // |(R E_a, S E_t + Q E_a)| <= |(R, Q)| |E_a| + |S E_t|, and sqrt(x^2 + y^2) <= y + (sqrt(2) - 1) x for x <= y.
    constexpr float kRootLess1 = 0.41421357f;
    const float both = (greaterOf(along, across) + kRootLess1 * lesserOf(along, across)) * kPer;
    const float bounded = greaterOf(both, perLongest);
    const float bentX = chosen(besideX >= besideY, bounded, perLongest);
    const float bentY = chosen(besideX >= besideY, perLongest, bounded);
    // Beyond the outer edge: within the distance from there no edge reaches it.
    const float beyondX = greaterOf(greaterOf(outerBox.lower.x - run.u[i], run.u[i] - outerBox.upper.x), 0);
    const float beyondY = greaterOf(greaterOf(outerBox.lower.y - run.v[i], run.v[i] - outerBox.upper.y), 0);
    const float reach = 1 / (beyondX * beyondX + beyondY * beyondY + kNoDistance);
    const float away = greaterOf(run.xx[i], reach);
    run.xx[i] = chosen(f[i] < outer, chosen(f[i] <= inner, 0, bentX), away);
    run.yy[i] = chosen(f[i] < outer, chosen(f[i] <= inner, 0, bentY), away);
    run.xy[i] = chosen(f[i] < outer, chosen(f[i] <= inner, 0, mixed), 0);
  }
}

ImageBox GpcRasterZone::imageBox(const ImageBox& pinhole) const {
  // Along an axis the image grows with the point, and with the other coordinate it changes in one direction: its
  // extremes are at the ends of the box along the axis, where the other coordinate is nearest or farthest.
  const glm::vec2 lower = pinhole.lower - center_;
  const glm::vec2 upper = pinhole.upper - center_;
  const glm::vec2 atLower = glm::abs(lower) * perHalf_;
  const glm::vec2 atUpper = glm::abs(upper) * perHalf_;
  const glm::vec2 nearest = glm::max(glm::max(lower, -upper), 0.0f) * perHalf_;
  const glm::vec2 farthest = glm::max(atLower, atUpper);
  const std::array<float, 8> f{std::max(atLower.x, nearest.y), std::max(atLower.x, farthest.y),
                               std::max(atUpper.x, nearest.y), std::max(atUpper.x, farthest.y),
                               std::max(atLower.y, nearest.x), std::max(atLower.y, farthest.x),
                               std::max(atUpper.y, nearest.x), std::max(atUpper.y, farthest.x)};
  std::array<float, 8> m{};
  magnify(f, m);
  return {center_ - kBoxSlack +
              glm::vec2(std::min(lower.x * m[0], lower.x * m[1]), std::min(lower.y * m[4], lower.y * m[5])),
          center_ + kBoxSlack +
              glm::vec2(std::max(upper.x * m[2], upper.x * m[3]), std::max(upper.y * m[6], upper.y * m[7]))};
}

GpcRasterZone::Range GpcRasterZone::columnsNearerThan(const Line& row, int first, int last) const {
  // About where, a pixel too far, and from there on by the tables.
  const double reach = row.r * zone_->half().x;
  Range range{static_cast<int>(std::max<double>(first, std::floor(zone_->center().x - reach - 0.5))),
              static_cast<int>(std::min<double>(last, std::ceil(zone_->center().x + reach - 0.5)))};
  while (range.first <= range.last && column(range.first).r >= row.r) {
    ++range.first;
  }
  while (range.first <= range.last && column(range.last).r >= row.r) {
    --range.last;
  }
  return range;
}

GpcRasterZone::Range GpcRasterZone::rowsNoFartherThan(const Line& column, int first, int last) const {
  const double reach = column.r * zone_->half().y;
  Range range{static_cast<int>(std::max<double>(first, std::floor(zone_->center().y - reach - 0.5))),
              static_cast<int>(std::min<double>(last, std::ceil(zone_->center().y + reach - 0.5)))};
  while (range.first <= range.last && row(range.first).r > column.r) {
    ++range.first;
  }
  while (range.first <= range.last && row(range.last).r > column.r) {
    --range.last;
  }
  return range;
}

}  // namespace ocelli
