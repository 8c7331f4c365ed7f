#include "oc_core/relief/height_field_relief.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ocelli {
namespace {

/// The four pixels around a place, and how much each counts.
struct FourPixels {
  std::array<size_t, 4> index;
  std::array<float, 4> weight;
  size_t nearest = 0;
};

template <class T>
FourPixels pixelsAround(const Image<T>& image, float u, float v) {
  const auto least = [](float value, int count) {
    return std::clamp(value - 0.5f, 0.0f, static_cast<float>(count - 1));
  };
  const float x = least(u, image.width());
  const float y = least(v, image.height());
  const int left = static_cast<int>(x);
  const int top = static_cast<int>(y);
  const int right = std::min(left + 1, image.width() - 1);
  const int bottom = std::min(top + 1, image.height() - 1);
  const float a = x - static_cast<float>(left);
  const float b = y - static_cast<float>(top);
  FourPixels four{
      {image.index(left, top), image.index(right, top), image.index(left, bottom), image.index(right, bottom)},
      {(1 - a) * (1 - b), a * (1 - b), (1 - a) * b, a * b},
      0};
  four.nearest = four.index[(a > 0.5f ? 1 : 0) + (b > 0.5f ? 2 : 0)];
  return four;
}

}  // namespace

HeightFieldRelief::HeightFieldRelief(OrthographicLayers layers, const ReliefSearch& search)
    : layers_(std::move(layers)), search_(search) {
  for (const uint8_t count : layers_.counts) {
    samples_ += count;
  }
  if (samples_ > 0) {
    bounds_ = layers_.box;
    const glm::vec3 size = bounds_.size();
    texelSize_ = std::max(size.x / static_cast<float>(layers_.width), size.z / static_cast<float>(layers_.height));
  }
}

size_t HeightFieldRelief::texels() const {
  return layers_.counts.size() * layers_.layers();
}

HeightFieldRelief::Inside HeightFieldRelief::insideAt(const glm::vec3& pixels) const {
  const FourPixels four = pixelsAround(layers_.counts, pixels.x, pixels.y);
  // Interpolated where all four have the layer, or where it is the only one: texture units know no better.
  const bool single = layers_.layers() == 1;
  Inside result;
  for (size_t layer = 0; layer < layers_.layers(); ++layer) {
    const Image<float>& heights = layers_.heights[layer];
    bool all = true;
    for (const size_t i : four.index) {
      all = all && layers_.counts[i] > layer;
    }
    if (!single && layers_.counts[four.nearest] <= layer) {
      break;
    }
    float height = heights[four.nearest];
    if (single || all) {
      height = 0;
      for (size_t i = 0; i < 4; ++i) {
        height += heights[four.index[i]] * four.weight[i];
      }
    }
    if (height < pixels.z) {
      break;
    }
    result.inside = !result.inside;
    result.layer = static_cast<uint32_t>(layer);
  }
  return result;
}

std::optional<TriangleMeeting> HeightFieldRelief::search(const StraightRay& ray, const ReliefSearch& how,
                                                         RayCost& cost) const {
  if (bounds_.empty()) {
    return std::nullopt;
  }
  const glm::dvec3 origin(ray.origin);
  const double reach = static_cast<double>(ray.reach);
  const auto part = partWithin(bounds_, origin, origin + glm::dvec3(ray.step) * reach);
  if (!part) {
    return std::nullopt;
  }
  // A map from shares to pixels is linear.
  const auto first = static_cast<float>(part->first * reach);
  const auto last = static_cast<float>(part->last * reach);
  const glm::vec3 from = layers_.pixelsOf(ray.origin + ray.step * first);
  const glm::vec3 way = layers_.pixelsOf(ray.origin + ray.step * last) - from;
  float before = 0;
  for (int k = 0; k <= how.linearSteps; ++k) {
    float at = static_cast<float>(k) / static_cast<float>(how.linearSteps);
    ++cost.nodes;
    Inside found = insideAt(from + way * at);
    if (!found.inside) {
      before = at;
      continue;
    }
    for (int i = 0; i < how.halvings && k > 0; ++i) {
      const float middle = (before + at) / 2;
      ++cost.cells;
      const Inside between = insideAt(from + way * middle);
      if (between.inside) {
        at = middle;
        found = between;
      } else {
        before = middle;
      }
    }
    const glm::vec3 place = from + way * at;
    const FourPixels four = pixelsAround(layers_.counts, place.x, place.y);
    if (std::none_of(four.index.begin(), four.index.end(), [&](size_t i) { return layers_.counts[i] > 0; })) {
      return std::nullopt;  // the bottom, where there is no object
    }
    TriangleMeeting meeting;
    meeting.share = static_cast<double>(first + (last - first) * at);
    meeting.triangle = found.layer;
    meeting.b1 = place.x / static_cast<float>(layers_.width);
    meeting.b2 = place.y / static_cast<float>(layers_.height);
    return meeting;
  }
  return std::nullopt;
}

std::optional<TriangleMeeting> HeightFieldRelief::meet(const StraightRay& ray, RayCost& cost) const {
  return search(ray, search_, cost);
}

std::optional<TriangleMeeting> HeightFieldRelief::meetSlowly(const StraightRay& ray) const {
  RayCost ignored;
  constexpr int kMore = 64;
  constexpr int kHalvings = 23;
  return search(ray, {search_.linearSteps * kMore, kHalvings}, ignored);
}

/// Of the pixels around that have the layer, weighted.
ReliefSurface HeightFieldRelief::surfaceAt(const TriangleMeeting& meeting) const {
  const FourPixels four = pixelsAround(layers_.counts, meeting.b1 * static_cast<float>(layers_.width),
                                       meeting.b2 * static_cast<float>(layers_.height));
  ReliefSurface sum;
  float weights = 0;
  for (size_t i = 0; i < 4; ++i) {
    if (layers_.counts[four.index[i]] > meeting.triangle) {
      const ReliefSurface& surface = layers_.surfaces[meeting.triangle][four.index[i]];
      const float weight = four.weight[i] + 1e-6f;
      sum.color += surface.color * weight;
      sum.normal += surface.normal * weight;
      weights += weight;
    }
  }
  return weights > 0 ? ReliefSurface{sum.color / weights, sum.normal} : ReliefSurface{glm::vec3(0), {0, 1, 0}};
}

}  // namespace ocelli
