#include "oc_core/antialiasing/pixel_samples.h"

#include <algorithm>
#include <cmath>

namespace ocelli {
namespace {

struct StrataRange {
  int first;
  int last;
};

/// The strata along one axis whose samples may lie in [lower, upper], both from the pixel's corner and in pixels.
StrataRange strataWithin(float lower, float upper, int count, float least, float greatest) {
  const auto strata = static_cast<float>(count);
  // Wider than rounding needs it.
  constexpr float kSlack = 1e-3f;
  const float first = std::ceil(lower * strata - greatest - kSlack);
  const float last = std::floor(upper * strata - least + kSlack);
  return {static_cast<int>(std::max(first, 0.0f)), static_cast<int>(std::min(last, strata - 1))};
}

}  // namespace

void PixelSamples::place(const AntialiasView& view, const PixelPlace& pixel, const SamplePattern& pattern) {
  pattern_ = &pattern;
  pixel_ = pixel;
  const auto count = static_cast<size_t>(pattern.size());
  x_.resize(count);
  y_.resize(count);
  const std::span<const float> u = pattern.u(pixel.x, pixel.y);
  const std::span<const float> v = pattern.v(pixel.x, pixel.y);
  if (pixel.area.isSquare) {
    bounds_ = pixel.square();
    const auto side = static_cast<float>(pixel.area.side);
    for (size_t i = 0; i < count; ++i) {
      x_[i] = bounds_.lower.x + u[i] * side;
      y_[i] = bounds_.lower.y + v[i] * side;
    }
    middle_ = (bounds_.lower + bounds_.upper) * 0.5f;
    return;
  }
  const auto placed = [&](double inU, double inV) {
    return glm::vec2(view.referencePoint(glm::dvec2(pixel.x + inU, pixel.y + inV)) - glm::dvec2(pixel.base));
  };
  middle_ = placed(0.5, 0.5);
  bounds_ = {middle_, middle_};
  for (size_t i = 0; i < count; ++i) {
    const glm::vec2 p = placed(static_cast<double>(u[i]), static_cast<double>(v[i]));
    x_[i] = p.x;
    y_[i] = p.y;
    bounds_ = {glm::min(bounds_.lower, p), glm::max(bounds_.upper, p)};
  }
}

void PixelSamples::draw(const AntialiasTriangle& t, uint32_t index) {
  const int columns = pattern_->columns();
  StrataRange across{0, columns - 1};
  StrataRange down{0, pattern_->rows() - 1};
  if (pattern_->isStratified() && pixel_.area.isSquare) {
    const auto perPixel = static_cast<float>(1 / pixel_.area.side);
    const glm::vec2 lower = (t.box.lower - bounds_.lower) * perPixel;
    const glm::vec2 upper = (t.box.upper - bounds_.lower) * perPixel;
    across = strataWithin(lower.x, upper.x, columns, pattern_->leastInStratum(), pattern_->greatestInStratum());
    down = strataWithin(lower.y, upper.y, pattern_->rows(), pattern_->leastInStratum(), pattern_->greatestInStratum());
  }
  const BlockPlane e0 = t.edges[0];
  const BlockPlane e1 = t.edges[1];
  const BlockPlane e2 = t.edges[2];
  const BlockPlane z = t.inverseZ;
  const float in0 = t.inside[0];
  const float in1 = t.inside[1];
  const float in2 = t.inside[2];
  for (int row = down.first; row <= down.last; ++row) {
    const auto start = static_cast<size_t>(row * columns);
    const float* x = x_.data() + start;
    const float* y = y_.data() + start;
    float* nearest = nearest_.data() + start;
    uint32_t* which = which_.data() + start;
    for (int i = across.first; i <= across.last; ++i) {
      const float inverseZ = z.at(x[i], y[i]);
      const float at0 = e0.at(x[i], y[i]);
      const float at1 = e1.at(x[i], y[i]);
      const float at2 = e2.at(x[i], y[i]);
      const bool wins = (at0 >= in0) & (at1 >= in1) & (at2 >= in2) & (inverseZ > nearest[i]);
      nearest[i] = wins ? inverseZ : nearest[i];
      which[i] = wins ? index : which[i];
    }
  }
}

glm::vec3 PixelSamples::mean(std::span<const AntialiasTriangle* const> triangles, const PixelRule& rule,
                             const Mesh& mesh, const glm::vec3& background) {
  const size_t count = x_.size();
  nearest_.assign(count, 0);
  which_.assign(count, 0);
  for (size_t i = 0; i < triangles.size(); ++i) {
    draw(*triangles[i], static_cast<uint32_t>(i + 1));
  }
  seen_.assign(triangles.size() + 1, {});
  for (size_t i = 0; i < count;) {
    const uint32_t which = which_[i];
    Seen run;
    for (; i < count && which_[i] == which; ++i) {
      run.samples += 1;
      run.x += x_[i];
      run.y += y_[i];
    }
    Seen& all = seen_[which];
    all.samples += run.samples;
    all.x += run.x;
    all.y += run.y;
  }
  glm::vec3 sum = background * seen_[0].samples;
  for (size_t i = 0; i < triangles.size(); ++i) {
    const Seen& seen = seen_[i + 1];
    if (seen.samples > 0) {
      // Colours are linear over a triangle but for its perspective within one pixel: their mean is that at the mean.
      const glm::vec2 at = rule.shadesAtMiddle ? middle_ : glm::vec2(seen.x, seen.y) / seen.samples;
      sum += triangles[i]->colorAt(at.x, at.y, mesh) * seen.samples;
    }
  }
  return sum / static_cast<float>(count);
}

}  // namespace ocelli
