#include "oc_core/volume_render/volume_reference.h"

#include <cmath>
#include <limits>

#include "oc_core/volume_render/ray_pieces.h"

namespace ocelli {

VolumeReference::VolumeReference(const VolumeScene& scene, double step, double depthOpacity)
    : scene_(scene),
      step_(step),
      depthOpacity_(depthOpacity),
      lighting_(scene, valueRange(*scene.volume)),
      surfaces_(scene.surfaces.triangles.empty() ? nullptr : std::make_unique<RayScene>(scene.surfaces)) {}

VolumePixel VolumeReference::pixel(const RayPath& ray) const {
  VolumePixel pixel;
  const std::optional<Hit> surface = surfaces_ ? surfaces_->hit(ray) : std::nullopt;
  const double end = surface ? static_cast<double>(surface->t) : std::numeric_limits<double>::infinity();
  VolumeExtent::Pieces pieces;
  const size_t count = VolumeExtent(scene_).cut(ray, end, pieces);
  const double longest = step_ * scene_.volume->grid().meanSpacing();
  glm::dvec3 color(0);
  double transmittance = 1;
  for (size_t i = 0; i < count; ++i) {
    const VolumeRayPiece& piece = pieces[i];
    const auto steps = static_cast<size_t>(std::max(1.0, std::ceil(piece.length / longest)));
    const double step = piece.length / static_cast<double>(steps);
    for (size_t k = 0; k < steps; ++k) {
      const double way = (static_cast<double>(k) + 0.5) * step;
      const glm::dvec3 index = piece.from + piece.way * way;
      const OpticalSample sample = scene_.appearance.transfer.at(scene_.volume->fieldAt(index));
      const PlaceLight<double> light = scene_.appearance.shading.isOn && sample.extinction > 0
                                           ? lighting_.at(index, piece.direction)
                                           : PlaceLight<double>{};
      const double before = transmittance;
      transmittance *= std::exp(-sample.extinction * step);
      color += (before - transmittance) * (sample.color * light.factor + light.added);
      if (std::isinf(pixel.t) && 1 - transmittance >= depthOpacity_) {
        // Within a step light is lost exponentially.
        const double share = std::log(before / (1 - depthOpacity_)) / (sample.extinction * step);
        pixel.t = static_cast<float>(piece.t + piece.tByLength * (static_cast<double>(k) + share) * step);
      }
    }
    pixel.samples += static_cast<uint32_t>(steps);
  }
  if (surface) {
    pixel.surfaceT = surface->t;
    color += transmittance * glm::dvec3(surface->color);
    transmittance = 0;
  }
  pixel.color = glm::vec4(glm::vec3(color), static_cast<float>(1 - transmittance));
  return pixel;
}

}  // namespace ocelli
