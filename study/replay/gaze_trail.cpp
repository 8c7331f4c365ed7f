#include "study/replay/gaze_trail.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace ocelli {
namespace {

constexpr double kDarkEdge = 1.5;  ///< around what is white

/// Pixels from a segment.
double distanceTo(const glm::dvec2& point, const glm::dvec2& from, const glm::dvec2& to) {
  const glm::dvec2 way = to - from;
  const double length = glm::dot(way, way);
  const double share = length > 0 ? glm::clamp(glm::dot(point - from, way) / length, 0.0, 1.0) : 0.0;
  return glm::distance(point, from + way * share);
}

/// Draws all that `distance` says is near: white within `half` pixels of it, dark at its edge. Its box is given.
template <class Distance>
void drawNear(Image<Rgb8>& image, glm::dvec2 lower, glm::dvec2 upper, double half, double unit,
              const Distance& distance) {
  const double edge = kDarkEdge * unit;
  const double reach = half + edge + 1;
  const auto within = [](double value, int size) {
    return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(size)));
  };
  const int right = within(std::ceil(upper.x + reach), image.width());
  const int bottom = within(std::ceil(upper.y + reach), image.height());
  for (int y = within(std::floor(lower.y - reach), image.height()); y < bottom; ++y) {
    for (int x = within(std::floor(lower.x - reach), image.width()); x < right; ++x) {
      const double away = distance(glm::dvec2(x + 0.5, y + 0.5));
      const double white = std::clamp(half + 0.5 - away, 0.0, 1.0);
      const double dark = std::clamp(half + edge + 0.5 - away, 0.0, 1.0);
      Rgb8& pixel = image(x, y);
      for (int channel = 0; channel < 3; ++channel) {
        const double value = pixel[channel] * (1 - dark) * (1 - white) + 255 * white;
        pixel[channel] = static_cast<uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
      }
    }
  }
}

}  // namespace

std::vector<GazeMark> gazeTrail(std::span<const GazeRecord> samples, int64_t nanoseconds) {
  const auto end = std::ranges::upper_bound(samples, nanoseconds, {}, &GazeRecord::nanoseconds);
  std::vector<GazeMark> marks;
  for (auto sample = end; sample != samples.begin();) {
    --sample;
    const double age = static_cast<double>(nanoseconds - sample->nanoseconds) * 1e-9 / kTrailSeconds;
    if (age > 1 || (marks.empty() && !sample->valid)) {
      break;
    }
    if (sample->valid) {
      marks.push_back({{sample->x, sample->y}, age, true});
    } else {
      marks.back().joined = false;
    }
  }
  if (!marks.empty()) {
    marks.back().joined = false;  // the oldest
  }
  std::ranges::reverse(marks);
  return marks;
}

void drawGaze(Image<Rgb8>& image, std::span<const GazeMark> marks) {
  const double unit = gazeUnit(image.width());
  for (size_t i = 1; i < marks.size(); ++i) {
    if (!marks[i].joined) {
      continue;
    }
    const glm::dvec2 from = marks[i - 1].place;
    const glm::dvec2 to = marks[i].place;
    drawNear(image, glm::min(from, to), glm::max(from, to), unit * (1.5 - marks[i].age), unit,
             [&](const glm::dvec2& at) { return distanceTo(at, from, to); });
  }
  if (!marks.empty()) {
    const glm::dvec2 middle = marks.back().place;
    const double radius = kGazeRadius * unit;
    drawNear(image, middle - radius, middle + radius, 1.5 * unit, unit,
             [&](const glm::dvec2& at) { return std::abs(glm::distance(at, middle) - radius); });
  }
}

}  // namespace ocelli
