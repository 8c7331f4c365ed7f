#include "oc_core/camera/graph_camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <limits>

#include "oc_core/base/error.h"
#include "oc_core/base/finite.h"
#include "oc_core/camera/ray_rounding.h"

namespace ocelli {
namespace {

/// What rays end at may come in single precision: the end of a ray still belongs to it.
constexpr double kLimitRounding = 1e-6;
/// Parts with less than this many square pixels hold no rays.
constexpr double kMinArea = 1e-6;

double cross(const glm::dvec2& a, const glm::dvec2& b) {
  return a.x * b.y - a.y * b.x;
}

double areaOf(const GraphCamera::Part& part) {
  double twice = 0;
  for (size_t i = 0; i < part.size(); ++i) {
    twice += cross(part[i], part[(i + 1) % part.size()]);
  }
  return twice / 2;
}

/// How far to the right of the edge a -> b, pixels: inside, for parts that run clockwise as seen.
double insideEdge(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& pixel) {
  return cross(b - a, pixel - a) / glm::length(b - a);
}

/// The least of these over all edges.
double inside(const GraphCamera::Part& part, const glm::dvec2& pixel) {
  double least = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < part.size(); ++i) {
    least = std::min(least, insideEdge(part[i], part[(i + 1) % part.size()], pixel));
  }
  return least;
}

bool isSound(const Plane& plane) {
  return std::abs(glm::length(plane.normal) - 1) < 1e-6 && std::isfinite(plane.distance);
}

GraphCamera::Part clippedTo(GraphCamera::Part part, const GraphCamera::Part& by) {
  for (size_t i = 0; i < by.size() && !part.empty(); ++i) {
    part = GraphCamera::cut(part, by[i], by[(i + 1) % by.size()]).first;
  }
  return part;
}

}  // namespace

GraphCamera::GraphCamera(const PinholeCamera& root) : root_(root) {
  const double width = root.width();
  const double height = root.height();
  const glm::dvec3 forward(root.forward());
  const glm::dvec3 eye(root.eye());
  Frustum frustum{"root",
                  -1,
                  eye,
                  Plane::through(eye + forward * static_cast<double>(root.view().zNear), forward),
                  {{0, 0}, {width, 0}, {width, height}, {0, height}}};
  frustum.pixelFromWorld = ocelli::pixelFromWorld(root);
  frusta_.push_back(frustum);
}

void GraphCamera::fail(const std::string& name, const std::string& what, const std::string& next) const {
  throw InputError(what, "graph camera, frustum \"" + name + "\"", next);
}

std::pair<GraphCamera::Part, GraphCamera::Part> GraphCamera::cut(const Part& part, const glm::dvec2& from,
                                                                 const glm::dvec2& to) {
  std::pair<Part, Part> halves;
  for (size_t i = 0; i < part.size(); ++i) {
    const glm::dvec2& a = part[i];
    const glm::dvec2& b = part[(i + 1) % part.size()];
    const double sideA = insideEdge(from, to, a);
    const double sideB = insideEdge(from, to, b);
    if (sideA >= 0) {
      halves.first.push_back(a);
    }
    if (sideA <= 0) {
      halves.second.push_back(a);
    }
    if ((sideA > 0 && sideB < 0) || (sideA < 0 && sideB > 0)) {
      const glm::dvec2 crossing = a + (b - a) * (sideA / (sideA - sideB));
      halves.first.push_back(crossing);
      halves.second.push_back(crossing);
    }
  }
  for (Part* half : {&halves.first, &halves.second}) {
    if (areaOf(*half) < kMinArea) {
      half->clear();
    }
  }
  return halves;
}

glm::dvec2 GraphCamera::middleOf(const Part& part) {
  glm::dvec2 middle(0);
  for (const glm::dvec2& corner : part) {
    middle += corner / static_cast<double>(part.size());
  }
  return middle;
}

int GraphCamera::bend(int i, const Bend& bend, const std::string& name, const Part& wanted) {
  OC_CHECK(i >= 0 && static_cast<size_t>(i) < frusta_.size(), "there is no such frustum");
  if (frusta_.size() >= kMaxFrusta) {
    fail(name, "there are more than " + std::to_string(kMaxFrusta) + " frusta", "build fewer");
  }
  size_t bends = 1;
  for (int k = i; k != kRoot; k = frusta_[static_cast<size_t>(k)].parent) {
    ++bends;
  }
  if (bends > kMaxBends) {
    fail(name, "its rays turn more than " + std::to_string(kMaxBends) + " times", "build fewer turns");
  }
  const Frustum& parent = frusta_[static_cast<size_t>(i)];
  const Part part = wanted.empty() ? parent.part : wanted;
  if (!isSound(bend.plane) || !std::isfinite(glm::length(bend.viewpoint))) {
    fail(name, "its plane or its viewpoint is not finite, or the normal has no length", "give finite numbers");
  }
  for (size_t k = 0; k < part.size(); ++k) {
    const glm::dvec2& next = part[(k + 1) % part.size()];
    if (!(inside(part, next) >= -kPixelRounding)) {  // NaN fails too
      fail(name, "its part of the image is not convex, or its corners do not run clockwise", "order its corners");
    }
    if (!(inside(parent.part, part[k]) >= -kPixelRounding)) {
      fail(name, "its part of the image is not within that of \"" + parent.name + "\"", "make it smaller");
    }
  }
  if (part.size() < 3 || !(areaOf(part) >= kMinArea)) {
    fail(name, "its part of the image is empty", "make it larger");
  }
  for (const int child : parent.children) {
    if (areaOf(clippedTo(part, frusta_[static_cast<size_t>(child)].part)) > kMinArea) {
      fail(name, "it takes rays that \"" + frusta_[static_cast<size_t>(child)].name + "\" has",
           "make parts that do not overlap");
    }
  }
  if (!(bend.plane.height(bend.viewpoint) < -kHeightRounding)) {
    fail(name, "its viewpoint does not lie before its plane",
         "move the viewpoint to the side that \"" + parent.name + "\" comes from");
  }
  // Each corner's ray crosses the plane after that of the parent, from before it, and before zFar.
  for (const glm::dvec2& corner : part) {
    const Segment ray = segmentIn(i, corner);
    const double along = glm::dot(bend.plane.normal, ray.direction);
    const double before = bend.plane.height(ray.from);
    if (!(along > 0 && before < -kHeightRounding && ray.t - before / along < root_.view().zFar)) {
      fail(name,
           "not every ray of \"" + parent.name + "\" in its part crosses its plane, from before it and before zFar",
           "turn the plane towards those rays, move it, or make the part smaller");
    }
  }
  Frustum frustum{name, i, bend.viewpoint, bend.plane, part};
  // Weights stay as they are on the plane, so that those of long chains do not overflow.
  frustum.pixelFromWorld =
      parent.pixelFromWorld * ontoPlane(bend.plane, bend.viewpoint) / -bend.plane.height(bend.viewpoint);
  const int index = static_cast<int>(frusta_.size());
  frusta_[static_cast<size_t>(i)].children.push_back(index);
  frusta_.push_back(std::move(frustum));
  return index;
}

std::pair<int, int> GraphCamera::split(int i, const Bend& one, const Bend& other, const std::string& oneName,
                                       const std::string& otherName) {
  OC_CHECK(i >= 0 && static_cast<size_t>(i) < frusta_.size(), "there is no such frustum");
  const Frustum& parent = frusta_[static_cast<size_t>(i)];
  // Two points of the line where the planes meet, as the frustum sees them.
  const glm::dvec3 along = glm::cross(one.plane.normal, other.plane.normal);
  if (!(glm::length(along) > 1e-9)) {
    fail(oneName, "its plane is parallel to that of \"" + otherName + "\"", "turn the planes to different sides");
  }
  const glm::dvec3 point = (glm::cross(other.plane.normal, along) * one.plane.distance +
                            glm::cross(along, one.plane.normal) * other.plane.distance) /
                           glm::dot(along, along);
  const auto image = [&](const glm::dvec4& p) { return parent.pixelFromWorld * p; };
  const glm::dvec4 a = image(glm::dvec4(point, 1));
  const glm::dvec4 b = image(glm::dvec4(glm::normalize(along), 0));
  // The line through both, in homogeneous coordinates: also where one of them is at infinity.
  const glm::dvec3 line = glm::cross(glm::dvec3(a.x, a.y, a.w), glm::dvec3(b.x, b.y, b.w));
  const glm::dvec2 normal(line.x, line.y);
  if (!(glm::length(normal) > 0)) {
    fail(oneName, "its plane meets that of \"" + otherName + "\" out of sight", "move the planes");
  }
  const glm::dvec2 nearest = -normal * (line.z / glm::dot(normal, normal));
  const glm::dvec2 direction(normal.y, -normal.x);
  auto [first, second] = cut(parent.part, nearest, nearest + direction);
  if (first.empty() || second.empty()) {
    fail(oneName, "its plane meets that of \"" + otherName + "\" out of the sight of \"" + parent.name + "\"",
         "move the planes until the line where they meet is in view, or bend instead");
  }
  // The plane that the rays of the first half cross first.
  const Segment ray = segmentIn(i, middleOf(first));
  const auto way = [&](const Plane& plane) {
    const double advance = -plane.height(ray.from) / glm::dot(plane.normal, ray.direction);
    return advance > 0 ? advance : std::numeric_limits<double>::infinity();
  };
  if (way(other.plane) < way(one.plane)) {
    std::swap(first, second);
  }
  // Both or none.
  GraphCamera changed = *this;
  const int a1 = changed.bend(i, one, oneName, first);
  const int a2 = changed.bend(i, other, otherName, second);
  *this = std::move(changed);
  return {a1, a2};
}

std::pair<int, int> GraphCamera::merge(int i, int j, const Bend& bend, const std::string& name) {
  for (const int index : {i, j}) {
    OC_CHECK(index >= 0 && static_cast<size_t>(index) < frusta_.size(), "there is no such frustum");
  }
  GraphCamera changed = *this;
  const int one = changed.bend(i, bend, name + " of " + frusta_[static_cast<size_t>(i)].name);
  const int other = changed.bend(j, bend, name + " of " + frusta_[static_cast<size_t>(j)].name);
  *this = std::move(changed);
  return {one, other};
}

void GraphCamera::limit(int i, const Plane& plane) {
  OC_CHECK(i >= 0 && static_cast<size_t>(i) < frusta_.size(), "there is no such frustum");
  Frustum& frustum = frusta_[static_cast<size_t>(i)];
  if (!isSound(plane)) {
    fail(frustum.name, "one of its limits is not finite, or its normal has no length", "give finite numbers");
  }
  if (!(plane.height(segmentIn(i, middleOf(frustum.part)).from) < 0)) {
    fail(frustum.name, "its middle begins beyond one of its limits", "turn the normal of the limit outwards");
  }
  frustum.limits.push_back(plane);
}

bool GraphCamera::isBeyondLimits(int i, const glm::dvec3& point) const {
  const std::vector<Plane>& limits = frusta_[static_cast<size_t>(i)].limits;
  const double rounding = kLimitRounding * (1 + glm::length(point));
  return std::any_of(limits.begin(), limits.end(), [&](const Plane& limit) { return limit.height(point) > rounding; });
}

int GraphCamera::childAt(int i, const glm::dvec2& pixel) const {
  for (const int child : frusta_[static_cast<size_t>(i)].children) {
    if (inside(frusta_[static_cast<size_t>(child)].part, pixel) >= -kPixelRounding) {
      return child;
    }
  }
  return -1;
}

GraphCamera::Segment GraphCamera::rootSegment(const glm::dvec2& pixel) const {
  const glm::dvec2 offset = (pixel - glm::dvec2(root_.centerPixels())) / static_cast<double>(root_.focalPixels());
  const glm::dvec3 direction =
      glm::dvec3(root_.right()) * offset.x + glm::dvec3(root_.down()) * offset.y + glm::dvec3(root_.forward());
  const double z = static_cast<double>(root_.view().zNear);
  return {glm::dvec3(root_.eye()) + direction * z, direction, z};
}

GraphCamera::Segment GraphCamera::next(const Segment& segment, int i) const {
  const Frustum& child = frusta_[static_cast<size_t>(i)];
  const double advance = -child.plane.height(segment.from) / glm::dot(child.plane.normal, segment.direction);
  const glm::dvec3 from = segment.from + segment.direction * advance;
  const glm::dvec3 direction = glm::normalize(from - child.viewpoint) * glm::length(segment.direction);
  return {from, direction, segment.t + advance};
}

GraphCamera::Segment GraphCamera::segmentIn(int i, const glm::dvec2& pixel) const {
  return i == kRoot ? rootSegment(pixel) : next(segmentIn(frusta_[static_cast<size_t>(i)].parent, pixel), i);
}

/// The t at which a ray of frustum `i` ends that goes on to no child.
double GraphCamera::endOf(int i, const Segment& segment) const {
  double end = static_cast<double>(root_.view().zFar);
  for (const Plane& limit : frusta_[static_cast<size_t>(i)].limits) {
    const double height = limit.height(segment.from);
    const double rise = glm::dot(limit.normal, segment.direction);
    if (height >= 0) {
      end = segment.t;
    } else if (rise > 0) {
      end = std::min(end, segment.t - height / rise);
    }
  }
  return end;
}

/// Calls `visit(frustum, segment)` along the ray of a pixel until it returns false.
template <class Visit>
void GraphCamera::walk(const glm::dvec2& pixel, const Visit& visit) const {
  Segment segment = rootSegment(pixel);
  for (int i = kRoot; visit(i, segment);) {
    i = childAt(i, pixel);
    if (i < 0) {
      return;
    }
    segment = next(segment, i);
  }
}

bool GraphCamera::holds(int i, const glm::dvec3& point, double pixelRounding) const {
  const Frustum& frustum = frusta_[static_cast<size_t>(i)];
  if (!(frustum.plane.height(point) >= -kHeightRounding)) {
    return false;
  }
  const glm::dvec4 h = frustum.pixelFromWorld * glm::dvec4(point, 1);
  const glm::dvec2 pixel(h.x / h.w, h.y / h.w);
  if (!(h.w > 0) || !(inside(frustum.part, pixel) >= -pixelRounding)) {
    return false;
  }
  const int child = childAt(i, pixel);
  return child < 0 ? !isBeyondLimits(i, point) : frusta_[static_cast<size_t>(child)].plane.height(point) <= 0;
}

int GraphCamera::frustumOf(const glm::dvec3& worldPoint) const {
  for (const double rounding : {kPixelRounding, kSinglePixelRounding}) {
    for (int i = 0; i < static_cast<int>(frusta_.size()); ++i) {
      if (holds(i, worldPoint, rounding)) {
        return i;
      }
    }
  }
  return -1;
}

double GraphCamera::depth(int i, const glm::dvec3& point) const {
  double length = 0;
  glm::dvec3 at = point;
  for (; i != kRoot; i = frusta_[static_cast<size_t>(i)].parent) {
    const Frustum& frustum = frusta_[static_cast<size_t>(i)];
    const glm::dvec3 crossing = frustum.plane.crossing(frustum.viewpoint, at);
    length += glm::distance(crossing, at);
    at = crossing;
  }
  const glm::dvec3 first = at - glm::dvec3(root_.eye());
  const double z = glm::dot(glm::dvec3(root_.forward()), first);
  return z + length * z / glm::length(first);
}

std::optional<ExactImagePoint> GraphCamera::projectExactly(const glm::dvec3& worldPoint) const {
  int i = frustumOf(worldPoint);
  if (i < 0) {
    // As a pinhole the root has an image beyond the borders too.
    const glm::dvec4 h = frusta_[kRoot].pixelFromWorld * glm::dvec4(worldPoint, 1);
    const glm::dvec2 pixel(h.x / h.w, h.y / h.w);
    if (!(frusta_[kRoot].plane.height(worldPoint) >= -kHeightRounding) || !(inside(frusta_[kRoot].part, pixel) < 0) ||
        isBeyondLimits(kRoot, worldPoint)) {
      return std::nullopt;
    }
    i = kRoot;
  }
  const glm::dvec4 h = frusta_[static_cast<size_t>(i)].pixelFromWorld * glm::dvec4(worldPoint, 1);
  const ExactImagePoint q{h.x / h.w, h.y / h.w, depth(i, worldPoint)};
  const bool inDepth = q.t <= static_cast<double>(root_.view().zFar) * (1 + kSingleDepthRounding);
  return inDepth && std::isfinite(q.u) && std::isfinite(q.v) ? std::optional(q) : std::nullopt;
}

std::optional<glm::dvec3> GraphCamera::unprojectExactly(const ExactImagePoint& q) const {
  if (!(q.t >= static_cast<double>(root_.view().zNear) && q.t <= static_cast<double>(root_.view().zFar)) ||
      !std::isfinite(q.u) || !std::isfinite(q.v)) {
    return std::nullopt;
  }
  glm::dvec3 point(0);
  int last = kRoot;
  double end = 0;
  walk({q.u, q.v}, [&](int i, const Segment& segment) {
    if (segment.t > q.t) {
      return false;
    }
    point = segment.from + segment.direction * (q.t - segment.t);
    last = i;
    end = endOf(i, segment);
    return true;
  });
  const bool ends = childAt(last, {q.u, q.v}) < 0;
  const bool beyond = ends && q.t > end * (1 + kSingleDepthRounding);
  return beyond || !isFinite(point) ? std::nullopt : std::optional(point);
}

std::optional<ImagePoint> GraphCamera::project(const glm::vec3& worldPoint) const {
  return inSinglePrecision(projectExactly(glm::dvec3(worldPoint)));
}

std::optional<glm::vec3> GraphCamera::unproject(const ImagePoint& q) const {
  const std::optional<glm::dvec3> point =
      unprojectExactly({static_cast<double>(q.u), static_cast<double>(q.v), static_cast<double>(q.t)});
  return point ? std::optional(glm::vec3(*point)) : std::nullopt;
}

RayPath GraphCamera::rayPath(const glm::vec2& pixel) const {
  RayPath path;
  if (!std::isfinite(pixel.x) || !std::isfinite(pixel.y)) {
    return path;
  }
  glm::dvec3 end(0);
  double tEnd = 0;
  walk(glm::dvec2(pixel), [&](int i, const Segment& segment) {
    path.add(glm::vec3(segment.from), static_cast<float>(segment.t));
    tEnd = endOf(i, segment);
    end = segment.from + segment.direction * (tEnd - segment.t);
    return true;
  });
  path.add(glm::vec3(end), static_cast<float>(tEnd));
  return path;
}

}  // namespace ocelli
