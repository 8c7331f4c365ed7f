#include "oc_core/constructor/walk_fans.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <numeric>

namespace ocelli {
namespace {

/// Exits that add less than this to those before them, radians, are left out.
constexpr double kMinAngle = 1e-9;
/// Walls between exits that are narrower than this, in widths of the entry, are none: posts, and the ends of walls.
constexpr double kMinWall = 0.12;
/// How far ahead of the entry the ray to the edge of an exit runs at least, in its widths.
constexpr double kMinAhead = 0.01;
/// Viewpoints lie at most so many widths of the entry before it.
constexpr double kFarthest = 100;
/// A fan whose strip is narrower than this, in widths of the entry, has no rays.
constexpr double kMinStrip = 1e-7;
/// Sweeps over the rays until they are where their shares want them, or where others let them be.
constexpr int kSweeps = 60;
/// Fans spread by at least this more than they must.
constexpr double kMargin = 1e-3;

double slopeTo(double at, const glm::dvec2& point) {
  return (point.x - at) / point.y;
}

/// Rays between aims, which all run to points ahead of the entry: where they come in, when they come from one
/// viewpoint on the middle line that is so near that all come in.
std::vector<double> nearRays(const std::vector<glm::dvec2>& ends, double width) {
  double distance = width;
  for (const glm::dvec2& end : ends) {
    const double aside = std::abs(end.x - width / 2);
    if (aside > 0.45 * width) {
      distance = std::min(distance, 0.45 * width * end.y / (aside - 0.45 * width));
    }
  }
  std::vector<double> at;
  for (const glm::dvec2& end : ends) {
    at.push_back(width / 2 + (end.x - width / 2) * distance / (distance + end.y));
  }
  return at;
}

/// Where ray k may come in, given its neighbours: the fans to its left and right must spread.
std::pair<double, double> freedom(const std::vector<glm::dvec2>& ends, const std::vector<double>& at, size_t k,
                                  double width) {
  double least = k > 0 ? at[k - 1] : 0;
  double most = k + 1 < at.size() ? at[k + 1] : width;
  const double spread = (1 + kMargin) / (kFarthest * width);  // of slopes, per length of the strip
  const double z = ends[k].y;
  const double own = ends[k].x / z;
  if (k > 0) {
    most = std::min(most, (own - slopeTo(at[k - 1], ends[k - 1]) + at[k - 1] * spread) / (1 / z + spread));
  }
  if (k + 1 < at.size()) {
    least = std::max(least, (own - slopeTo(at[k + 1], ends[k + 1]) + at[k + 1] * spread) / (1 / z + spread));
  }
  return {least, most};
}

}  // namespace

std::vector<FanAim> aimsOf(const EntryFrame& frame, double width, const std::vector<WalkMouth>& exits) {
  struct Seen {
    int exit;
    glm::dvec2 begin;
    glm::dvec2 end;
    double angle;  // of its middle, from the left over the way ahead to the right
  };
  std::vector<Seen> seen;
  for (size_t i = 0; i < exits.size(); ++i) {
    const glm::dvec2 least(-std::numeric_limits<double>::infinity(), kMinAhead * width);
    const glm::dvec2 begin = glm::max(frame.inFrame(exits[i].left), least);
    const glm::dvec2 end = glm::max(frame.inFrame(exits[i].right), least);
    const glm::dvec2 middle = (begin + end) / 2.0;
    seen.push_back({static_cast<int>(i), begin, end, std::atan2(middle.y, width / 2 - middle.x)});
  }
  std::sort(seen.begin(), seen.end(), [](const Seen& a, const Seen& b) { return a.angle < b.angle; });
  std::vector<FanAim> aims;
  glm::dvec2 last(0);
  const auto addWall = [&](const glm::dvec2& until) {
    // It lies on the line of the entry, to its left or to its right.
    const bool beside =
        std::max(last.y, until.y) < 1.5 * kMinAhead * width && (until.x < 0.5 * width || last.x > 0.5 * width);
    if (glm::distance(last, until) > kMinWall * width && !beside) {
      aims.push_back({-1, last, until});
      last = until;
    }
  };
  const auto angleOf = [&](const glm::dvec2& point) { return std::atan2(point.y, width / 2 - point.x); };
  for (const Seen& each : seen) {
    // Of exits that overlap, the one more to the left has what both have.
    const double reached = aims.empty() ? -1.0 : angleOf(last);
    // What looks back towards the entry shows its back.
    if (!(angleOf(each.end) > std::max(reached, angleOf(each.begin)) + kMinAngle)) {
      continue;
    }
    if (angleOf(each.begin) > reached) {
      addWall(each.begin);
    }
    aims.push_back({each.exit, last, each.end});
    last = each.end;
  }
  const glm::dvec2 end(width, 0);
  addWall(end);
  if (aims.empty()) {
    aims.push_back({-1, glm::dvec2(0), end});
  }
  aims.back().end = end;
  return aims;
}

std::vector<FanRay> spreadRays(const std::vector<FanAim>& aims, double width) {
  std::vector<glm::dvec2> ends;  // of the rays between two fans
  std::vector<double> wanted;
  double sum = 0;
  for (const FanAim& aim : aims) {
    sum += aim.share;
  }
  double before = 0;
  for (size_t k = 0; k + 1 < aims.size(); ++k) {
    before += aims[k].share;
    ends.push_back(aims[k].end);
    wanted.push_back(sum > 0 ? width * before / sum
                             : width * static_cast<double>(k + 1) / static_cast<double>(aims.size()));
  }
  std::vector<double> at = nearRays(ends, width);
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (size_t step = 0; step < at.size(); ++step) {
      const size_t k = sweep % 2 == 0 ? step : at.size() - 1 - step;
      const auto [least, most] = freedom(ends, at, k, width);
      if (least < most) {
        at[k] = std::clamp(wanted[k], least, most);
      }
    }
  }
  std::vector<FanRay> rays{{0, 0}};
  for (size_t k = 0; k < at.size(); ++k) {
    rays.push_back({at[k], slopeTo(at[k], ends[k])});
  }
  rays.push_back({width, 0});
  // The first and the last ray are free: they follow from the distance of their viewpoints.
  const auto spreadOf = [&](size_t k, double strip) {
    return std::max(strip, kMinStrip * width) / std::clamp(aims[k].distance, width / kFarthest, width * kFarthest);
  };
  if (at.empty()) {
    rays.front().slope = -spreadOf(0, width) / 2;
    rays.back().slope = spreadOf(0, width) / 2;
  } else {
    rays.front().slope = rays[1].slope - spreadOf(0, rays[1].at);
    rays.back().slope = rays[rays.size() - 2].slope + spreadOf(aims.size() - 1, width - rays[rays.size() - 2].at);
  }
  return rays;
}

std::vector<FanRay> straightRays(const std::vector<FanAim>& aims, double width, const glm::dvec2& viewpoint) {
  const double before = -viewpoint.y;
  std::vector<FanRay> rays{{0, 0}};
  for (size_t k = 0; k + 1 < aims.size(); ++k) {
    const glm::dvec2& end = aims[k].end;
    const double at = viewpoint.x + (end.x - viewpoint.x) * before / (before + end.y);
    rays.push_back({std::clamp(at, rays.back().at, width), 0});
  }
  rays.push_back({width, 0});
  for (FanRay& ray : rays) {
    ray.slope = (ray.at - viewpoint.x) / before;
  }
  return rays;
}

std::vector<FanRay> mixedRays(const std::vector<FanRay>& from, const std::vector<FanRay>& to, double share) {
  std::vector<FanRay> rays;
  for (size_t k = 0; k < from.size(); ++k) {
    rays.push_back({glm::mix(from[k].at, to[k].at, share), glm::mix(from[k].slope, to[k].slope, share)});
  }
  return rays;
}

std::optional<glm::dvec2> fanViewpoint(const FanRay& left, const FanRay& right, double width) {
  const double strip = right.at - left.at;
  if (!(strip > kMinStrip * width)) {
    return std::nullopt;
  }
  const double spread = std::max(right.slope - left.slope, strip / (kFarthest * width));
  const double distance = strip / spread;
  // Where the middle rays meet, so that both sides share what rounding leaves.
  const double at = (left.at + right.at) / 2;
  const double slope = (left.slope + right.slope) / 2;
  return glm::dvec2(at - slope * distance, -distance);
}

}  // namespace ocelli
