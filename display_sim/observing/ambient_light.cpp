#include "display_sim/observing/ambient_light.h"

#include <algorithm>
#include <cmath>

#include "display_sim/frames/sweep_geometry.h"
#include "display_sim/observing/exposure.h"
#include "display_sim/observing/eye_perspective.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

/// The rays of an eye, met with the cylinder that a screen sweeps.
class ScreenView {
 public:
  ScreenView(const ObserverOptions& options, const DisplayProfile& profile)
      : eye_(options), origin_(options.eye), halfHeight_(profile.halfHeightRadii) {}

  double coverage(double u, double v) const {
    const glm::dvec3 ray = eye_.ray(u, v);
    // Along the ray, from where it leaves the eye.
    double from = 0;
    double to = 1e12;
    const auto keep = [&](double first, double last) {
      from = std::max(from, first);
      to = std::min(to, last);
    };
    if (ray.y != 0) {
      const double top = (halfHeight_ - origin_.y) / ray.y;
      const double bottom = (-halfHeight_ - origin_.y) / ray.y;
      keep(std::min(top, bottom), std::max(top, bottom));
    } else if (std::abs(origin_.y) > halfHeight_) {
      return 0;
    }
    const double across = ray.x * ray.x + ray.z * ray.z;
    const double nearest = -(origin_.x * ray.x + origin_.z * ray.z);  // to the axis, times `across`
    if (across < 1e-18) {
      return 0;  // along the axis: the screen is seen from its edge
    }
    const double least = std::abs(origin_.x * ray.z - origin_.z * ray.x) / std::sqrt(across);  // distance from the axis
    if (least >= 1) {
      return 0;
    }
    const double half = std::sqrt((1 - least * least) / across);
    keep(nearest / across - half, nearest / across + half);
    if (to <= from) {
      return 0;
    }
    const auto angle = [&](double at) { return std::atan2((at - nearest / across) * std::sqrt(across), least); };
    return (angle(to) - angle(from)) / kPi;
  }

 private:
  EyePerspective eye_;
  glm::dvec3 origin_;
  double halfHeight_;
};

}  // namespace

double screenCoverage(const ObserverOptions& options, const DisplayProfile& profile, double u, double v) {
  return ScreenView(options, profile).coverage(u, v);
}

void addAmbientLight(Image<glm::vec3>& light, const DisplayProfile& profile, const ObserverOptions& options) {
  const EyePerspective eye(options);
  const SweepGeometry sweep(profile);
  const ScreenView screen(options, profile);
  const double halfTurns = exposedSweep(options, profile).radians() / kPi;
  const double scale = eye.distance / eye.pixelsPerTangent;
  const double white =
      kPi / 2 * profile.slicesPerHalfTurn * halfTurns * scale * scale / (sweep.columnWidth() * sweep.rowHeight());
  parallelFor(static_cast<size_t>(light.height()), 1, [&](size_t begin, size_t end) {
    for (size_t y = begin; y < end; ++y) {
      for (int x = 0; x < light.width(); ++x) {
        const double coverage = screen.coverage(x + 0.5, static_cast<double>(y) + 0.5);
        light(x, static_cast<int>(y)) += static_cast<float>(options.ambient * white * coverage);
      }
    }
  });
}

}  // namespace ocelli
