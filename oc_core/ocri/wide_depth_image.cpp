#include "oc_core/ocri/wide_depth_image.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/render/frustum_clip.h"

namespace ocelli {
namespace {

/// The position of a point on the image plane in halves of its width and height, the larger of the two; infinite where
/// it has none.
float extentOf(const PinholeCamera& camera, const glm::vec3& world) {
  const auto q = camera.project(world);
  if (!q) {
    return std::numeric_limits<float>::infinity();
  }
  const float halfWidth = static_cast<float>(camera.width()) / 2;
  const float halfHeight = static_cast<float>(camera.height()) / 2;
  return std::max(std::abs(q->u - halfWidth) / halfWidth, std::abs(q->v - halfHeight) / halfHeight);
}

/// The farthest extent, seen by `reference`, of what the frustum of `camera` holds of the triangle.
float extentWithin(const PinholeCamera& camera, const Mesh& mesh, const glm::uvec3& t, const PinholeCamera& reference) {
  const ClipPolygon polygon =
      clipToFrustum({camera.cameraFromWorld(mesh.positions[t.x]), camera.cameraFromWorld(mesh.positions[t.y]),
                     camera.cameraFromWorld(mesh.positions[t.z])},
                    camera, 0);
  float extent = 0;
  for (size_t i = 0; i < polygon.count; ++i) {
    extent = std::max(extent, extentOf(reference, camera.worldFromCamera(polygon.vertices[i].p)));
  }
  return extent;
}

/// Pixels on both sides of `pixels` that make them `factor` times as many.
int marginOf(int pixels, float factor) {
  return static_cast<int>(std::ceil(static_cast<double>(pixels) * (static_cast<double>(factor) - 1) / 2 - 1e-6));
}

}  // namespace

float wideFactor(const PinholeCamera& reference, const Mesh& mesh, const ViewCell& cell) {
  std::vector<PinholeCamera> cameras;
  for (const View& view : cell.edgeViews(reference.view())) {
    cameras.emplace_back(view, reference.width(), reference.height());
  }
  constexpr size_t kChunks = 64;
  std::vector<float> extents(kChunks, 1.0f);
  parallelChunks(mesh.triangles.size(), kChunks, [&](size_t chunk, size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const glm::uvec3& t = mesh.triangles[i];
      // No part of a triangle lies farther out than its corners, as long as these have images.
      const float farthest =
          std::max({extentOf(reference, mesh.positions[t.x]), extentOf(reference, mesh.positions[t.y]),
                    extentOf(reference, mesh.positions[t.z])});
      if (farthest > extents[chunk]) {
        for (const PinholeCamera& camera : cameras) {
          extents[chunk] = std::max(extents[chunk], extentWithin(camera, mesh, t, reference));
        }
      }
    }
  });
  const float factor = *std::max_element(extents.begin(), extents.end());
  if (!std::isfinite(factor)) {
    throw InputError("the view cell is so close to the scene that no planar image holds what its viewpoints see",
                     "--cell", "make the cell smaller or move the eye away");
  }
  return factor;
}

ReferenceImage buildWideDepthImage(const PinholeCamera& reference, const Mesh& mesh, float factor,
                                   const SceneRenderer* renderer) {
  if (!(factor >= 1) || factor > static_cast<float>(PinholeCamera::kMaxPixelsASide)) {
    throw InputError("a depth image " + std::to_string(factor) + " times as wide cannot be made", "wide factor",
                     "choose 1 or more");
  }
  const int width = reference.width() + 2 * marginOf(reference.width(), factor);
  const int height = reference.height() + 2 * marginOf(reference.height(), factor);
  View view = reference.view();
  // The focal length in pixels stays, and so does the shift of the centre.
  view.fovVerticalDegrees = degreesFromRadians(2 * std::atan(height / 2.0 / reference.focalPixels()));
  view.centerShift *= static_cast<float>(reference.height()) / static_cast<float>(height);
  ReferenceImage image = buildDepthImage(PinholeCamera(view, width, height), mesh, renderer);
  image.camera = "di-wide";
  return image;
}

}  // namespace ocelli
