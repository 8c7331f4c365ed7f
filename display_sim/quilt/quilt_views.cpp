#include "display_sim/quilt/quilt_views.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

View withFieldOfView(View view, double aspect) {
  validate(view, "the view");
  if (view.fovVerticalDegrees == 0) {
    const double half = radiansFromDegrees(view.resolvedFovVerticalDegrees()) / 2;
    view.fovVerticalDegrees = degreesFromRadians(2 * std::atan(std::tan(half) / std::min(aspect, 1.0)));
  }
  return view;
}

}  // namespace

QuiltViews::QuiltViews(QuiltDisplay display, const View& view)
    : display_(std::move(display)),
      view_(withFieldOfView(view, display_.aspect)),
      stretch_(1 / display_.pixelAspect()),
      right_(PinholeCamera(view_, 1, 1).right()) {
  cameras_.reserve(static_cast<size_t>(count()));
  for (int i = 0; i < count(); ++i) {
    cameras_.push_back(cameraAt(offset(i), stretch_, display_.tileWidth()));
  }
}

double QuiltViews::angleDegrees(int view) const {
  return display_.coneDegrees * (static_cast<double>(view) / (count() - 1) - 0.5);
}

double QuiltViews::offset(int view) const {
  const auto distance = static_cast<double>(glm::distance(view_.target, view_.eye));
  return distance * std::tan(radiansFromDegrees(angleDegrees(view)));
}

PinholeCamera QuiltViews::cameraAt(double offset, double stretch, int width) const {
  View view = view_;
  const auto move = right_ * static_cast<float>(offset * stretch);
  view.eye += move;
  view.target += move;
  // The target of the middle view keeps its pixel.
  const auto distance = static_cast<double>(glm::distance(view_.target, view_.eye));
  const double focalHeights = 0.5 / std::tan(radiansFromDegrees(view.fovVerticalDegrees) / 2);
  view.centerShift.x =
      static_cast<float>(stretch * (static_cast<double>(view.centerShift.x) + offset / distance * focalHeights));
  return {view, width, display_.tileHeight()};
}

PinholeCamera QuiltViews::middle(double stretch, int width) const {
  return cameraAt(0, stretch, width);
}

glm::vec3 QuiltViews::eyeIn(double stretch, int view) const {
  return view_.eye + right_ * static_cast<float>(offset(view) * stretch);
}

void QuiltViews::stretchScene(Mesh& scene, double factor) const {
  if (factor == 1) {
    return;
  }
  const auto more = static_cast<float>(factor - 1);
  parallelFor(scene.positions.size(), 1 << 14, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      glm::vec3& p = scene.positions[i];
      p += right_ * (more * glm::dot(p - view_.eye, right_));
    }
  });
}

}  // namespace ocelli
