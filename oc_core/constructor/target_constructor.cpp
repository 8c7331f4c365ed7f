#include "oc_core/constructor/target_constructor.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/constructor/object_boxes.h"

namespace ocelli {
namespace {

constexpr size_t kMaxOccluders = 4096;
/// Less does not move a pixel.
constexpr double kMinF = 1e-5;
constexpr double kSearchStep = 0.05;

// In distances to the target.
constexpr double kOffset = 0.5;     ///< of the second viewpoint at f = 1
constexpr double kBendBegin = 0.5;  ///< of the bend, on the middle ray
constexpr double kMiddle = 0.6;     ///< of the bend
constexpr double kLatestEnd = 0.8;  ///< of the bend, on any ray

constexpr double kBesideRays = 0.1;  ///< where the planes meet, in widths of the bundle of rays

double depthOf(const PinholeCamera& view, const glm::vec3& point) {
  return static_cast<double>(view.cameraFromWorld(point).z);
}

void requireInFront(const Box& target, const PinholeCamera& view) {
  if (contains(target, view.eye())) {
    throw InputError("the eye is in the box of the target", "target camera", "move the eye out of it");
  }
  if (!(depthOf(view, target.center()) > static_cast<double>(view.view().zNear))) {
    throw InputError("the target is behind the eye", "target camera", "turn the view towards it");
  }
}

}  // namespace

CurvedRayCamera bentCamera(const PinholeCamera& view, const Box& target, double f) {
  CurvedRayCamera camera(view);
  const double distance = depthOf(view, target.center());
  if (std::abs(f) < kMinF || !(distance * (2 * kMiddle - kLatestEnd) > 2 * static_cast<double>(view.view().zNear)) ||
      !(distance < static_cast<double>(view.view().zFar))) {
    return camera;
  }
  // To the side to which rays bend, across the view, and forward.
  const glm::dvec3 eye(view.eye());
  const glm::dvec3 side = glm::dvec3(view.right()) * (f > 0 ? 1.0 : -1.0);
  const glm::dvec3 forward(view.forward());
  const double focal = static_cast<double>(view.focalPixels());
  const double left = static_cast<double>(view.centerPixels().x) / focal;
  const double right = view.width() / focal - left;
  const double middle = kMiddle * distance;
  const double inner = (f > 0 ? right : left) * middle + kBesideRays * (left + right) * middle;
  const double outer = (f > 0 ? left : right) * kLatestEnd * distance;
  const double slope = std::min((kMiddle - kBendBegin) * distance / std::max(inner, 1e-300),
                                (kLatestEnd - kMiddle) * distance / (inner + outer));
  const glm::dvec3 onLine = eye + forward * middle + side * inner;
  const auto planeAt = [&](double tilt) { return Plane::through(onLine, forward + side * tilt); };
  camera.bend({planeAt(-slope), planeAt(0), planeAt(slope)}, eye - side * (std::abs(f) * kOffset * distance));
  return camera;
}

double TargetTracker::wanted(const PinholeCamera& view, std::span<const Box> occluders, const Box& target) const {
  const TargetSight& sight = targetSight(options_.sight);
  const TargetMargin margin{options_.enlarged, options_.enlargedPixels};
  const auto shows = [&](double f) {
    return sight.share(bentCamera(view, target, f), occluders, target, margin) >= options_.visibleShare;
  };
  if (shows(0)) {
    return 0;
  }
  if (shows(f_)) {
    return f_;
  }
  for (double away = kSearchStep; away <= 2 * options_.maxF + kSearchStep; away += kSearchStep) {
    for (const double f : {f_ - away, f_ + away}) {
      if (std::abs(f) <= options_.maxF && shows(f)) {
        return f;
      }
    }
  }
  return 0;
}

CurvedRayCamera TargetTracker::update(const PinholeCamera& view, std::span<const Box> occluders, const Box& target) {
  f_ += std::clamp(wanted(view, occluders, target) - f_, -options_.maxChange, options_.maxChange);
  return bentCamera(view, target, f_);
}

std::vector<Box> occluderBoxes(const GuidedScene& scene) {
  std::vector<Box> boxes = objectBoxes(scene);
  boxes.resize(std::max<size_t>(boxes.size(), 1));
  boxes.front() = {};
  if (scene.guides.target && scene.guides.target->object < boxes.size()) {
    boxes[scene.guides.target->object] = {};
  }
  std::erase_if(boxes, [](const Box& box) { return box.empty(); });
  return boxes;
}

CurvedRayCamera buildTargetCamera(const TargetOptions& options, const GuidedScene& scene,
                                  const PinholeCamera& reference) {
  if (!options.box && !scene.guides.target) {
    throw InputError("the scene has no target of its own", "target camera",
                     "give \"box\", or choose a scene that has one, such as builtin:boxes,floor=1");
  }
  const Box target = options.box ? *options.box : scene.guides.target->box;
  requireInFront(target, reference);
  std::vector<Box> occluders = options.occluders.empty() ? occluderBoxes(scene) : options.occluders;
  if (options.box) {
    // What stands in the box is the target.
    std::erase_if(occluders, [&](const Box& box) { return contains(target, box.center()); });
  }
  return bentCamera(reference, target, TargetTracker(options).wanted(reference, occluders, target));
}

TargetOptions readTargetOptions(JsonFields& fields) {
  TargetOptions options;
  if (fields.has("box")) {
    options.box = readBox(fields, "box");
  }
  if (fields.has("occluders")) {
    const nlohmann::json& list = fields.value("occluders");
    if (!list.is_array() || list.empty() || list.size() > kMaxOccluders) {
      fields.fail("occluders", "must be a list of 1 to 4096 boxes");
    }
    for (size_t i = 0; i < list.size(); ++i) {
      const nlohmann::json box{{"box", list[i]}};
      JsonFields ofBox(box, fields.where() + ", \"occluders\" " + std::to_string(i + 1));
      options.occluders.push_back(readBox(ofBox, "box"));
    }
  }
  options.f = fields.number("f", -1, 1, options.f);
  options.maxF = fields.number("most_f", 0, 1, options.maxF);
  options.visibleShare = fields.number("visible_share", 0.01, 1, options.visibleShare);
  options.enlarged = fields.number("enlarged", 0, 10, options.enlarged);
  options.enlargedPixels = fields.number("enlarged_pixels", 0, 10000, options.enlargedPixels);
  options.maxChange = fields.number("max_change", 1e-4, 2, options.maxChange);
  if (fields.has("sight")) {
    options.sight = targetSight(fields.text("sight")).name;
  }
  return options;
}

}  // namespace ocelli
