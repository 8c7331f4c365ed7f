#include "oc_core/volume_camera/volume_camera.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <type_traits>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/camera/ray_smoothness.h"
#include "oc_core/constructor/camera_constructors.h"
#include "oc_core/constructor/curved_bends.h"
#include "oc_core/constructor/graph_operations.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/render/target_renderer.h"
#include "oc_core/volume_camera/guided_volume.h"

namespace ocelli {
namespace {

/// By so much of a voxel the polylines of bent rays may be off.
constexpr double kDeviation = 0.1;

RayFunction raysOf(const std::shared_ptr<const GraphCamera>& camera, const VolumeScene&) {
  return [camera](const glm::vec2& pixel) { return camera->rayPath(pixel); };
}

RayFunction raysOf(const std::shared_ptr<const CurvedRayCamera>& camera, const VolumeScene& scene) {
  double voxel = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    voxel = std::min(voxel, glm::length(glm::dvec3(scene.worldFromIndex[axis])));
  }
  // Surfaces have edges that are finer than voxels.
  const size_t points =
      scene.surfaces.empty() ? camera->arcPointsWithin(kDeviation * voxel) : CurvedRayCamera::kArcPoints;
  return [camera, points](const glm::vec2& pixel) { return camera->rayPath(pixel, points); };
}

std::vector<CameraMap> mapsOf(const CameraChoice& choice, const PinholeCamera& reference,
                              const std::function<const RayTarget&()>& firstHits, const Progress& progress) {
  if (choice.kind->ofViewAlone) {
    return cameraMaps(choice, reference, Mesh{}, {}, progress);
  }
  const TargetRenderer renderer(firstHits());
  std::vector<CameraMap> maps = cameraMaps(choice, reference, renderer, {}, progress);
  // Some cameras are known by their images alone.
  return maps.empty()
             ? cameraMaps(choice, reference, renderer, buildReferenceImages(choice, reference, renderer, progress))
             : maps;
}

}  // namespace

VolumeCamera volumeCamera(const std::string& nameOrFile, const PinholeCamera& reference, const VolumeScene& scene,
                          const std::function<const RayTarget&()>& firstHits, const Progress& progress) {
  if (namesConstructor(nameOrFile)) {
    return volumeCamera(nameOrFile, constructCamera(nameOrFile, guidedVolume(scene), reference), scene);
  }
  return volumeCamera(cameraChoice(nameOrFile), reference, firstHits, progress);
}

VolumeCamera volumeCamera(const CameraChoice& choice, const PinholeCamera& reference,
                          const std::function<const RayTarget&()>& firstHits, const Progress& progress) {
  if (!choice.hasImages()) {
    throw InputError("\"" + choice.name + "\" is a mesh, which has no rays", "--camera", "choose a camera, such as di");
  }
  std::vector<CameraMap> maps = mapsOf(choice, reference, firstHits, progress);
  if (maps.size() != 1) {
    throw InputError("\"" + choice.name + "\" is a union of " + std::to_string(maps.size()) + " images", "--camera",
                     "choose a camera of one image, such as ddoc or eoc-h");
  }
  CameraMap& map = maps.front();
  const nlohmann::ordered_json description{{"camera", choice.name},
                                           {"view", nlohmann::ordered_json::parse(jsonText(reference.view()))}};
  return {choice.name,
          description.dump(),
          map.size.x > 0 ? map.size : glm::ivec2(reference.width(), reference.height()),
          std::move(map.ray),
          std::move(map.hull),
          map.isSmooth};
}

VolumeCamera volumeCamera(const std::string& name, MultiperspectiveCamera camera, const VolumeScene& scene) {
  return std::visit(
      [&](auto& each) -> VolumeCamera {
        using Each = std::decay_t<decltype(each)>;
        const auto shared = std::make_shared<const Each>(std::move(each));
        return {name,
                jsonText(*shared),
                {shared->width(), shared->height()},
                raysOf(shared, scene),
                rayHullOf(shared),
                kHasSmoothRays<Each>};
      },
      camera);
}

}  // namespace ocelli
