#include "oc_core/volume/volume_scene.h"

#include <cmath>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/scene/scene.h"
#include "oc_core/volume/builtin_volumes.h"
#include "oc_core/volume/transfer_presets.h"

namespace ocelli {

double VolumeScene::sceneLengthOfUnit() const {
  return std::cbrt(std::abs(glm::determinant(glm::dmat3(worldFromIndex)))) / volume->grid().meanSpacing();
}

bool isVolumeSource(const std::string& source) {
  return isBuiltinVolume(source);
}

VolumeScene loadVolumeScene(const std::string& source, const VolumeSceneOptions& options, const Progress& progress) {
  report(progress, "loading the volume", 0);
  if (!isBuiltinVolume(source)) {
    throw InputError("this is no volume", source, "give builtin:volume,name=NAME");
  }
  BuiltinVolume made = makeBuiltinVolume(source);
  made.appearance = options.transfer.empty()
                        ? std::move(made.appearance)
                        : appearanceOf(transferByName(options.transfer), made.volume, made.volume.grid().meanSpacing());
  VolumeScene scene{.volume = std::make_shared<ScalarVolume>(std::move(made.volume)),
                    .appearance = std::move(made.appearance),
                    .clips = options.clips};
  const VolumeGrid& grid = scene.volume->grid();
  scene.worldFromIndex = grid.isAnatomical ? sceneFromPatient() * grid.worldFromIndex : grid.worldFromIndex;
  if (options.fit) {
    const Box box = scene.bounds();
    const double radius = glm::length(glm::dvec3(box.size())) / 2;
    scene.worldFromIndex = glm::dmat4(unitFromSphere(glm::dvec3(box.center()), radius, source)) * scene.worldFromIndex;
  }
  report(progress, "loading the volume", 1);
  return scene;
}

}  // namespace ocelli
