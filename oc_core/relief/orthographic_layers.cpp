#include "oc_core/relief/orthographic_layers.h"

#include <algorithm>

#include "oc_core/base/check.h"
#include "oc_core/base/parallel.h"
#include "oc_core/render/raycast.h"

namespace ocelli {
namespace {

/// By which the next ray begins below a surface, of the size of the box.
constexpr float kStepBelow = 1e-5f;

}  // namespace

glm::vec3 OrthographicLayers::pixelsOf(const glm::vec3& point) const {
  const glm::vec3 size = box.size();
  const glm::vec3 from = point - box.lower;
  return {size.x > 0 ? from.x / size.x * static_cast<float>(width) : 0.5f,
          size.z > 0 ? from.z / size.z * static_cast<float>(height) : 0.5f, size.y > 0 ? from.y / size.y : 0.0f};
}

OrthographicLayers orthographicLayers(const SurfaceLabels& labels, int width, int height, int layers) {
  OC_CHECK(width > 0 && height > 0 && layers > 0 && layers < 256, "an image of layers has pixels");
  OrthographicLayers images{.box = boundsOf(labels.mesh()),
                            .width = width,
                            .height = height,
                            .counts = Image<uint8_t>(width, height, 0),
                            .heights = {},
                            .surfaces = {}};
  for (int layer = 0; layer < layers; ++layer) {
    images.heights.emplace_back(width, height, 0.0f);
    images.surfaces.emplace_back(width, height);
  }
  if (images.box.empty()) {
    return images;
  }
  const RayScene rays(labels.mesh());
  const glm::vec3 size = images.box.size();
  const float extent = std::max({size.x, size.y, size.z, 1e-6f});
  parallelFor(static_cast<size_t>(height), 4, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < width; ++x) {
        glm::vec3 from = images.box.lower;
        from.x += (static_cast<float>(x) + 0.5f) / static_cast<float>(width) * size.x;
        from.z += (static_cast<float>(y) + 0.5f) / static_cast<float>(height) * size.z;
        from.y = images.box.upper.y + extent;
        const glm::vec3 to(from.x, images.box.lower.y - extent, from.z);
        for (size_t layer = 0; layer < images.layers() && from.y > to.y; ++layer) {
          const Fragment fragment = rays.intersect({from, to});
          if (!fragment.covered()) {
            break;
          }
          const float at = positionOf(fragment, labels.mesh()).y;
          images.heights[layer](x, y) = size.y > 0 ? (at - images.box.lower.y) / size.y : 0.0f;
          images.surfaces[layer](x, y) = labels.surfaceOf(fragment.triangle, fragment.b1, fragment.b2);
          ++images.counts(x, y);
          from.y = std::min(at, from.y) - kStepBelow * extent;
        }
      }
    }
  });
  return images;
}

}  // namespace ocelli
