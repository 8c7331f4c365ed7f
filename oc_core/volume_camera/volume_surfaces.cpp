#include "oc_core/volume_camera/volume_surfaces.h"

#include <utility>

#include "oc_core/scene/shading.h"

namespace ocelli {

glm::dmat4 sceneFromGridWorld(const VolumeScene& scene) {
  return scene.worldFromIndex * glm::inverse(scene.volume->grid().worldFromIndex);
}

void addSurfaces(VolumeScene& scene, const std::string& source, SurfaceFrame frame, SceneOptions options,
                 const Progress& progress) {
  const bool isLit = options.shading == Shading::kLambert;
  options.fit = false;
  options.shading = Shading::kNone;
  addSurfaces(scene, loadScene(source, options, progress), frame, isLit, source);
}

void addSurfaces(VolumeScene& scene, const Mesh& mesh, SurfaceFrame frame, bool isLit, const std::string& where) {
  Mesh moved;
  append(moved, mesh, frame == SurfaceFrame::kVolume ? glm::mat4(sceneFromGridWorld(scene)) : glm::mat4(1));
  validate(moved, where);
  if (isLit) {
    bakeLambert(moved);
  }
  append(scene.surfaces, moved);
}

}  // namespace ocelli
