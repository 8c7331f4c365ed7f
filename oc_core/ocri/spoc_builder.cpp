#include "oc_core/ocri/spoc_builder.h"

#include <array>

#include "oc_core/ocri/construction.h"
#include "oc_core/ocri/image_mesh.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/render/rasterize_subdivided.h"

namespace ocelli {
namespace {

/// The 1/z that parts samples into near and far ones with the greatest variance between the two (Otsu's threshold).
float inverseZBetween(const std::vector<float>& inverseZ) {
  constexpr size_t kBins = 256;
  const auto [least, greatest] = std::minmax_element(inverseZ.begin(), inverseZ.end());
  const float bin = (*greatest - *least) / kBins;
  if (!(bin > 0)) {
    return *least;
  }
  std::array<double, kBins> counts{};
  for (const float w : inverseZ) {
    ++counts[std::min(static_cast<size_t>((w - *least) / bin), kBins - 1)];
  }
  double total = 0;
  for (size_t i = 0; i < kBins; ++i) {
    total += counts[i] * static_cast<double>(i);
  }
  const auto all = static_cast<double>(inverseZ.size());
  double far = 0;
  double farSum = 0;
  double greatestVariance = -1;
  size_t split = 0;
  for (size_t i = 0; i + 1 < kBins; ++i) {
    far += counts[i];
    farSum += counts[i] * static_cast<double>(i);
    const double near = all - far;
    if (far > 0 && near > 0) {
      const double step = (total - farSum) / near - farSum / far;
      const double variance = far * near * step * step;
      if (variance > greatestVariance) {
        greatestVariance = variance;
        split = i + 1;
      }
    }
  }
  return *least + bin * static_cast<float>(split);
}

void addPoints(std::vector<glm::vec3>& points, const FragmentImage& fragments, const Mesh& mesh) {
  for (const Fragment& fragment : fragments) {
    if (fragment.covered()) {
      points.push_back(positionOf(fragment, mesh));
    }
  }
}

/// What the pinhole sees, and where the vertices are: hidden parts are part of the scene too.
std::vector<glm::vec3> pointsOf(const FragmentImage& seen, const Mesh& mesh) {
  std::vector<glm::vec3> points = mesh.positions;
  addPoints(points, seen, mesh);
  return points;
}

/// What the pinhole sees, and what lies farthest behind it.
std::vector<glm::vec3> pointsAlongRays(const FragmentImage& seen, const PinholeCamera& reference, const Mesh& mesh,
                                       const RayTarget& target) {
  std::vector<glm::vec3> points;
  addPoints(points, seen, mesh);
  const auto fromBehind = [&](const glm::vec2& pixel) {
    const RayPath path = reference.rayPath(pixel);
    return path.empty() ? RayPath{} : RayPath{path.back(), path.front()};
  };
  for (const std::optional<Hit>& hit : castRays(reference.width(), reference.height(), target, fromBehind)) {
    if (hit) {
      points.push_back(hit->position);
    }
  }
  return points;
}

ReferenceImage boundedBy(ReferenceImage image, const PinholeCamera& reference, const Mesh& mesh,
                         const SceneRenderer* renderer = nullptr) {
  image.triangleBound = imageMeshTriangles(buildDepthImage(reference, mesh, renderer));
  return image;
}

}  // namespace

SpocCamera buildSpocCamera(const PinholeCamera& reference, const Mesh& mesh, const SpocOptions& options,
                           const SceneRenderer* renderer) {
  const FragmentImage seen = seenFrom(reference, mesh, renderer);
  std::vector<float> inverseZ;
  for (const Fragment& fragment : seen) {
    if (fragment.covered()) {
      inverseZ.push_back(1 / fragment.t);
    }
  }
  std::vector<glm::vec3> foreground;
  if (!inverseZ.empty()) {
    const float between = inverseZBetween(inverseZ);
    for (const Fragment& fragment : seen) {
      if (fragment.covered() && 1 / fragment.t >= between) {
        foreground.push_back(positionOf(fragment, mesh));
      }
    }
  }
  const std::vector<glm::vec3> scene = renderer != nullptr && renderer->rays() != nullptr
                                           ? pointsAlongRays(seen, reference, mesh, *renderer->rays())
                                           : pointsOf(seen, mesh);
  return SpocCamera::aroundObject(reference, foreground, scene, options);
}

ReversePinholeCamera buildReversePinhole(const PinholeCamera& reference, const Mesh& mesh,
                                         const SceneRenderer* renderer) {
  const FragmentImage seen = seenFrom(reference, mesh, renderer);
  const bool hasMesh = renderer == nullptr || renderer->hasMesh();
  return ReversePinholeCamera::around(
      reference, hasMesh ? pointsOf(seen, mesh) : pointsAlongRays(seen, reference, mesh, *renderer->rays()));
}

ReferenceImage buildSpocImage(const SpocCamera& camera, const Mesh& mesh, const SceneRenderer* renderer) {
  const FragmentImage fragments = renderer != nullptr ? renderer->draw(camera) : rasterize(camera, mesh);
  return boundedBy(referenceImage(fragments, mesh, camera.reference(), "spoc"), camera.reference(), mesh, renderer);
}

ReferenceImage buildReversePinholeImage(const ReversePinholeCamera& camera, const PinholeCamera& reference,
                                        const Mesh& mesh, const SceneRenderer* renderer) {
  const FragmentImage fragments = renderer != nullptr ? renderer->draw(camera) : rasterize(camera, mesh);
  return boundedBy(referenceImage(fragments, mesh, reference, "rppc"), reference, mesh, renderer);
}

}  // namespace ocelli
