#include "oc_core/constructor/path_constructor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <optional>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/constructor/camera_fields.h"

namespace ocelli {
namespace {

constexpr size_t kMaxPoints = 4096;
constexpr double kMinTurn = 1e-4;  // radians: less is straight
/// Between the planes of a full turn at its outermost rays, as an angle about the line where they meet.
const double kPlaneAngle = radiansFromDegrees(8);
// In distances of control points.
constexpr double kCollapsed = 0.3;       // from the eye: a turn is gone
constexpr double kCollapsing = 2;        // from the eye: a turn begins to collapse
constexpr double kUnfoldedFrom = 2;      // from the end of the preview: a turn has unfolded
constexpr double kMeetingWidths = 1.15;  // where the planes meet, in half widths of the bundle of rays
constexpr int kBisections = 14;          // for the strength of a turn that cannot be made in full

/// The path as a function of length. It goes straight on beyond its ends. Corners are rounded on request: a point is
/// the mean of the path over a length around it.
class PathLine {
 public:
  PathLine(const std::vector<glm::vec3>& points, const glm::dvec3& offset) {
    for (const glm::vec3& point : points) {
      const glm::dvec3 moved = glm::dvec3(point) + offset;
      const double length = points_.empty() ? 0 : lengths_.back() + glm::distance(points_.back(), moved);
      if (points_.empty() || length > lengths_.back()) {  // else the point is too near for the length to grow
        lengths_.push_back(length);
        points_.push_back(moved);
      }
    }
    if (points_.size() < 2 || !std::isfinite(lengths_.back())) {
      throw InputError("a path to preview needs two different points, and finite numbers", "path camera",
                       "give \"path\", or choose a scene that has one, such as builtin:canyon");
    }
  }

  double length() const { return lengths_.back(); }
  void roundCorners(double over) { roundedOver_ = over; }

  glm::dvec3 at(double length) const {
    if (!(roundedOver_ > 0)) {
      return cornered(length);
    }
    // The mean of each straight piece is its middle.
    glm::dvec3 sum(0);
    double from = length - roundedOver_ / 2;
    const double end = length + roundedOver_ / 2;
    for (auto next = std::upper_bound(lengths_.begin(), lengths_.end(), from); from < end; ++next) {
      const double to = next == lengths_.end() ? end : std::min(*next, end);
      sum += cornered((from + to) / 2) * (to - from);
      from = to;
      if (next == lengths_.end()) {
        break;
      }
    }
    return sum / roundedOver_;
  }

 private:
  glm::dvec3 cornered(double length) const {
    const auto after = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, length);
    const auto i = static_cast<size_t>(after - lengths_.begin());
    const double share = (length - lengths_[i - 1]) / (lengths_[i] - lengths_[i - 1]);
    return glm::mix(points_[i - 1], points_[i], share);
  }

  std::vector<glm::dvec3> points_;
  std::vector<double> lengths_;
  double roundedOver_ = 0;
};

/// A path with what travels along it.
struct Journey {
  Journey(const PathOptions& options, const SceneGuides& guides, const PinholeCamera& reference)
      : line(options.path.empty() ? guides.path : options.path,
             glm::normalize(glm::dvec3(reference.view().up)) * options.eyeHeight),
        position(options.position * line.length()),
        preview(options.preview * line.length()),
        spacing(preview / options.turns) {
    line.roundCorners(options.rounding * spacing);
  }

  PathLine line;
  double position;
  double preview;
  double spacing;  ///< of control points
};

/// Looks at the point of the path one spacing ahead.
PinholeCamera rootOf(const Journey& journey, const PinholeCamera& reference) {
  View view = reference.view();
  view.fovVerticalDegrees = view.resolvedFovVerticalDegrees();
  view.eye = glm::vec3(journey.line.at(journey.position));
  view.target = glm::vec3(journey.line.at(journey.position + journey.spacing));
  return {view, reference.width(), reference.height()};
}

/// The turn about a point from one direction by an angle towards another.
struct Bend {
  glm::dvec3 point{0};
  glm::dvec3 axis{0};
  glm::dvec3 inwards{0};  ///< across the way, to the inside of the turn
  glm::dvec3 forward{0};  ///< of the middle plane
  glm::dvec3 viewpoint{0};
};

glm::dvec3 rotated(const glm::dvec3& v, double angle, const glm::dvec3& axis) {
  return glm::dvec3(glm::rotate(glm::dmat4(1), angle, axis) * glm::dvec4(v, 0));
}

/// `along` is how rays run on the whole, which the planes of the turn face.
Bend bendBy(double angle, const glm::dvec3& axis, const glm::dvec3& point, const glm::dvec3& before,
            const glm::dvec3& along) {
  Bend bend;
  bend.point = point;
  bend.axis = axis;
  bend.forward = rotated(glm::normalize(along - axis * glm::dot(axis, along)), angle / 2, axis);
  bend.inwards = glm::cross(axis, bend.forward);
  bend.viewpoint = point - rotated(point - before, angle, axis);
  return bend;
}

/// With that turn, if its rays can make it; `opening` is the angle between its planes.
std::optional<CurvedRayCamera> turned(const CurvedRayCamera& camera, const Bend& bend, double opening) {
  const Plane middle = Plane::through(bend.point, bend.forward);
  const auto width = static_cast<float>(camera.width());
  const auto height = static_cast<float>(camera.height());
  double widest = 0;
  for (const glm::vec2 corner : {glm::vec2(0), glm::vec2(width, 0), glm::vec2(width, height), glm::vec2(0, height)}) {
    const RayPath path = camera.rayPath(corner);
    const glm::dvec3 from(path[path.size() - 2]);
    const glm::dvec3 to(path.back());
    const double rise = glm::dot(middle.normal, to - from);
    if (!(rise > 0) || !(middle.height(from) < 0)) {
      return std::nullopt;
    }
    widest = std::max(widest, glm::dot(bend.inwards, middle.crossing(from, to) - bend.point));
  }
  const glm::dvec3 onLine = bend.point + bend.inwards * (kMeetingWidths * widest);
  const auto planeAt = [&](double angle) { return Plane::through(onLine, rotated(bend.forward, angle, bend.axis)); };
  CurvedRayCamera changed = camera;
  try {
    changed.bend({planeAt(-opening), middle, planeAt(opening)}, bend.viewpoint);
  } catch (const InputError&) {
    return std::nullopt;
  }
  return changed;
}

/// Turns as strongly as can be, at most by `share` of the way from the direction of the rays to that of `next`.
CurvedRayCamera turnedTowards(const CurvedRayCamera& camera, const glm::dvec3& point, const glm::dvec3& next,
                              double share) {
  const glm::dvec3 before = camera.bends().empty() ? glm::dvec3(camera.root().eye()) : camera.bends().back().beyond();
  const glm::dvec3 arriving = glm::normalize(point - before);
  const glm::dvec3 leaving = glm::normalize(next - point);
  const glm::dvec3 across = glm::cross(arriving, leaving);
  const double angle = std::atan2(glm::length(across), glm::dot(arriving, leaving)) * share;
  if (!(angle > kMinTurn) || !(glm::length(across) > 0)) {
    return camera;
  }
  const glm::dvec3 axis = glm::normalize(across);
  const RayPath middle = camera.rayPath(glm::vec2(camera.width(), camera.height()) * 0.5f);
  const glm::dvec3 along(middle.back() - middle[middle.size() - 2]);
  const auto at = [&](double strength) {
    return turned(camera, bendBy(angle * strength, axis, point, before, along), kPlaneAngle * share * strength);
  };
  std::optional<CurvedRayCamera> best = at(1);
  double least = 0;
  double most = 1;
  for (int i = 0; i < kBisections && (i > 0 || !best); ++i) {
    const double strength = (least + most) / 2;
    std::optional<CurvedRayCamera> tried = at(strength);
    (tried ? least : most) = strength;
    if (tried) {
      best = std::move(tried);
    }
  }
  return best ? *best : camera;
}

}  // namespace

PinholeCamera pathPinhole(const PathOptions& options, const SceneGuides& guides, const PinholeCamera& reference) {
  return rootOf(Journey(options, guides, reference), reference);
}

CurvedRayCamera buildPathCamera(const PathOptions& options, const SceneGuides& guides, const PinholeCamera& reference) {
  const Journey journey(options, guides, reference);
  CurvedRayCamera camera(rootOf(journey, reference));
  const double end = std::min(journey.position + journey.preview, journey.line.length());
  for (double at = (std::floor(journey.position / journey.spacing) + 1) * journey.spacing; at < end;
       at += journey.spacing) {
    const double share = options.deployed *
                         glm::smoothstep(kCollapsed, kCollapsing, (at - journey.position) / journey.spacing) *
                         glm::smoothstep(0.0, kUnfoldedFrom, (end - at) / journey.spacing);
    camera = turnedTowards(camera, journey.line.at(at), journey.line.at(at + journey.spacing), share);
  }
  return camera;
}

PathOptions readPathOptions(JsonFields& fields) {
  PathOptions options;
  if (fields.has("path")) {
    const nlohmann::json& list = fields.value("path");
    if (!list.is_array() || list.size() < 2 || list.size() > kMaxPoints) {
      fields.fail("path", "must be a list of 2 to 4096 points");
    }
    for (size_t i = 0; i < list.size(); ++i) {
      const nlohmann::json point{{"point", list[i]}};
      JsonFields ofPoint(point, fields.where() + ", \"path\" " + std::to_string(i + 1));
      options.path.emplace_back(readVector(ofPoint, "point"));
    }
  }
  options.position = fields.number("position", 0, 1, options.position);
  options.preview = fields.number("preview", 1e-3, 1, options.preview);
  options.turns = fields.integer("turns", 1, static_cast<int>(CurvedRayCamera::kMaxBends), options.turns);
  options.eyeHeight = fields.number("eye_height", -1e6, 1e6, options.eyeHeight);
  options.rounding = fields.number("rounding", 0, 4, options.rounding);
  options.deployed = fields.number("deployed", 0, 1, options.deployed);
  return options;
}

}  // namespace ocelli
