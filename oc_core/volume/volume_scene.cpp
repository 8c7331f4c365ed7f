#include "oc_core/volume/volume_scene.h"

#include <cmath>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/scene/scene.h"
#include "oc_core/volume/builtin_volumes.h"
#include "oc_core/volume/transfer_presets.h"
#include "oc_core/volume/volume_reader.h"

namespace ocelli {
namespace {

/// The first one, where there are several. The look is what fits its values.
BuiltinVolume volumeOfFile(const std::string& path, const VolumeSceneOptions& options, const Progress& progress) {
  VolumeFile file = readVolumeFile(path, {.series = options.series}, progress);
  for (const std::string& warning : file.warnings) {
    if (options.warn) {
      options.warn(warning);
    }
  }
  ScalarVolume volume = std::move(file.volumes.front());
  VolumeAppearance appearance = appearanceOf(presetFor(volume).description, volume, volume.grid().meanSpacing());
  return {std::move(volume), std::move(appearance)};
}

}  // namespace

double VolumeScene::sceneLengthOfUnit() const {
  return std::cbrt(std::abs(glm::determinant(glm::dmat3(worldFromIndex)))) / volume->grid().meanSpacing();
}

bool isVolumeSource(const std::string& source) {
  return isBuiltinVolume(source) || isVolumeFile(source);
}

VolumeScene loadVolumeScene(const std::string& source, const VolumeSceneOptions& options, const Progress& progress) {
  report(progress, "loading the volume", 0);
  BuiltinVolume made = isBuiltinVolume(source) ? makeBuiltinVolume(source) : volumeOfFile(source, options, progress);
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
