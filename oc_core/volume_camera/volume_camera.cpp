#include "oc_core/volume_camera/volume_camera.h"

#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/constructor/camera_constructors.h"
#include "oc_core/constructor/curved_bends.h"
#include "oc_core/constructor/graph_operations.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/volume_camera/first_hit_mesh.h"
#include "oc_core/volume_camera/guided_volume.h"

namespace ocelli {
namespace {

VolumeCamera multiperspectiveAt(const std::string& nameOrFile, const PinholeCamera& reference,
                                const VolumeScene& scene) {
  return std::visit(
      [&](auto camera) -> VolumeCamera {
        const auto shared = std::make_shared<const decltype(camera)>(std::move(camera));
        return {nameOrFile, jsonText(*shared), {shared->width(), shared->height()}, [shared](const glm::vec2& pixel) {
                  return shared->rayPath(pixel);
                }};
      },
      constructCamera(nameOrFile, guidedVolume(scene), reference));
}

/// What of the scene the camera is made from.
Mesh seenBy(const CameraChoice& choice, const PinholeCamera& reference,
            const std::function<const RayTarget&()>& firstHits, const Progress& progress) {
  if (choice.kind->ofViewAlone) {
    return {};
  }
  Mesh mesh = firstHitMesh(firstHits(), reference, choice.cellSideRadii, progress);
  if (mesh.empty()) {
    throw InputError("camera \"" + choice.name + "\" is made from what hides what, and no ray meets anything opaque",
                     "--camera", "turn the view to the volume, choose another --transfer, or a camera such as di");
  }
  return mesh;
}

}  // namespace

VolumeCamera volumeCamera(const std::string& nameOrFile, const PinholeCamera& reference, const VolumeScene& scene,
                          const std::function<const RayTarget&()>& firstHits, const Progress& progress) {
  if (namesConstructor(nameOrFile)) {
    return multiperspectiveAt(nameOrFile, reference, scene);
  }
  return volumeCamera(cameraChoice(nameOrFile), reference, firstHits, progress);
}

VolumeCamera volumeCamera(const CameraChoice& choice, const PinholeCamera& reference,
                          const std::function<const RayTarget&()>& firstHits, const Progress& progress) {
  if (!choice.hasImages()) {
    throw InputError("\"" + choice.name + "\" is a mesh, which has no rays", "--camera", "choose a camera, such as di");
  }
  const Mesh mesh = seenBy(choice, reference, firstHits, progress);
  std::vector<CameraMap> maps = cameraMaps(choice, reference, mesh, {}, progress);
  if (maps.empty()) {  // of pinholes that the images name
    maps = cameraMaps(choice, reference, mesh, buildReferenceImages(choice, reference, mesh, progress), progress);
  }
  if (maps.size() != 1) {
    throw InputError("\"" + choice.name + "\" is a union of " + std::to_string(maps.size()) + " images", "--camera",
                     "choose a camera of one image, such as ddoc or eoc-h");
  }
  CameraMap& map = maps.front();
  const nlohmann::ordered_json description{{"camera", choice.name},
                                           {"view", nlohmann::ordered_json::parse(jsonText(reference.view()))}};
  return {choice.name, description.dump(),
          map.size.x > 0 ? map.size : glm::ivec2(reference.width(), reference.height()), std::move(map.ray)};
}

}  // namespace ocelli
