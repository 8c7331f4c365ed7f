#include "oc_core/camera/epipolar_camera.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
/// Rays keep this far from the border of a disocclusion, so that the rounding of world coordinates does not put their
/// ends on the other side: an eye at 10 units rounds by 1e-6, which is 2e-4 pixels at the default view.
constexpr double kMarginPixels = 1e-3;

}  // namespace

EpipolarCamera::EpipolarCamera(const PinholeCamera& base, const glm::vec3& right,
                               const std::vector<std::vector<EpipolarEdge>>& rowEdges)
    : base_(base), lines_(base, right) {
  const int rows = lines_.rowCount();
  OC_CHECK(rowEdges.size() == static_cast<size_t>(rows), "one list of edges for each epipolar line");
  const double disparity = lines_.disparity();
  rowFirst_.reserve(static_cast<size_t>(rows) + 1);
  rowFirst_.push_back(0);
  for (int row = 0; row < rows; ++row) {
    int shift = 0;
    int last = 0;
    for (const EpipolarEdge& edge : rowEdges[static_cast<size_t>(row)]) {
      OC_CHECK(edge.position > last && edge.position <= lines_.length(row) && edge.clip >= 0 &&
                   edge.clip < edge.position && edge.added > 0,
               "edges come from left to right, and each adds columns for what it hides");
      last = edge.position;
      shift += edge.added;
      Disocclusion disocclusion{edge.position, std::max(edge.clip, edge.position - edge.added), edge.added, shift};
      const double x = lines_.x(row, edge.position);
      disocclusion.xRight = x - disparity * static_cast<double>(edge.inverseNear) * lines_.inverseZScale(x);
      OC_CHECK(lines_.has(row, edge.position + 0.5) && lines_.has(row, edge.position - edge.added),
               "an edge and its columns lie on their line");
      disocclusion.yFar = (lines_.x(row, edge.position - edge.added) - disocclusion.xRight) / disparity;
      disocclusions_.push_back(disocclusion);
    }
    rowFirst_.push_back(disocclusions_.size());
    width_ = std::max(width_, lines_.length(row) + shift);
  }
  if (int64_t{width_} * rows > PinholeCamera::kMaxPixels) {
    throw InputError("an image of " + std::to_string(width_) + "x" + std::to_string(rows) + " pixels cannot be made",
                     "view segment", "choose a shorter segment or a smaller image");
  }

  const auto stride = static_cast<size_t>(lines_.longest()) + 1;
  overFirst_.assign(static_cast<size_t>(rows) * stride + 1, 0);
  std::vector<std::vector<uint32_t>> over(stride);
  for (int row = 0; row < rows; ++row) {
    const std::span<const Disocclusion> edges = disocclusions(row);
    for (size_t i = edges.size(); i-- > 0;) {
      const auto last = static_cast<size_t>(edges[i].position);
      for (size_t j = static_cast<size_t>(edges[i].clip) + 1; j <= last; ++j) {
        if (over[j].empty() || edges[i].xRight < edges[over[j].back()].xRight) {
          over[j].push_back(static_cast<uint32_t>(i));
        }
      }
    }
    for (size_t j = 0; j < stride; ++j) {
      over_.insert(over_.end(), over[j].begin(), over[j].end());
      over[j].clear();
      overFirst_[static_cast<size_t>(row) * stride + j + 1] = static_cast<uint32_t>(over_.size());
    }
  }
}

std::span<const EpipolarCamera::Disocclusion> EpipolarCamera::disocclusions(int row) const {
  const auto i = static_cast<size_t>(row);
  return std::span(disocclusions_).subspan(rowFirst_[i], rowFirst_[i + 1] - rowFirst_[i]);
}

std::span<const uint32_t> EpipolarCamera::disocclusionsOver(int row, int cell) const {
  const size_t i = static_cast<size_t>(row) * (static_cast<size_t>(lines_.longest()) + 1) + static_cast<size_t>(cell);
  return std::span(over_).subspan(overFirst_[i], overFirst_[i + 1] - overFirst_[i]);
}

const EpipolarCamera::Disocclusion* EpipolarCamera::disocclusionOf(int row, int cell, double xRight) const {
  const std::span<const Disocclusion> edges = disocclusions(row);
  for (const uint32_t i : disocclusionsOver(row, cell)) {
    if (xRight > edges[i].xRight) {
      return &edges[i];
    }
  }
  return nullptr;
}

int EpipolarCamera::shiftAt(int row, double position) const {
  const std::span<const Disocclusion> edges = disocclusions(row);
  const auto after =
      std::upper_bound(edges.begin(), edges.end(), position,
                       [](double p, const Disocclusion& disocclusion) { return p < disocclusion.position; });
  return after == edges.begin() ? 0 : std::prev(after)->shift;
}

int EpipolarCamera::rowWidth(int row) const {
  const std::span<const Disocclusion> edges = disocclusions(row);
  return lines_.length(row) + (edges.empty() ? 0 : edges.back().shift);
}

ImagePoint EpipolarCamera::basePoint(double row, double x, double y) const {
  const glm::dvec2 p = lines_.imagePoint({row, lines_.position(lines_.rowOf(row), x)});
  const double z = std::clamp<double>(lines_.inverseZScale(x) / y, base_.view().zNear, base_.view().zFar);
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(z)};
}

std::optional<ImagePoint> EpipolarCamera::project(const glm::vec3& worldPoint) const {
  const std::optional<ImagePoint> q = base_.project(worldPoint);
  if (!q) {
    return std::nullopt;
  }
  const EpipolarLines::Place place = lines_.place({q->u, q->v});
  const int row = lines_.rowOf(place.row);
  double column = place.position;
  if (place.position >= lines_.length(row)) {
    column += width_ - lines_.length(row);  // beyond the base image: beyond this one
  } else if (place.position >= 0) {
    const double x = lines_.x(row, place.position);
    const double y = lines_.inverseZScale(x) / static_cast<double>(q->t);
    const Disocclusion* disocclusion = disocclusionOf(row, cellOf(place.position), x - lines_.disparity() * y);
    if (disocclusion != nullptr && (y >= disocclusion->yFar || place.position < disocclusion->position)) {
      const double xFar = x - lines_.disparity() * std::max(0.0, y - disocclusion->yFar);
      column = lines_.position(row, xFar) + disocclusion->shift;
    } else {
      column += shiftAt(row, place.position);
    }
  }
  return ImagePoint{static_cast<float>(column), static_cast<float>(place.row), q->t};
}

EpipolarCamera::PlaneRay EpipolarCamera::straightRay(int row, double position) const {
  PlaneRay ray{lines_.x(row, position), kNever, kNever, 0};
  if (position >= 0 && position < lines_.length(row)) {
    const std::span<const uint32_t> over = disocclusionsOver(row, cellOf(position));
    if (!over.empty()) {
      const double margin = lines_.x(row, position) - lines_.x(row, position - kMarginPixels);
      const Disocclusion& first = disocclusions(row)[over.back()];
      ray.yEnd = std::max(0.0, (ray.xFar - first.xRight + margin) / lines_.disparity());
    }
  }
  return ray;
}

std::optional<EpipolarCamera::PlaneRay> EpipolarCamera::bentRay(int row, const Disocclusion& disocclusion,
                                                                double position) const {
  const double disparity = lines_.disparity();
  PlaneRay ray{lines_.x(row, position), disocclusion.yFar, 0, 0};
  const double xRight = ray.xFar - disparity * disocclusion.yFar;
  // As a ray of R it runs from the edge to where the disocclusion is clipped, but for what is in the disocclusion of
  // another edge farther right: those disocclusions reach from beyond the edge to where they are clipped themselves.
  const std::span<const Disocclusion> edges = disocclusions(row);
  double from = cellBegin(disocclusion.position + 1);
  double minXRight = kNever;
  for (const Disocclusion* other = &disocclusion + 1; other != edges.data() + edges.size(); ++other) {
    if (other->xRight < xRight) {
      from = std::min(from, cellBegin(other->clip + 1));
    }
    if (cellBegin(other->clip + 1) <= position) {
      minXRight = std::min(minXRight, other->xRight);
    }
  }
  const double margin = ray.xFar - lines_.x(row, position - kMarginPixels);
  const double xStart = lines_.x(row, from) - margin;
  const double xClip = lines_.x(row, cellBegin(disocclusion.clip + 1)) + margin;
  if (xStart <= std::max(ray.xFar, xClip)) {
    return std::nullopt;
  }
  ray.yStart = disocclusion.yFar + (xStart - ray.xFar) / disparity;
  ray.yEnd = xClip - 2 * margin > ray.xFar ? disocclusion.yFar + (xClip - ray.xFar) / disparity
                                           : std::max(0.0, (ray.xFar - minXRight + margin) / disparity);
  return ray;
}

std::optional<EpipolarCamera::PlaneRay> EpipolarCamera::planeRay(int row, double column) const {
  const int surplus = width_ - lines_.length(row);
  if (column < 0 || column >= width_) {
    const double position = column < 0 ? column : column - surplus;
    return lines_.has(row, position) ? std::optional(straightRay(row, position)) : std::nullopt;
  }
  if (!(column < rowWidth(row))) {
    return std::nullopt;
  }
  // The last edge whose columns begin before this one.
  const std::span<const Disocclusion> edges = disocclusions(row);
  const auto after =
      std::upper_bound(edges.begin(), edges.end(), column, [](double c, const Disocclusion& disocclusion) {
        return c < disocclusion.position + disocclusion.shift - disocclusion.added;
      });
  if (after == edges.begin()) {
    return straightRay(row, column);
  }
  const Disocclusion& disocclusion = *std::prev(after);
  const double position = column - disocclusion.shift;
  return position < disocclusion.position ? bentRay(row, disocclusion, position)
                                          : std::optional(straightRay(row, position));
}

std::optional<glm::vec3> EpipolarCamera::unproject(const ImagePoint& q) const {
  if (!base_.unproject(q)) {  // not finite, or out of the depth range
    return std::nullopt;
  }
  const int row = lines_.rowOf(q.v);
  const std::optional<PlaneRay> ray = planeRay(row, q.u);
  if (!ray) {
    return std::nullopt;
  }
  const double w = 1.0 / static_cast<double>(q.t);
  double x = ray->xFar;
  double y = w * lines_.inverseZScale(x);
  if (y > ray->yFar) {
    // x = xFar + D (y - yFar) and y = w (parallel), w x or -w x.
    const double xRight = ray->xFar - lines_.disparity() * ray->yFar;
    const double slope = lines_.isParallel() ? 0 : w * lines_.disparity() * (lines_.advance() > 0 ? 1 : -1);
    x = lines_.isParallel() ? xRight + lines_.disparity() * w : xRight / (1 - slope);
    y = w * lines_.inverseZScale(x);
    if (!(slope < 1)) {
      return std::nullopt;  // behind R
    }
  }
  if (!(y < ray->yStart && y > ray->yEnd)) {
    return std::nullopt;
  }
  const glm::dvec2 p = lines_.imagePoint({q.v, lines_.position(row, x)});
  return base_.unproject({static_cast<float>(p.x), static_cast<float>(p.y), q.t});
}

RayPath EpipolarCamera::rayPath(const glm::vec2& pixel) const {
  if (!std::isfinite(pixel.x) || !std::isfinite(pixel.y)) {
    return {};
  }
  const int row = lines_.rowOf(pixel.y);
  const std::optional<PlaneRay> ray = planeRay(row, pixel.x);
  if (!ray) {
    return {};
  }
  RayPath path;
  const auto add = [&](double x, double y) {
    const ImagePoint q = basePoint(pixel.y, x, y);
    if (const std::optional<glm::vec3> point = base_.unproject(q)) {
      path.add(*point, q.t);
    }
  };
  const double disparity = lines_.disparity();
  add(ray->yStart == kNever ? ray->xFar : ray->xFar + disparity * (ray->yStart - ray->yFar), ray->yStart);
  if (ray->yEnd < ray->yFar && ray->yFar != kNever) {
    add(ray->xFar, ray->yFar);
  }
  add(ray->xFar + disparity * std::max(0.0, ray->yEnd - ray->yFar), ray->yEnd);
  return path;
}

}  // namespace ocelli
