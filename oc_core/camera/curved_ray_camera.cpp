#include "oc_core/camera/curved_ray_camera.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "oc_core/base/error.h"
#include "oc_core/base/finite.h"
#include "oc_core/camera/ray_rounding.h"

namespace ocelli {
namespace {

/// How far from one line the planes of a bend may meet, relative to the unit length of their normals.
constexpr double kLineRounding = 1e-6;

[[noreturn]] void fail(size_t number, const std::string& what, const std::string& next) {
  throw InputError(what, "curved ray camera, turn " + std::to_string(number), next);
}

void requireCommonLine(const TransitionPlanes& planes, size_t number) {
  for (const Plane* plane : {&planes.from, &planes.middle, &planes.to}) {
    if (!(std::abs(glm::length(plane->normal) - 1) < kLineRounding) || !std::isfinite(plane->distance)) {
      fail(number, "a plane is not finite, or its normal has no length", "give finite numbers");
    }
  }
  const glm::dvec3 along = glm::cross(planes.from.normal, planes.to.normal);
  if (!(glm::length(along) > kLineRounding)) {
    fail(number, "its first and its last plane are parallel, or one", "turn them apart");
  }
  const glm::dvec3 point = (glm::cross(planes.to.normal, along) * planes.from.distance +
                            glm::cross(along, planes.from.normal) * planes.to.distance) /
                           glm::dot(along, along);
  if (!(std::abs(glm::dot(planes.middle.normal, glm::normalize(along))) < kLineRounding) ||
      !(std::abs(planes.middle.height(point)) < kLineRounding * (1 + glm::length(point)))) {
    fail(number, "its planes do not meet in a line", "let the middle plane pass the line where the others meet");
  }
}

}  // namespace

CurvedRayCamera::CurvedRayCamera(const PinholeCamera& root, ArcModel model)
    : root_(root), model_(model), pixelFromWorld_{ocelli::pixelFromWorld(root)} {}

void CurvedRayCamera::bend(const TransitionPlanes& planes, const glm::dvec3& viewpoint) {
  const size_t number = bends_.size() + 1;
  if (number > kMaxBends) {
    fail(number, "there are more than " + std::to_string(kMaxBends) + " turns", "use fewer");
  }
  requireCommonLine(planes, number);
  if (!std::isfinite(glm::length(viewpoint)) || !(planes.middle.height(viewpoint) < -kHeightRounding) ||
      !(planes.to.height(viewpoint) < -kHeightRounding)) {
    fail(number, "its viewpoint does not lie before its middle and last plane", "move the viewpoint or the planes");
  }
  const glm::dvec3 before = bends_.empty() ? glm::dvec3(root_.eye()) : bends_.back().beyond();
  const double width = root_.width();
  const double height = root_.height();
  const glm::dvec3 along = glm::normalize(glm::cross(planes.from.normal, planes.to.normal));
  const glm::dvec3 axis = viewpoint - before;
  glm::dvec3 border(0);
  double farthest = -1;
  double side = 0;
  for (const glm::dvec2 corner :
       {glm::dvec2(0, 0), glm::dvec2(width, 0), glm::dvec2(width, height), glm::dvec2(0, height)}) {
    const Segment ray = segmentAfter(bends_.size(), corner);
    double last = ray.t;
    for (const Plane* plane : {&planes.from, &planes.middle}) {
      const double forward = glm::dot(plane->normal, ray.direction);
      const double z = ray.t - plane->height(ray.from) / forward;
      if (!(forward > 0) || !(z > last) || !(z < static_cast<double>(root_.view().zFar))) {
        fail(number, "not every ray crosses its planes in order, behind the turn before and before zFar",
             "move its planes, or turn them towards the rays");
      }
      last = z;
    }
    const glm::dvec3 s = planes.middle.crossing(ray.from, ray.from + ray.direction);
    const glm::dvec3 onward = glm::normalize(s - viewpoint);
    if (!(glm::dot(planes.to.normal, onward) > 0) || !(planes.to.height(s) < -kHeightRounding)) {
      fail(number, "not every ray crosses its planes in order", "move its last plane, or turn it towards the rays");
    }
    if (!isFinite(glm::vec3(planes.to.crossing(viewpoint, s)))) {
      fail(number, "rays that come from its viewpoint cross its last plane too far away for single precision",
           "move the viewpoint nearer, or turn the plane towards the rays");
    }
    // How far from the line where the planes meet.
    const double fromLine = planes.from.height(s) / glm::length(glm::cross(planes.from.normal, planes.middle.normal));
    if (fromLine > farthest) {
      farthest = fromLine;
      border = s;
    }
    const double across = glm::dot(glm::cross(axis, s - before), along);
    if (glm::length(axis) > kHeightRounding && (!(std::abs(across) > kHeightRounding) || across * side < 0)) {
      fail(number, "its viewpoint is moved along the line where its planes meet, as some ray sees it",
           "move the viewpoint across that line");
    }
    side = across;
  }
  bends_.emplace_back(planes, before, viewpoint, border, model_);
  pixelFromWorld_.push_back(pixelFromWorld_.back() * ontoPlane(planes.middle, viewpoint));
}

CurvedRayCamera::Segment CurvedRayCamera::rootSegment(const glm::dvec2& pixel) const {
  const glm::dvec2 offset = (pixel - glm::dvec2(root_.centerPixels())) / static_cast<double>(root_.focalPixels());
  const glm::dvec3 direction =
      glm::dvec3(root_.right()) * offset.x + glm::dvec3(root_.down()) * offset.y + glm::dvec3(root_.forward());
  const double z = static_cast<double>(root_.view().zNear);
  return {glm::dvec3(root_.eye()) + direction * z, direction, z};
}

RayTransition::Arc CurvedRayCamera::arcOf(const Segment& segment, size_t bend) const {
  return bends_[bend].arcThrough(bends_[bend].planes().middle.crossing(segment.from, segment.from + segment.direction));
}

CurvedRayCamera::Segment CurvedRayCamera::behind(const Segment& segment, const RayTransition::Arc& arc,
                                                 size_t bend) const {
  const double speed = glm::length(segment.direction);
  return {arc.q, glm::normalize(arc.q - bends_[bend].beyond()) * speed, segment.tOf(arc.t) + arc.length() / speed};
}

CurvedRayCamera::Segment CurvedRayCamera::segmentAfter(size_t bends, const glm::dvec2& pixel) const {
  Segment segment = rootSegment(pixel);
  for (size_t i = 0; i < bends; ++i) {
    segment = behind(segment, arcOf(segment, i), i);
  }
  return segment;
}

/// Where a point is seen that lies on the straight piece of a ray behind its first `bends` bends, or its prolongation.
std::optional<glm::dvec2> CurvedRayCamera::pixelOf(size_t bends, const glm::dvec3& point, double rounding) const {
  const glm::dvec4 h = pixelFromWorld_[bends] * glm::dvec4(point, 1);
  const glm::dvec2 pixel(h.x / h.w, h.y / h.w);
  const bool inside = h.w > 0 && pixel.x >= -rounding && pixel.y >= -rounding && pixel.x <= width() + rounding &&
                      pixel.y <= height() + rounding;
  return inside ? std::optional(pixel) : std::nullopt;
}

std::optional<ExactImagePoint> CurvedRayCamera::inSegment(size_t bends, const glm::dvec3& point,
                                                          double rounding) const {
  const bool begun = bends == 0 ? glm::dot(glm::dvec3(root_.forward()), point - glm::dvec3(root_.eye())) >=
                                      static_cast<double>(root_.view().zNear) - kHeightRounding
                                : bends_[bends - 1].planes().to.height(point) >= -kHeightRounding;
  const bool ended = bends < bends_.size() && bends_[bends].planes().from.height(point) > 0;
  if (!begun || ended) {
    return std::nullopt;
  }
  const std::optional<glm::dvec2> pixel = pixelOf(bends, point, rounding);
  return pixel ? std::optional(ExactImagePoint{pixel->x, pixel->y, segmentAfter(bends, *pixel).tOf(point)})
               : std::nullopt;
}

std::optional<ExactImagePoint> CurvedRayCamera::inBend(size_t bend, const glm::dvec3& point, double rounding) const {
  const RayTransition& transition = bends_[bend];
  if (!(transition.planes().from.height(point) >= 0) || !(transition.planes().to.height(point) <= 0)) {
    return std::nullopt;
  }
  const std::optional<RayTransition::Place> place = transition.find(point);
  const std::optional<glm::dvec2> pixel = place ? pixelOf(bend, place->arc.s, rounding) : std::nullopt;
  if (!pixel) {
    return std::nullopt;
  }
  const Segment segment = segmentAfter(bend, *pixel);
  const double advance = transition.shareAt(*place) * place->arc.length() / glm::length(segment.direction);
  return ExactImagePoint{pixel->x, pixel->y, segment.tOf(place->arc.t) + advance};
}

std::optional<ExactImagePoint> CurvedRayCamera::projectExactly(const glm::dvec3& worldPoint) const {
  std::optional<ExactImagePoint> q;
  for (const double rounding : {kPixelRounding, kSinglePixelRounding}) {
    for (size_t i = 0; !q && i <= bends_.size(); ++i) {
      q = inSegment(i, worldPoint, rounding);
      if (!q && i < bends_.size()) {
        q = inBend(i, worldPoint, rounding);
      }
    }
  }
  if (!q) {
    // As a pinhole it has an image beyond the borders too.
    const glm::dvec4 h = pixelFromWorld_[0] * glm::dvec4(worldPoint, 1);
    q = ExactImagePoint{h.x / h.w, h.y / h.w, h.w};
    const bool beyond = q->u < 0 || q->v < 0 || q->u > width() || q->v > height();
    if (!(h.w >= static_cast<double>(root_.view().zNear)) || !beyond) {
      return std::nullopt;
    }
  }
  const bool inDepth = q->t <= static_cast<double>(root_.view().zFar) * (1 + kSingleDepthRounding);
  return inDepth && std::isfinite(q->u) && std::isfinite(q->v) ? q : std::nullopt;
}

std::optional<glm::dvec3> CurvedRayCamera::unprojectExactly(const ExactImagePoint& q) const {
  if (!(q.t >= static_cast<double>(root_.view().zNear) && q.t <= static_cast<double>(root_.view().zFar)) ||
      !std::isfinite(q.u) || !std::isfinite(q.v)) {
    return std::nullopt;
  }
  const auto ifFinite = [](const glm::dvec3& point) { return isFinite(point) ? std::optional(point) : std::nullopt; };
  Segment segment = rootSegment({q.u, q.v});
  for (size_t i = 0; i < bends_.size(); ++i) {
    const RayTransition::Arc arc = arcOf(segment, i);
    const double begin = segment.tOf(arc.t);
    if (q.t <= begin) {
      break;
    }
    const Segment next = behind(segment, arc, i);
    if (q.t < next.t) {
      return ifFinite(arc.at(bends_[i].parameterAt(arc, (q.t - begin) / (next.t - begin))));
    }
    segment = next;
  }
  return ifFinite(segment.from + segment.direction * (q.t - segment.t));
}

std::optional<ImagePoint> CurvedRayCamera::project(const glm::vec3& worldPoint) const {
  return inSinglePrecision(projectExactly(glm::dvec3(worldPoint)));
}

std::optional<glm::vec3> CurvedRayCamera::unproject(const ImagePoint& q) const {
  const std::optional<glm::dvec3> point =
      unprojectExactly({static_cast<double>(q.u), static_cast<double>(q.v), static_cast<double>(q.t)});
  return point ? std::optional(glm::vec3(*point)) : std::nullopt;
}

size_t CurvedRayCamera::arcPointsWithRoom(size_t wanted) const {
  return std::min(wanted, (RayPath::kMaxPoints - 2) / std::max<size_t>(bends_.size(), 1));
}

RayPath CurvedRayCamera::rayPath(const glm::vec2& pixel, size_t arcPoints) const {
  RayPath path;
  if (!std::isfinite(pixel.x) || !std::isfinite(pixel.y)) {
    return path;
  }
  Segment segment = rootSegment(glm::dvec2(pixel));
  path.add(glm::vec3(segment.from), static_cast<float>(segment.t));
  const size_t points = arcPointsWithRoom(arcPoints);
  for (size_t i = 0; i < bends_.size(); ++i) {
    const RayTransition::Arc arc = arcOf(segment, i);
    const Segment next = behind(segment, arc, i);
    const double begin = segment.tOf(arc.t);
    RayTransition::ArcPoints onArc;
    bends_[i].pointsOf(arc, points, onArc);
    for (size_t k = 0; k < points; ++k) {
      path.add(glm::vec3(onArc.x[k], onArc.y[k], onArc.z[k]),
               static_cast<float>(begin + onArc.share[k] * (next.t - begin)));
    }
    segment = next;
  }
  const double rest = std::max(static_cast<double>(root_.view().zFar) - segment.t, 0.0);
  path.add(glm::vec3(segment.from + segment.direction * rest), static_cast<float>(segment.t + rest));
  return path;
}

// Pixels go to the points where their rays meet a plane by collineations, which take a rectangle into the hull of what
// its corners become, as all of the image lies on one side of what goes to infinity: bend() sees to that. The weights
// of arcs are positive, so each lies in the hull of its control points.
HullPieces CurvedRayCamera::hullOf(const glm::dvec2& lower, const glm::dvec2& upper) const {
  HullPieces hull;
  hull.points.reserve(16 + 24 * bends_.size());
  std::array<Segment, 4> rays{rootSegment(lower), rootSegment({upper.x, lower.y}), rootSegment(upper),
                              rootSegment({lower.x, upper.y})};
  double greatestSpeed = 0;
  for (const Segment& each : rays) {
    greatestSpeed = std::max(greatestSpeed, glm::length(each.direction));
  }
  for (size_t i = 0; i < bends_.size(); ++i) {
    std::array<RayTransition::Arc, 4> arcs;
    for (size_t k = 0; k < rays.size(); ++k) {
      arcs[k] = arcOf(rays[k], i);
      hull.points.insert(hull.points.end(), {rays[k].from, arcs[k].t});
    }
    hull.endPiece();
    for (size_t k = 0; k < rays.size(); ++k) {
      hull.points.insert(hull.points.end(), {arcs[k].t, arcs[k].s, arcs[k].q});
      rays[k] = behind(rays[k], arcs[k], i);
    }
    hull.endPiece();
  }
  // How far the last pieces are away from where they come from, at least, where they begin: as a plane is.
  const glm::dvec3 viewpoint = bends_.empty() ? glm::dvec3(root_.eye()) : bends_.back().beyond();
  const double begin =
      bends_.empty() ? static_cast<double>(root_.view().zNear) : std::abs(bends_.back().planes().to.height(viewpoint));
  // So far that none is longer: the ends of all lie in the hull of these, which are in one plane, too, or before it.
  const double scale = 1 + static_cast<double>(root_.view().zFar) * greatestSpeed / begin;
  for (const Segment& each : rays) {
    hull.points.insert(hull.points.end(), {each.from, viewpoint + (each.from - viewpoint) * scale});
  }
  hull.endPiece();
  return hull;
}

double CurvedRayCamera::deviationOf(const glm::dvec2& pixel, size_t arcPoints) const {
  double greatest = 0;
  Segment segment = rootSegment(pixel);
  for (size_t i = 0; i < bends_.size(); ++i) {
    const RayTransition::Arc arc = arcOf(segment, i);
    const auto chords = static_cast<double>(arcPoints - 1);
    for (double chord = 0; chord < chords; ++chord) {
      // An arc is farthest from a chord near the middle between its ends, as parameters go.
      const glm::dvec3 from = arc.at(chord / chords);
      const glm::dvec3 way = arc.at((chord + 1) / chords) - from;
      const glm::dvec3 middle = arc.at((chord + 0.5) / chords) - from;
      const double share = glm::dot(middle, way) / std::max(glm::dot(way, way), 1e-300);
      greatest = std::max(greatest, glm::length(middle - way * share));
    }
    segment = behind(segment, arc, i);
  }
  return greatest;
}

size_t CurvedRayCamera::arcPointsWithin(double deviation) const {
  constexpr int kGrid = 4;  // steps across the image, and down
  const auto isWithin = [&](size_t points) {
    for (int i = 0; i <= kGrid; ++i) {
      for (int j = 0; j <= kGrid; ++j) {
        const glm::dvec2 pixel(root_.width() * i / double(kGrid), root_.height() * j / double(kGrid));
        if (!(deviationOf(pixel, points) <= deviation)) {
          return false;
        }
      }
    }
    return true;
  };
  size_t points = 2;
  while (points < arcPointsWithRoom(kArcPoints) && !isWithin(points)) {
    ++points;
  }
  return points;
}

}  // namespace ocelli
