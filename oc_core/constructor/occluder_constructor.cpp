#include "oc_core/constructor/occluder_constructor.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/constructor/object_boxes.h"

namespace ocelli {
namespace {

/// By how much the planes of the split are turned apart: the share of the distance to them by which they are nearer
/// beside the viewpoints.
constexpr double kApart = 0.1;
/// How far into the box the split line lies, as a share of the way through it.
constexpr double kInside = 0.02;
/// How far beyond the middle rays go on within the box, in widths of it: into niches of its front.
constexpr double kOverlap = 0.05;
/// The merged viewpoint is before the plane where rays meet by this share of its distance at least.
constexpr double kMinBefore = 0.3;

/// The plan as seen: x across and z towards the middle of the box, both at right angles to the image's columns.
struct PlanView {
  PlanView(const PinholeCamera& camera, const glm::vec3& middle) : eye(camera.eye()) {
    const glm::dvec3 down(camera.down());
    const glm::dvec3 way = glm::dvec3(middle) - eye;
    forward = glm::normalize(way - down * glm::dot(down, way));
    right = glm::cross(down, forward);
  }

  double x(const glm::dvec3& point) const { return glm::dot(right, point - eye); }
  double z(const glm::dvec3& point) const { return glm::dot(forward, point - eye); }
  glm::dvec3 at(double x, double z) const { return eye + right * x + forward * z; }

  glm::dvec3 eye;
  glm::dvec3 forward;
  glm::dvec3 right;
};

/// Of the box, in the plan.
struct OccluderExtent {
  double left = 0;
  double right = 0;
  double nearest = std::numeric_limits<double>::infinity();
  double farthest = 0;
};

OccluderExtent extentOf(const Box& box, const PlanView& plan) {
  OccluderExtent extent;
  for (const glm::dvec3 corner : cornersOf(box)) {
    extent.left = std::min(extent.left, plan.x(corner));
    extent.right = std::max(extent.right, plan.x(corner));
    extent.nearest = std::min(extent.nearest, plan.z(corner));
    extent.farthest = std::max(extent.farthest, plan.z(corner));
  }
  return extent;
}

/// Where the level way from the eye to the middle of the box enters it, and a little farther.
double splitDistance(const Box& box, const PlanView& plan, double farthest) {
  const glm::dvec3 middle(box.center());
  const glm::dvec3 from = middle - plan.forward * plan.z(middle);
  const std::optional<SegmentPart> part = partWithin(box, from, from + plan.forward * farthest);
  // Rounding may miss a box that is flat.
  return part ? glm::mix(part->first, part->last, kInside) * farthest : plan.z(middle);
}

/// How far aside a viewpoint must be for the rays that graze the box on that side to meet the middle at `meeting`.
double asideFor(double meeting, const Box& box, const PlanView& plan, double side) {
  double aside = 0;
  for (const glm::dvec3 corner : cornersOf(box)) {
    aside = std::max(aside, side * plan.x(corner) * meeting / (meeting - plan.z(corner)));
  }
  return aside;
}

/// Where the merged viewpoint must be for the outermost ray of a side to run on as it does in the pinhole's image.
double mergedFor(double meeting, double split, double slope, double aside, double tangent) {
  const double z = split / (1 + slope * tangent);
  const double atMeeting = aside + (tangent * z - aside) * meeting / z;
  return meeting - atMeeting / tangent;
}

/// Of the rays that run along a side those go on behind the box that have not crossed the middle; the others end, so
/// that no two see the same.
void mergeSide(GraphCamera& camera, int frustum, const GraphCamera::Bend& behind, const PlanView& plan, double side,
               double overlap) {
  camera.limit(frustum, Plane::through(plan.eye - plan.right * (side * overlap), plan.right * -side));
  camera.limit(frustum, behind.plane);
  const GraphCamera::Frustum& beside = camera.frusta()[static_cast<size_t>(frustum)];
  const glm::dvec3 meeting = behind.plane.crossing(plan.eye, plan.eye + plan.forward);
  const glm::dvec4 image = beside.pixelFromWorld * glm::dvec4(meeting, 1);
  const double column = image.x / image.w;
  auto [right, left] = GraphCamera::cut(beside.part, {column, 0}, {column, -1});
  GraphCamera::Part& part = side > 0 ? right : left;
  if (!part.empty()) {
    camera.bend(frustum, behind, "behind the box from the " + std::string(side > 0 ? "right" : "left"), part);
  }
}

Box boxOf(const OccluderOptions& options, const GuidedScene& scene) {
  if (options.box) {
    return *options.box;
  }
  const std::vector<Box> boxes = objectBoxes(scene);
  const auto object = static_cast<size_t>(options.object);
  if (object == 0 || object >= boxes.size() || boxes[object].empty()) {
    throw InputError(object == 0 ? "neither a box nor an object to look around is given"
                                 : "the scene has no object " + std::to_string(object),
                     "occluder camera",
                     boxes.size() > 1 ? "give \"box\", or an \"object\" from 1 to " + std::to_string(boxes.size() - 1)
                                      : "give \"box\": this scene has no objects");
  }
  return boxes[object];
}

void requireInView(const Box& box, const PinholeCamera& reference) {
  const auto fail = [](const std::string& what, const std::string& next) {
    throw InputError(what, "occluder camera", next);
  };
  if (contains(box, reference.eye())) {
    fail("the eye is in the box", "move the eye out of it");
  }
  for (const glm::vec3& corner : cornersOf(box)) {
    if (!(reference.cameraFromWorld(corner).z > reference.view().zNear)) {
      fail("the box is behind the eye, or beside it", "turn the view towards it, or move the eye away");
    }
  }
  const ImagePoint middle = reference.imageFromCamera(reference.cameraFromWorld(box.center()));
  if (!(middle.u > 0 && middle.u < static_cast<float>(reference.width()) && middle.v > 0 &&
        middle.v < static_cast<float>(reference.height()))) {
    fail("the middle of the box is not in view", "turn the view towards it");
  }
}

}  // namespace

GraphCamera buildOccluderCamera(const OccluderOptions& options, const GuidedScene& scene,
                                const PinholeCamera& reference) {
  const Box box = boxOf(options, scene);
  requireInView(box, reference);
  const PlanView plan(reference, box.center());
  const OccluderExtent extent = extentOf(box, plan);
  const double split = options.splitDepth.value_or(splitDistance(box, plan, extent.farthest));
  const double meeting = extent.farthest + options.shadow * (extent.right - extent.left);
  const double left = asideFor(meeting, box, plan, -1);
  const double right = asideFor(meeting, box, plan, 1);
  const double slope = kApart * split / std::max(left, right);
  // What the outermost rays of the image rise across, for each unit forward.
  const auto tangentAt = [&](float u) {
    const ImagePoint border{u, static_cast<float>(reference.height()) / 2, 1};
    const glm::dvec3 point(reference.worldFromCamera(reference.cameraFromImage(border)));
    return plan.x(point) / plan.z(point);
  };
  // As wide as the image is where the box is in its middle.
  const double halfWidth = reference.width() / (2 * static_cast<double>(reference.focalPixels()));
  const double leftTangent = options.steady ? halfWidth : -tangentAt(0);
  const double rightTangent = options.steady ? halfWidth : tangentAt(static_cast<float>(reference.width()));
  const double merged = std::clamp(std::min(mergedFor(meeting, split, slope, left, leftTangent),
                                            mergedFor(meeting, split, slope, right, rightTangent)),
                                   0.0, (1 - kMinBefore) * meeting) *
                        options.deployed;
  const auto sideTurn = [&](double side, double aside) {
    return GraphCamera::Bend{Plane::through(plan.at(0, split), plan.forward + plan.right * (side * slope)),
                             plan.at(side * aside * options.deployed, 0)};
  };
  GraphCamera camera(reference);
  const auto [one, other] =
      camera.split(GraphCamera::kRoot, sideTurn(-1, left), sideTurn(1, right), "left of the box", "right of the box");
  const double overlap = kOverlap * (extent.right - extent.left);
  const GraphCamera::Bend behind{Plane::through(plan.at(0, meeting), plan.forward), plan.at(0, merged)};
  mergeSide(camera, one, behind, plan, -1, overlap);
  mergeSide(camera, other, behind, plan, 1, overlap);
  return camera;
}

OccluderOptions readOccluderOptions(JsonFields& fields) {
  OccluderOptions options;
  if (fields.has("box")) {
    options.box = readBox(fields, "box");
  }
  options.object = fields.integer("object", 0, 1'000'000'000, options.object);
  options.shadow = fields.number("shadow", 0.01, 100, options.shadow);
  options.deployed = fields.number("deployed", 0, 1, options.deployed);
  return options;
}

}  // namespace ocelli
