#include "oc_core/ambient/ray_ambient.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "oc_core/ambient/surface_frame.h"
#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

/// The bits of i behind the binary point, in reverse order (van der Corput).
double mirroredBits(uint32_t i) {
  i = (i << 16) | (i >> 16);
  i = ((i & 0x00ff00ffu) << 8) | ((i & 0xff00ff00u) >> 8);
  i = ((i & 0x0f0f0f0fu) << 4) | ((i & 0xf0f0f0f0u) >> 4);
  i = ((i & 0x33333333u) << 2) | ((i & 0xccccccccu) >> 2);
  i = ((i & 0x55555555u) << 1) | ((i & 0xaaaaaaaau) >> 1);
  return static_cast<double>(i) * 0x1p-32;
}

double wrapped(double x) {
  return x - std::floor(x);
}

}  // namespace

glm::vec3 hemisphereDirection(int i, int count, const glm::vec2& shift) {
  const double area = wrapped((i + 0.5) / count + static_cast<double>(shift.x));
  const double turn =
      2 * std::numbers::pi * wrapped(mirroredBits(static_cast<uint32_t>(i)) + static_cast<double>(shift.y));
  const double radius = std::sqrt(area);
  return {radius * std::cos(turn), radius * std::sin(turn), std::sqrt(std::max(0.0, 1 - area))};
}

std::vector<float> ambientByRays(std::span<const AmbientPoint> points, const RayTarget& target,
                                 const AmbientOptions& options, const AmbientRays& rays) {
  validate(options);
  if (rays.count < 1 || rays.count > AmbientRays::kMaxRays) {
    throw InputError("ambient light takes 1 to " + std::to_string(AmbientRays::kMaxRays) + " rays a point",
                     std::to_string(rays.count) + " rays", "choose another number");
  }
  std::vector<float> light(points.size(), 1);
  if (!(options.radius > 0)) {
    return light;
  }
  const auto reach = static_cast<float>(options.radius);
  parallelFor(points.size(), 256, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const AmbientPoint& point = points[i];
      const SurfaceFrame frame(point.normal);
      const glm::vec2 shift(unitHash(point.pixel, 2 * rays.seed), unitHash(point.pixel, 2 * rays.seed + 1));
      const auto lift = static_cast<float>(rays.lift + rays.liftFootprints * static_cast<double>(point.footprint));
      const glm::vec3 origin = point.position + point.normal * lift;
      double hidden = 0;
      for (int k = 0; k < rays.count; ++k) {
        const glm::vec3 direction = frame.worldOf(hemisphereDirection(k, rays.count, shift));
        const std::optional<Hit> hit = target.hit({origin, origin + direction * reach});
        hidden += hit ? options.weight(static_cast<double>(hit->t)) : 0;
      }
      light[i] = static_cast<float>(std::clamp(1 - hidden / rays.count, 0.0, 1.0));
    }
  });
  return light;
}

}  // namespace ocelli
