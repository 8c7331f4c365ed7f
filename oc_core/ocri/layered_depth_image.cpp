#include "oc_core/ocri/layered_depth_image.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/render/scene_renderer.h"
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

bool isSeen(const PinholeCamera& camera, const Image<float>& depths, const glm::vec3& point) {
  constexpr float kToleranceFootprints = 1.5f;  // of the strict measure of coverage.h
  const auto q = camera.project(point);
  if (!q || !depths.contains(static_cast<int>(std::floor(q->u)), static_cast<int>(std::floor(q->v)))) {
    return false;
  }
  const float nearest = q->t * (1 - kToleranceFootprints / camera.focalPixels());
  for (int dv = -1; dv <= 1; ++dv) {
    for (int du = -1; du <= 1; ++du) {
      const int u = static_cast<int>(std::floor(q->u)) + du;
      const int v = static_cast<int>(std::floor(q->v)) + dv;
      if (depths.contains(u, v) && (depths(u, v) == 0 || depths(u, v) >= nearest)) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

std::vector<DrawnSides> visibleSides(const Mesh& mesh) {
  const std::vector<Closure> closures = closureOfTriangles(mesh);
  std::vector<DrawnSides> sides(closures.size());
  std::transform(closures.begin(), closures.end(), sides.begin(), sidesOf);
  return sides;
}

ReferenceImages buildLayeredDepthImage(const PinholeCamera& reference, const Mesh& mesh, int layers,
                                       const SceneRenderer* renderer) {
  if (layers < 1 || layers > kMaxLayers) {
    throw InputError("a layered depth image of " + std::to_string(layers) + " layers cannot be made", "layers",
                     "choose 1 to " + std::to_string(kMaxLayers));
  }
  std::optional<std::vector<FragmentImage>> drawn =
      renderer != nullptr ? renderer->drawLayers(reference, layers) : std::nullopt;
  if (!drawn) {
    drawn = rasterizeLayers(reference, mesh, layers, visibleSides(mesh));
  }
  ReferenceImages images;
  for (const FragmentImage& fragments : *drawn) {
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

void dropUnseenSamples(ReferenceImages& layers, const Mesh& mesh, const ViewCell& cell) {
  if (layers.size() < 2) {
    return;
  }
  const PinholeCamera reference = layers[0].reference();
  const size_t width = static_cast<size_t>(reference.width());
  std::vector<Image<unsigned char>> seen(layers.size(), Image<unsigned char>(reference.width(), reference.height()));
  for (const View& view : cell.edgeViews(reference.view())) {
    const PinholeCamera camera(view, reference.width(), reference.height());
    const Image<float> depths = buildDepthImage(camera, mesh).t;
    for (size_t layer = 1; layer < layers.size(); ++layer) {
      parallelFor(depths.size(), 1 << 13, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
          const auto point =
              reference.unproject(layers[layer].undistorted(static_cast<int>(i % width), static_cast<int>(i / width)));
          seen[layer][i] |= point && isSeen(camera, depths, *point);
        }
      });
    }
  }
  for (size_t layer = 1; layer < layers.size(); ++layer) {
    for (size_t i = 0; i < seen[layer].size(); ++i) {
      if (seen[layer][i] == 0) {
        layers[layer].clear(i);
      }
    }
  }
}

}  // namespace ocelli
