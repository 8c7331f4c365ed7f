#include "display_sim/solidity/opaque_image.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/render/rasterize.h"

namespace ocelli {

View viewOfObserver(const ObserverOptions& options) {
  View view;
  view.eye = options.eye;
  view.fovVerticalDegrees = options.fovVerticalDegrees;
  if (std::abs(glm::normalize(options.eye).y) > 0.99999f) {
    view.up = {0, 0, -1};
  }
  return view;
}

Image<Rgb8> opaqueImage(const Mesh& scene, const ObserverOptions& options) {
  const PinholeCamera camera(viewOfObserver(options), kOpaqueSamplesASide * options.width,
                             kOpaqueSamplesASide * options.height);
  return meanOfSamples(colorImage(rasterize(camera, scene), scene, glm::vec3(0)));
}

Image<Rgb8> meanOfSamples(const Image<glm::vec3>& samples) {
  Image<glm::vec3> light(samples.width() / kOpaqueSamplesASide, samples.height() / kOpaqueSamplesASide, glm::vec3(0));
  for (int y = 0; y < samples.height(); ++y) {
    for (int x = 0; x < samples.width(); ++x) {
      light(x / kOpaqueSamplesASide, y / kOpaqueSamplesASide) +=
          samples(x, y) / float{kOpaqueSamplesASide * kOpaqueSamplesASide};
    }
  }
  return srgbFromLinear(light);
}

}  // namespace ocelli
