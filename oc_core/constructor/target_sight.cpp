#include "oc_core/constructor/target_sight.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <limits>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr int kPointsASide = 4;  // of the target's box
constexpr int kPiecesOfAnEdge = 4;

/// Evenly in the box, none on its faces: next to those rays pass the object by.
std::vector<glm::vec3> pointsOf(const Box& box) {
  std::vector<glm::vec3> points;
  for (int i = 0; i < kPointsASide * kPointsASide * kPointsASide; ++i) {
    const glm::ivec3 place(i % kPointsASide, i / kPointsASide % kPointsASide, i / (kPointsASide * kPointsASide));
    points.push_back(box.lower + box.size() * (glm::vec3(place) + 0.5f) / static_cast<float>(kPointsASide));
  }
  return points;
}

/// The ray path up to the place next to `point`, which it passes.
std::vector<glm::vec3> pathTo(const RayPath& path, const glm::vec3& point) {
  std::vector<glm::vec3> points(path.begin(), path.begin() + path.positionNear(point).segment + 1);
  points.push_back(point);
  return points;
}

bool meetsAny(const std::vector<glm::vec3>& path, std::span<const Box> boxes) {
  Box around;
  for (const glm::vec3& point : path) {
    around.add(point);
  }
  return std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) {
    if (box.empty() || glm::any(glm::lessThan(box.upper, around.lower)) ||
        glm::any(glm::lessThan(around.upper, box.lower))) {
      return false;
    }
    for (size_t i = 0; i + 1 < path.size(); ++i) {
      if (meets(box, path[i], path[i + 1])) {
        return true;
      }
    }
    return false;
  });
}

Box enlargedBy(const Box& box, double share) {
  const glm::vec3 margin = box.size() * static_cast<float>(share);
  return {box.lower - margin, box.upper + margin};
}

double shareByRays(const CurvedRayCamera& camera, std::span<const Box> occluders, const Box& target,
                   const TargetMargin& margin) {
  Box enlarged = enlargedBy(target, margin.share);
  const PinholeCamera& view = camera.root();
  const float depth = view.cameraFromWorld(target.center()).z;
  if (margin.pixels > 0 && depth > 0) {
    const glm::vec3 wider(depth / view.focalPixels() * static_cast<float>(margin.pixels));
    enlarged = {enlarged.lower - wider, enlarged.upper + wider};
  }
  return visibleShare(camera, occluders, enlarged);
}

struct Rectangle {
  glm::dvec2 lower{0};
  glm::dvec2 upper{0};

  double area() const { return std::max(0.0, upper.x - lower.x) * std::max(0.0, upper.y - lower.y); }
};

Rectangle commonOf(const Rectangle& a, const Rectangle& b) {
  return {glm::max(a.lower, b.lower), glm::min(a.upper, b.upper)};
}

/// Of the union: in strips between the sides of all rectangles, by the lengths that they cover there.
double coveredArea(const std::vector<Rectangle>& rectangles) {
  std::vector<double> sides;
  for (const Rectangle& each : rectangles) {
    sides.push_back(each.lower.x);
    sides.push_back(each.upper.x);
  }
  std::sort(sides.begin(), sides.end());
  double area = 0;
  for (size_t i = 0; i + 1 < sides.size(); ++i) {
    std::vector<std::pair<double, double>> lengths;
    for (const Rectangle& each : rectangles) {
      if (each.lower.x <= sides[i] && each.upper.x >= sides[i + 1]) {
        lengths.emplace_back(each.lower.y, each.upper.y);
      }
    }
    std::sort(lengths.begin(), lengths.end());
    double covered = 0;
    double end = -std::numeric_limits<double>::infinity();
    for (const auto& [from, to] : lengths) {
      covered += std::max(0.0, to - std::max(from, end));
      end = std::max(end, to);
    }
    area += covered * (sides[i + 1] - sides[i]);
  }
  return area;
}

double shareByImages(const CurvedRayCamera& camera, std::span<const Box> occluders, const Box& target,
                     const TargetMargin& margin) {
  const std::optional<BoxImage> image = imageOfBox(camera, enlargedBy(target, margin.share));
  const std::optional<ImagePoint> middle = camera.project(target.center());
  if (!image || !image->whole || !middle) {
    return 0;
  }
  const Rectangle wanted{image->lower - margin.pixels, image->upper + margin.pixels};
  std::vector<Rectangle> taken;
  for (const Box& box : occluders) {
    const std::optional<BoxImage> other = box.empty() ? std::nullopt : imageOfBox(camera, box);
    if (other && other->nearest < static_cast<double>(middle->t)) {
      const Rectangle both = commonOf(wanted, {other->lower, other->upper});
      if (both.area() > 0) {
        taken.push_back(both);
      }
    }
  }
  return std::clamp(1 - coveredArea(taken) / wanted.area(), 0.0, 1.0);
}

}  // namespace

const std::vector<TargetSight>& targetSights() {
  static const std::vector<TargetSight> sights{
      {"rays", "by rays to points of the target's box", shareByRays},
      {"images", "by rectangles around the images of the boxes", shareByImages},
  };
  return sights;
}

const TargetSight& targetSight(const std::string& name) {
  std::string names;
  for (const TargetSight& sight : targetSights()) {
    if (sight.name == name) {
      return sight;
    }
    names += names.empty() ? sight.name : std::string(" or ") + sight.name;
  }
  throw InputError("targets are not looked for by \"" + name + "\"", "target camera, \"sight\"", "use " + names);
}

double visibleShare(const CurvedRayCamera& camera, std::span<const Box> occluders, const Box& target) {
  const std::vector<glm::vec3> points = pointsOf(target);
  size_t visible = 0;
  for (const glm::vec3& point : points) {
    const std::optional<ImagePoint> image = camera.project(point);
    if (!image || !(image->u >= 0 && image->v >= 0 && image->u <= static_cast<float>(camera.width()) &&
                    image->v <= static_cast<float>(camera.height()))) {
      continue;
    }
    if (!meetsAny(pathTo(camera.rayPath({image->u, image->v}), point), occluders)) {
      ++visible;
    }
  }
  return static_cast<double>(visible) / static_cast<double>(points.size());
}

std::optional<BoxImage> imageOfBox(const CurvedRayCamera& camera, const Box& box) {
  BoxImage image;
  image.lower = glm::dvec2(std::numeric_limits<double>::infinity());
  image.upper = -image.lower;
  image.nearest = std::numeric_limits<double>::infinity();
  image.whole = true;
  bool any = false;
  // An edge from each corner along each axis; those that begin at the upper side are left out.
  for (int corner = 0; corner < 8; ++corner) {
    for (int axis = 0; axis < 3; ++axis) {
      if ((corner >> axis & 1) != 0) {
        continue;
      }
      for (int piece = 0; piece <= kPiecesOfAnEdge; ++piece) {
        glm::vec3 place(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
        place[axis] = static_cast<float>(piece) / kPiecesOfAnEdge;
        const std::optional<ImagePoint> point = camera.project(box.lower + box.size() * place);
        if (!point) {
          image.whole = false;
          continue;
        }
        const glm::dvec2 at(point->u, point->v);
        image.whole = image.whole && at.x >= 0 && at.y >= 0 && at.x <= camera.width() && at.y <= camera.height();
        image.lower = glm::min(image.lower, at);
        image.upper = glm::max(image.upper, at);
        image.nearest = std::min(image.nearest, static_cast<double>(point->t));
        any = true;
      }
    }
  }
  return any ? std::optional(image) : std::nullopt;
}

}  // namespace ocelli
