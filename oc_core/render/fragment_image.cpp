#include "oc_core/render/fragment_image.h"

#include "oc_core/base/parallel.h"

namespace ocelli {

Image<glm::vec3> colorImage(const FragmentImage& fragments, const Mesh& mesh, const glm::vec3& background) {
  Image<glm::vec3> colors(fragments.width(), fragments.height(), background);
  parallelFor(fragments.size(), 1 << 14, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      if (fragments[i].covered()) {
        colors[i] = colorOf(fragments[i], mesh);
      }
    }
  });
  return colors;
}

}  // namespace ocelli
