#include "oc_core/ocri/reference_image.h"

#include <algorithm>

#include "oc_core/base/parallel.h"
#include "oc_core/ocri/construction.h"

namespace ocelli {

size_t ReferenceImage::sampleCount() const {
  return static_cast<size_t>(std::count_if(z.begin(), z.end(), [](float depth) { return depth > 0; }));
}

ReferenceImage referenceImage(const FragmentImage& fragments, const Mesh& mesh, const PinholeCamera& reference,
                              const std::string& camera) {
  const int width = fragments.width();
  const int height = fragments.height();
  ReferenceImage image{camera, reference.view(), Image<glm::vec3>(width, height), Image<float>(width, height),
                       Image<glm::vec2>(width, height)};
  parallelFor(static_cast<size_t>(height), 8, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < width; ++x) {
        const Fragment& fragment = fragments(x, y);
        if (!fragment.covered()) {
          continue;
        }
        const ImagePoint q = reference.imageFromCamera(reference.cameraFromWorld(positionOf(fragment, mesh)));
        image.color(x, y) = colorOf(fragment, mesh);
        image.z(x, y) = q.z;
        image.displacement(x, y) = {static_cast<float>(x) + 0.5f - q.u, static_cast<float>(y) + 0.5f - q.v};
      }
    }
  });
  return image;
}

ReferenceImage depthImage(const FragmentImage& seen, const PinholeCamera& camera, const Mesh& mesh) {
  ReferenceImage image = referenceImage(seen, mesh, camera, "di");
  // A pinhole displaces nothing: what is left is rounding.
  std::fill(image.displacement.begin(), image.displacement.end(), glm::vec2(0));
  return image;
}

ReferenceImage buildDepthImage(const PinholeCamera& camera, const Mesh& mesh, const SceneRenderer* renderer) {
  return depthImage(seenFrom(camera, mesh, renderer), camera, mesh);
}

}  // namespace ocelli
