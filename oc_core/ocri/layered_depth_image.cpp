#include "oc_core/ocri/layered_depth_image.h"

#include <algorithm>

#include "oc_core/base/error.h"
#include "oc_core/scene/closed_parts.h"

namespace ocelli {
namespace {

DrawnSides sidesOf(Closure closure) {
  switch (closure) {
    case Closure::kOpen:
      return DrawnSides::kBoth;
    case Closure::kFacesOut:
      return DrawnSides::kFront;
    case Closure::kFacesIn:
      return DrawnSides::kBack;
  }
  OC_CHECK(false, "every closure has its sides");
}

}  // namespace

std::vector<DrawnSides> visibleSides(const Mesh& mesh) {
  const std::vector<Closure> closures = closureOfTriangles(mesh);
  std::vector<DrawnSides> sides(closures.size());
  std::transform(closures.begin(), closures.end(), sides.begin(), sidesOf);
  return sides;
}

std::vector<ReferenceImage> buildLayeredDepthImage(const PinholeCamera& reference, const Mesh& mesh, int layers) {
  if (layers < 1 || layers > kMostLayers) {
    throw InputError("a layered depth image of " + std::to_string(layers) + " layers cannot be made", "layers",
                     "choose 1 to " + std::to_string(kMostLayers));
  }
  std::vector<ReferenceImage> images;
  for (const FragmentImage& fragments : rasterizeLayers(reference, mesh, layers, visibleSides(mesh))) {
    ReferenceImage image = referenceImage(fragments, mesh, reference, "ldi");
    // As in the depth image: a pinhole displaces nothing, what is left is rounding.
    std::fill(image.displacement.begin(), image.displacement.end(), glm::vec2(0));
    if (!images.empty() && image.sampleCount() == 0) {
      break;
    }
    images.push_back(std::move(image));
  }
  return images;
}

}  // namespace ocelli
