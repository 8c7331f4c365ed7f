#include "oc_core/depth_rays/stepped_image.h"

#include <algorithm>
#include <cmath>

namespace ocelli {

SteppedImage::SteppedImage(const ReferenceImage& image, const CameraMap& map, const SteppingOptions& options)
    : image_(image), map_(map), options_(options), pinhole_(image.reference()) {
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (const auto point = image.pointOf(x, y, pinhole_)) {
        bounds_.add(*point);
      }
    }
  }
  if (!bounds_.empty()) {
    // A ray crosses a plane of samples within bounds that have a depth, even where the plane itself has none.
    constexpr float kMarginFootprints = 2;
    const float farthest = glm::distance(pinhole_.eye(), bounds_.center()) + glm::length(bounds_.size()) / 2;
    const float margin = kMarginFootprints * farthest / pinhole_.focalPixels();
    bounds_.lower -= margin;
    bounds_.upper += margin;
  }
}

SteppedImage::Probe SteppedImage::probe(const StraightRay& ray, double share) const {
  Probe probe{.share = share};
  const auto q = map_.project(ray.origin + ray.step * static_cast<float>(share));
  if (!q || !(q->t > 0)) {
    return probe;
  }
  probe.projects = true;
  probe.place = {static_cast<double>(q->u), static_cast<double>(q->v)};
  probe.inverse = 1 / static_cast<double>(q->t);
  const double x = std::floor(probe.place.x);
  const double y = std::floor(probe.place.y);
  if (x >= 0 && y >= 0 && x < image_.width() && y < image_.height() &&
      image_.holds(static_cast<int>(x), static_cast<int>(y))) {
    const float t = image_.t(static_cast<int>(x), static_cast<int>(y));
    probe.shownInverse = t > 0 ? std::optional(1 / static_cast<double>(t)) : std::nullopt;
  }
  return probe;
}

std::optional<SteppedImage::Meeting> SteppedImage::meet(const StraightRay& ray, RayCost& cost) const {
  if (bounds_.empty()) {
    return std::nullopt;
  }
  const glm::dvec3 origin(ray.origin);
  const auto part = partWithin(bounds_, origin, origin + glm::dvec3(ray.step) * static_cast<double>(ray.reach));
  if (!part) {
    return std::nullopt;
  }
  const double reach = static_cast<double>(ray.reach);
  return meetWithin(ray, probe(ray, part->first * reach), probe(ray, part->last * reach), 0, cost);
}

/// Halves of a piece from near to far, so that the first crossing is the first hit.
std::optional<SteppedImage::Meeting> SteppedImage::meetWithin(const StraightRay& ray, const Probe& a, const Probe& b,
                                                              int halvings, RayCost& cost) const {
  const bool both = a.projects && b.projects;
  const double length = both ? glm::distance(a.place, b.place) : options_.coarsePixels * 2;
  const bool ends = halvings >= kMaxHalvings;
  if (!ends && (halvings < kAlwaysHalved || length > options_.coarsePixels)) {
    if (!a.projects && !b.projects && halvings >= kUnseenHalvings) {
      return std::nullopt;
    }
    const Probe middle = probe(ray, (a.share + b.share) / 2);
    if (const auto first = meetWithin(ray, a, middle, halvings + 1, cost)) {
      return first;
    }
    return meetWithin(ray, middle, b, halvings + 1, cost);
  }
  if (!both) {
    return std::nullopt;
  }
  if (length > options_.finePixels && !ends) {
    ++cost.nodes;
    if (!a.shownInverse && !b.shownInverse) {
      return std::nullopt;
    }
    if (a.shownInverse && b.shownInverse) {
      const double gapA = *a.shownInverse - a.inverse;
      const double gapB = *b.shownInverse - b.inverse;
      const double moves = kClearly * (std::abs(a.inverse - b.inverse) + std::abs(*a.shownInverse - *b.shownInverse));
      if (gapA * gapB > 0 && std::min(std::abs(gapA), std::abs(gapB)) > moves) {
        return std::nullopt;
      }
    }
    const Probe middle = probe(ray, (a.share + b.share) / 2);
    if (const auto first = meetWithin(ray, a, middle, halvings + 1, cost)) {
      return first;
    }
    return meetWithin(ray, middle, b, halvings + 1, cost);
  }
  ++cost.cells;
  return crossing(ray, a, b);
}

std::optional<SteppedImage::Meeting> SteppedImage::crossing(const StraightRay& ray, const Probe& a,
                                                            const Probe& b) const {
  if (!a.shownInverse || !b.shownInverse) {
    return std::nullopt;
  }
  const double gapA = *a.shownInverse - a.inverse;
  const double gapB = *b.shownInverse - b.inverse;
  if (!(gapA * gapB <= 0) || gapA == gapB) {
    return std::nullopt;
  }
  const double nearer = 1 / std::max(*a.shownInverse, *b.shownInverse);
  const double footprint = nearer / static_cast<double>(pinhole_.focalPixels());
  const double step = std::max(glm::distance(a.place, b.place), 1.0);
  if (std::abs(1 / *a.shownInverse - 1 / *b.shownInverse) > options_.joinFootprints * footprint * std::min(step, 1.5)) {
    return std::nullopt;  // the gap between two surfaces
  }
  const double between = gapA / (gapA - gapB);
  Meeting meeting;
  meeting.share = a.share + (b.share - a.share) * between;
  if (meeting.share > static_cast<double>(ray.reach)) {
    return std::nullopt;
  }
  meeting.place = a.place + (b.place - a.place) * between;
  meeting.opacity =
      opacityOf(static_cast<int>(std::floor(meeting.place.x)), static_cast<int>(std::floor(meeting.place.y)));
  return meeting;
}

/// From the points of a pixel and its neighbours to the right and below.
double SteppedImage::opacityOf(int x, int y) const {
  const auto point = [&](int column, int row) {
    return image_.t.contains(column, row) ? image_.pointOf(column, row, pinhole_) : std::nullopt;
  };
  const auto middle = point(x, y);
  const auto right = point(x + 1, y) ? point(x + 1, y) : point(x - 1, y);
  const auto down = point(x, y + 1) ? point(x, y + 1) : point(x, y - 1);
  const RayPath ray = map_.ray({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
  if (!middle || !right || !down || ray.size() < 2) {
    return 1;
  }
  const glm::vec3 normal = glm::cross(*right - *middle, *down - *middle);
  const glm::vec3 way = ray.directionAt(ray.positionNear(*middle));
  const auto length = static_cast<double>(glm::length(normal));
  if (!(length > 0)) {
    return 1;
  }
  return std::min(1.0, std::abs(static_cast<double>(glm::dot(normal, way))) / length / options_.opaqueCosine);
}

}  // namespace ocelli
