#include "oc_core/shade/stepped_proxy.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/render/ray_segment.h"

namespace ocelli {

glm::vec3 colorAround(const ReferenceImage& image, const glm::dvec2& place) {
  const double u = place.x - 0.5;
  const double v = place.y - 0.5;
  const auto x = static_cast<int>(std::floor(u));
  const auto y = static_cast<int>(std::floor(v));
  glm::vec3 sum(0);
  float weights = 0;
  for (int row = y; row <= y + 1; ++row) {
    for (int column = x; column <= x + 1; ++column) {
      if (image.t.contains(column, row) && image.holds(column, row)) {
        const auto weight = static_cast<float>((1 - std::abs(u - column)) * (1 - std::abs(v - row)));
        sum += image.color(column, row) * weight;
        weights += weight;
      }
    }
  }
  return weights > 0 ? sum / weights : sum;
}

SteppedTarget::SteppedTarget(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh,
                             ReferenceImages images, double finePixels, const Progress& progress)
    : images_(std::move(images)) {
  if (images_.size() != 1 || images_[0].isPlaced() || choice.kind->maps == nullptr) {
    throw InputError("rays cannot walk by steps along their projections in \"" + choice.name + "\"", "--by",
                     "take a camera of one image that displaces a pinhole's, such as di, spoc or ddoc, or leave "
                     "\"stepped\" away");
  }
  maps_ = cameraMaps(choice, reference, mesh, images_, progress);
  stepped_.emplace(images_[0], maps_[0], SteppingOptions{.finePixels = finePixels});
}

std::optional<SteppedHit> SteppedTarget::hit(const glm::vec3& origin, const glm::vec3& step, RayCost& cost) const {
  const StraightRay ray{origin, step, 1};
  if (!castable(origin, step) || !ray.hasDirection()) {
    return std::nullopt;
  }
  const std::optional<SteppedImage::Meeting> meeting = stepped_->meet(ray, cost);
  if (!meeting) {
    return std::nullopt;
  }
  return SteppedHit{colorAround(images_[0], meeting->place), static_cast<float>(meeting->share) * glm::length(step),
                    meeting->place, static_cast<float>(meeting->opacity)};
}

}  // namespace ocelli
