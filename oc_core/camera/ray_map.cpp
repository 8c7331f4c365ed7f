#include "oc_core/camera/ray_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/base/finite.h"
#include "oc_core/base/parallel.h"
#include "oc_core/camera/pinhole_camera.h"

namespace ocelli {
namespace {

constexpr const char* kMapNext = "give one origin and one direction for each pixel, and 0 for pixels without a ray";

void requireMapSize(const glm::ivec2& size, const std::string& where) {
  if (size.x < 1 || size.y < 1 || size.x > PinholeCamera::kMaxPixelsASide || size.y > PinholeCamera::kMaxPixelsASide ||
      int64_t{size.x} * size.y > PinholeCamera::kMaxPixels) {
    throw InputError(fmt::format("a ray map of {}x{} pixels", size.x, size.y), where,
                     "give it a size from 1x1 to 32768 a side, of at most 2^26 pixels");
  }
}

}  // namespace

const char* nameOf(RayFrame frame) {
  switch (frame) {
    case RayFrame::kWorld:
      return "world";
    case RayFrame::kView:
      return "view";
  }
  OC_CHECK(false, "every frame has a name");
}

RayPath RayMapRay::path() const {
  RayPath path;
  for (size_t i = 0; i < points.size(); ++i) {
    path.add(points[i], parameters[i]);
  }
  return path;
}

RayMap RayMap::ofStraightRays(const glm::ivec2& size, std::span<const glm::vec3> origins,
                              std::span<const glm::vec3> directions, float near, float far, RayMapNotes notes,
                              const std::string& where) {
  requireMapSize(size, where);
  const size_t pixels = static_cast<size_t>(size.x) * static_cast<size_t>(size.y);
  if (origins.size() != pixels || directions.size() != pixels) {
    throw InputError(
        fmt::format("{} origins and {} directions for {}x{} pixels", origins.size(), directions.size(), size.x, size.y),
        where, kMapNext);
  }
  if (!(near >= 0) || !(far > near) || !std::isfinite(far)) {
    throw InputError(fmt::format("rays from {} to {}", near, far), where, "begin at 0 or farther, and end behind that");
  }
  std::vector<size_t> ends;
  std::vector<glm::vec3> points;
  ends.reserve(pixels);
  for (size_t i = 0; i < pixels; ++i) {
    const double length = glm::length(glm::dvec3(directions[i]));
    if (isFinite(origins[i]) && std::isfinite(length) && length > 0) {
      const glm::dvec3 along = glm::dvec3(directions[i]) / length;
      points.emplace_back(glm::dvec3(origins[i]) + along * static_cast<double>(near));
      points.emplace_back(glm::dvec3(origins[i]) + along * static_cast<double>(far));
    }
    ends.push_back(points.size());
  }
  std::vector<float> parameters(points.size());
  for (size_t i = 0; i < parameters.size(); ++i) {
    parameters[i] = i % 2 == 0 ? near : far;
  }
  return ofPolylines(size, std::move(ends), std::move(points), std::move(parameters), std::move(notes), where);
}

RayMap RayMap::ofCamera(const glm::ivec2& size, const std::function<RayPath(const glm::vec2&)>& ray, RayMapNotes notes,
                        const std::string& where, const Progress& progress) {
  requireMapSize(size, where);
  struct Row {
    std::vector<size_t> counts;
    std::vector<glm::vec3> points;
    std::vector<float> parameters;
  };
  std::vector<Row> rows(static_cast<size_t>(size.y));
  std::atomic<size_t> done = 0;
  parallelFor(rows.size(), 1, [&](size_t begin, size_t end) {
    for (size_t y = begin; y < end; ++y) {
      Row& row = rows[y];
      for (int x = 0; x < size.x; ++x) {
        const RayPath path = ray({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
        const size_t first = row.points.size();
        for (size_t i = 0; i < path.size(); ++i) {
          // Bends that are closer than parameters are rounded are one.
          if (i == 0 || path.t(i) > row.parameters.back()) {
            row.points.push_back(path[i]);
            row.parameters.push_back(path.t(i));
          }
        }
        if (row.points.size() == first + 1) {
          row.points.pop_back();
          row.parameters.pop_back();
        }
        row.counts.push_back(row.points.size() - first);
      }
      report(progress, "rays", static_cast<double>(++done) / static_cast<double>(rows.size()));
    }
  });
  std::vector<size_t> ends;
  std::vector<glm::vec3> points;
  std::vector<float> parameters;
  ends.reserve(static_cast<size_t>(size.x) * rows.size());
  for (Row& row : rows) {
    for (const size_t count : row.counts) {
      ends.push_back((ends.empty() ? 0 : ends.back()) + count);
    }
    points.insert(points.end(), row.points.begin(), row.points.end());
    parameters.insert(parameters.end(), row.parameters.begin(), row.parameters.end());
    row = {};
  }
  return ofPolylines(size, std::move(ends), std::move(points), std::move(parameters), std::move(notes), where);
}

RayMap RayMap::ofPolylines(const glm::ivec2& size, std::vector<size_t> ends, std::vector<glm::vec3> points,
                           std::vector<float> parameters, RayMapNotes notes, const std::string& where) {
  requireMapSize(size, where);
  const size_t pixels = static_cast<size_t>(size.x) * static_cast<size_t>(size.y);
  if (ends.size() != pixels || ends.back() != points.size() || parameters.size() != points.size()) {
    throw InputError(fmt::format("{} ends, {} points and {} parameters of rays for {}x{} pixels", ends.size(),
                                 points.size(), parameters.size(), size.x, size.y),
                     where, "give the end of each pixel's points, and a parameter for each point");
  }
  RayMap map;
  size_t begin = 0;
  for (size_t i = 0; i < pixels; ++i) {
    const auto refuse = [&](const std::string& problem) {
      throw InputError(fmt::format("the ray of pixel ({}, {}) {}", i % static_cast<size_t>(size.x),
                                   i / static_cast<size_t>(size.x), problem),
                       where, "mend it, or leave the pixel without a ray");
    };
    const size_t end = ends[i];
    if (end < begin || end > points.size() || end - begin == 1 || end - begin > RayPath::kMaxPoints) {
      refuse(fmt::format("has not 0, or from 2 to {} points", RayPath::kMaxPoints));
    }
    for (size_t k = begin; k < end; ++k) {
      if (!isFinite(points[k]) || !std::isfinite(parameters[k])) {
        refuse("has a number that is not finite");
      }
      if (k > begin && !(parameters[k] > parameters[k - 1])) {
        refuse(fmt::format("has a parameter that does not grow, from {} to {}", parameters[k - 1], parameters[k]));
      }
    }
    map.rays_ += end > begin ? 1 : 0;
    map.maxPoints_ = std::max(map.maxPoints_, end - begin);
    begin = end;
  }
  if (map.rays_ == 0) {
    throw InputError("no pixel of the ray map has a ray", where,
                     "give finite origins, and directions that are finite and not 0");
  }
  map.size_ = size;
  map.ends_ = std::move(ends);
  map.points_ = std::move(points);
  map.parameters_ = std::move(parameters);
  map.notes_ = std::move(notes);
  return map;
}

RayMapRay RayMap::ray(int x, int y) const {
  const size_t i = static_cast<size_t>(y) * static_cast<size_t>(size_.x) + static_cast<size_t>(x);
  const size_t begin = i == 0 ? 0 : ends_[i - 1];
  const size_t count = ends_[i] - begin;
  return {std::span(points_).subspan(begin, count), std::span(parameters_).subspan(begin, count)};
}

RayMap RayMap::placedAt(const View& view) const {
  RayMap placed = *this;
  if (notes_.frame == RayFrame::kWorld) {
    return placed;
  }
  const glm::dvec3 eye(view.eye);
  const glm::dvec3 backward = glm::normalize(eye - glm::dvec3(view.target));
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(view.up), backward));
  const glm::dvec3 up = glm::cross(backward, right);
  for (glm::vec3& point : placed.points_) {
    const glm::dvec3 p(point);
    point = glm::vec3(eye + right * p.x + up * p.y + backward * p.z);
  }
  placed.notes_.frame = RayFrame::kWorld;
  placed.notes_.view = view;
  return placed;
}

RayMapFacts factsOf(const RayMap& map) {
  RayMapFacts facts{.rays = map.rayCount(), .segments = map.maxSegments()};
  bool first = true;
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      const RayMapRay ray = map.ray(x, y);
      if (ray.empty()) {
        continue;
      }
      facts.bent += ray.points.size() > 2 ? 1 : 0;
      const glm::vec3& origin = ray.points.front();
      facts.lower = first ? origin : glm::min(facts.lower, origin);
      facts.upper = first ? origin : glm::max(facts.upper, origin);
      facts.tMin = first ? ray.tMin() : std::min(facts.tMin, ray.tMin());
      facts.tMax = first ? ray.tMax() : std::max(facts.tMax, ray.tMax());
      first = false;
    }
  }
  return facts;
}

}  // namespace ocelli
