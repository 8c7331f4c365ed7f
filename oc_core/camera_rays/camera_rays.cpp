#include "oc_core/camera_rays/camera_rays.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/scene/winding_number.h"

namespace ocelli {

bool needsScene(const CameraChoice& choice) {
  return !choice.kind->ofViewAlone;
}

RayMap rayMapOf(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh, int image,
                const Progress& progress) {
  if (!choice.hasImages()) {
    throw InputError("\"" + choice.name + "\" is a mesh, which has no rays", "camera", "choose one with an image");
  }
  if (needsScene(choice)) {
    requireOutside(mesh, reference.eye(), "view");
  }
  std::vector<CameraMap> maps = cameraMaps(choice, reference, mesh, {}, progress);
  if (maps.empty()) {
    // Some cameras are known by their images alone.
    maps = cameraMaps(choice, reference, mesh, buildReferenceImages(choice, reference, mesh, progress), progress);
  }
  const auto count = static_cast<int>(maps.size());
  if (image > count || image < 0 || (image == 0 && count != 1)) {
    throw InputError(fmt::format("\"{}\" has {} {}", choice.name, count, count == 1 ? "image" : "images"),
                     image == 0 ? "camera" : fmt::format("--image {}", image),
                     count == 1 ? "leave it out" : fmt::format("choose one with --image, from 1 to {}", count));
  }
  const CameraMap& map = maps[static_cast<size_t>(std::max(image - 1, 0))];
  RayMapNotes notes{.name = count == 1 ? choice.name : fmt::format("{} {}", choice.name, image),
                    .view = reference.view(),
                    .wrapsAround = map.wrapsAround};
  return RayMap::ofCamera(map.size.x > 0 ? map.size : glm::ivec2(reference.width(), reference.height()), map.ray,
                          std::move(notes), "camera \"" + choice.name + "\"", progress);
}

RayMap rayMapOf(const MultiperspectiveCamera& camera, const std::string& name, const View& view,
                const Progress& progress) {
  return std::visit(
      [&](const auto& each) {
        return RayMap::ofCamera(
            {each.width(), each.height()}, [&](const glm::vec2& pixel) { return each.rayPath(pixel); },
            {.name = std::filesystem::path(name).stem().string(), .view = view}, "camera \"" + name + "\"", progress);
      },
      camera);
}

RayMap rayMapOf(const VolumeCamera& camera, const View& view, const Progress& progress) {
  return RayMap::ofCamera(camera.size, camera.ray,
                          {.name = std::filesystem::path(camera.name).stem().string(), .view = view},
                          "camera \"" + camera.name + "\"", progress);
}

}  // namespace ocelli
