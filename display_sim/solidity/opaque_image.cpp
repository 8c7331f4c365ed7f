#include "display_sim/solidity/opaque_image.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/render/rasterize.h"

namespace ocelli {
namespace {

constexpr int kSamplesASide = 2;

/// That of EyePerspective.
View viewOf(const ObserverOptions& options) {
  View view;
  view.eye = options.eye;
  view.fovVerticalDegrees = options.fovVerticalDegrees;
  if (std::abs(glm::normalize(options.eye).y) > 0.99999f) {
    view.up = {0, 0, -1};
  }
  return view;
}

}  // namespace

Image<Rgb8> opaqueImage(const Mesh& scene, const ObserverOptions& options) {
  const PinholeCamera camera(viewOf(options), kSamplesASide * options.width, kSamplesASide * options.height);
  const Image<glm::vec3> samples = colorImage(rasterize(camera, scene), scene, glm::vec3(0));
  Image<glm::vec3> light(options.width, options.height, glm::vec3(0));
  for (int y = 0; y < samples.height(); ++y) {
    for (int x = 0; x < samples.width(); ++x) {
      light(x / kSamplesASide, y / kSamplesASide) += samples(x, y) / float{kSamplesASide * kSamplesASide};
    }
  }
  return srgbFromLinear(light);
}

}  // namespace ocelli
