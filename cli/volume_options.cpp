#include "cli/volume_options.h"

#include <CLI/CLI.hpp>

#include "cli/number_check.h"
#include "cli/values.h"
#include "oc_core/base/error.h"
#include "oc_core/worlds/labelled_scene.h"

namespace ocelli {
namespace {

constexpr const char* kClipOption = "--clip";

/// What is said of meshes, and has no meaning for a volume.
void refuseMeshOptions(const SceneChoice& scene) {
  const auto refuse = [](bool isGiven, const char* option, const char* what) {
    if (isGiven) {
      throw InputError("this is a volume, which has no " + std::string(what), option,
                       "leave it out, or make a mesh of a surface with --iso VALUE");
    }
  };
  refuse(!scene.options.textures, "--no-textures", "textures");
  refuse(scene.options.textureTriangles != kUsualTextureTriangles, "--texture-triangles", "textures");
  refuse(scene.options.points.width.has_value(), "--point-size", "points");
  refuseLabelsOfVolume(scene.options.labels);
  refuse(!scene.options.motion.animation.empty(), "--animation", "animations");
  refuse(scene.options.motion.meshesPerSecond.has_value(), "--rate", "meshes");
  refuse(scene.options.motion.between != BetweenMeshes::kHold, "--between", "meshes");
}

}  // namespace

void addVolumeOptions(CLI::App& command, VolumeChoice& choice) {
  command
      .add_option(kClipOption, choice.clips,
                  "Of a volume: show the half space alone where, say, 'x>0.2' or 'z<0', or of a normal and a distance, "
                  "NX,NY,NZ,D, where the normal times the point is D or more; in the scene's coordinates. May be given "
                  "several times")
      ->type_name("HALFSPACE")
      ->allow_extra_args(false);
}

void addOpacityOption(CLI::App& command, std::optional<double>& opacity) {
  command
      .add_option("--opacity", opacity,
                  "Of a volume: its surface is where the opacity of what a ray has passed first reaches this; 0.5 by "
                  "default")
      ->check(numberCheck(0.001, 0.999))
      ->type_name("SHARE");
}

bool takesVolume(const SceneChoice& scene) {
  return !scene.options.iso && isVolumeSource(scene.source);
}

void refuseVolumeOption(bool isGiven, const std::string& option) {
  if (isGiven) {
    throw InputError("this scene has triangles: the option is for volumes alone", option,
                     "leave it out, or give a volume without --iso");
  }
}

void refuseVolumeOptions(const VolumeChoice& choice) {
  refuseVolumeOption(!choice.clips.empty(), kClipOption);
}

VolumeSceneOptions volumeSceneOptionsOf(const SceneChoice& scene, const VolumeChoice& choice) {
  refuseMeshOptions(scene);
  VolumeSceneOptions options = volumeOptionsOf(scene.options);
  for (const std::string& text : choice.clips) {
    const glm::dvec4 halfSpace = halfSpaceFromText(text, kClipOption);
    options.clips.push_back({glm::dvec3(halfSpace), halfSpace.w});
  }
  return options;
}

VolumeScene loadVolume(const SceneChoice& scene, const VolumeChoice& choice, const CommandContext& context) {
  VolumeScene loaded = loadVolumeScene(scene.source, volumeSceneOptionsOf(scene, choice), context.progress());
  applyShading(scene, loaded);
  return loaded;
}

void applyShading(const SceneChoice& scene, VolumeScene& volume) {
  if (scene.shadingGiven) {
    volume.appearance.shading.isOn = scene.options.shading == Shading::kLambert;
  }
}

}  // namespace ocelli
