#include "display_sim/viewer/camera_rays.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <memory>

#include "oc_core/base/check.h"
#include "oc_core/ocri/eoc_builder.h"
#include "oc_core/ocri/spoc_builder.h"

namespace ocelli {
namespace {

template <class C>
RayFunction raysOf(C camera) {
  const auto shared = std::make_shared<const C>(std::move(camera));
  return [shared](const glm::vec2& pixel) { return shared->rayPath(pixel); };
}

RayFunction epipolarRays(const CameraChoice& choice, const glm::vec3& direction, const PinholeCamera& reference,
                         const Mesh& mesh) {
  return raysOf(buildEpipolarCamera(reference, segmentAround(reference.view(), direction, choice.cellSideRadii), mesh));
}

}  // namespace

std::vector<RayFunction> cameraRays(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh,
                                    const ReferenceImages& images, const Progress& progress) {
  using Model = CameraChoice::Model;
  switch (choice.model) {
    case Model::kDepthImage:
    case Model::kWideDepthImage:
    case Model::kCornerDepthImages:
    case Model::kLayeredDepthImage: {  // each image is of a pinhole, which it names
      std::vector<RayFunction> rays;
      for (const ReferenceImage& image : images) {
        rays.push_back(raysOf(PinholeCamera(image.view, image.width(), image.height())));
      }
      return rays;
    }
    case Model::kReversePinhole:
      return {raysOf(buildReversePinhole(reference, mesh))};
    case Model::kSpoc:
      return {raysOf(buildSpocCamera(reference, mesh))};
    case Model::kSpocUnion:
      return {raysOf(reference), raysOf(buildSpocCamera(reference, mesh))};
    case Model::kDdoc:
      return {raysOf(buildDdocCamera(reference, mesh, choice.ddoc, progress))};
    case Model::kEoc:
      return {epipolarRays(choice, choice.segmentDirection, reference, mesh)};
    case Model::kCrossedEocs:
    case Model::kCrossedEocsDdoc: {
      std::vector<RayFunction> rays{epipolarRays(choice, kHorizontalSegment, reference, mesh),
                                    epipolarRays(choice, kVerticalSegment, reference, mesh)};
      if (choice.model == Model::kCrossedEocsDdoc) {
        rays.push_back(raysOf(buildDdocCamera(reference, mesh, choice.ddoc, progress)));
      }
      return rays;
    }
    case Model::kCell:
      return {raysOf(buildCellCamera(reference, mesh, choice.cell, progress))};
    case Model::kSimplified:
    case Model::kSimplifiedSloppy:
    case Model::kGeometry:
      return {};
  }
  OC_CHECK(false, "every camera model has its rays");
}

std::vector<glm::vec3> rayBetween(const RayPath& ray, const PinholeCamera& reference, float nearest, float farthest) {
  std::vector<glm::vec3> part;
  for (size_t i = 0; i + 1 < ray.size(); ++i) {
    glm::vec3 from = ray[i];
    glm::vec3 to = ray[i + 1];
    float zFrom = reference.cameraFromWorld(from).z;
    float zTo = reference.cameraFromWorld(to).z;
    if (zFrom > zTo) {  // a ray may run backwards for a piece
      continue;
    }
    if (zTo < nearest || zFrom > farthest) {
      continue;
    }
    const glm::vec3 along = zTo > zFrom ? (to - from) / (zTo - zFrom) : glm::vec3(0);
    if (zTo > farthest) {
      to = from + along * (farthest - zFrom);
    }
    if (zFrom < nearest) {
      from += along * (nearest - zFrom);
    }
    if (part.empty()) {
      part.push_back(from);
    }
    part.push_back(to);
  }
  return part;
}

bool isBent(const std::vector<glm::vec3>& ray, float tolerance) {
  if (ray.size() < 3 || ray.front() == ray.back()) {
    return false;
  }
  const glm::vec3 direction = glm::normalize(ray.back() - ray.front());
  return std::ranges::any_of(
      ray, [&](const glm::vec3& point) { return glm::length(glm::cross(point - ray.front(), direction)) > tolerance; });
}

}  // namespace ocelli
