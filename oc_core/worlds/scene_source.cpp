#include "oc_core/worlds/scene_source.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/isosurface/isosurface.h"
#include "oc_core/scene/scene.h"
#include "oc_core/scene/shading.h"
#include "oc_core/volume/volume_scene.h"
#include "oc_core/worlds/labelled_scene.h"
#include "oc_core/worlds/packed_source.h"
#include "oc_core/worlds/scene_motion.h"

namespace ocelli {
namespace {

GuidedScene flattened(const Scene& scene) {
  return {flatten(scene), objectOfTriangles(scene), scene.guides, glm::mat4(1), scene.points};
}

/// What other commands take.
void refuseOwnFile(const std::string& source) {
  if (source.ends_with(".svol")) {
    throw InputError("this is a volume, which is sliced already", source,
                     "ocelli observe, ocelli present or ocelli volume info with it");
  }
  if (source.ends_with(".session")) {
    throw InputError("this is the log of a device", source, "ocelli present with it");
  }
  if (source.ends_with(".exr")) {
    throw InputError("this is an image; of a reference image ocelli slice and ocelli present take the mesh", source,
                     "ocelli ocri mesh, and its mesh with --no-fit --shading none");
  }
}

/// A moving scene at one time.
GuidedScene momentOf(const std::string& source, const SceneOptions& options, const Progress& progress) {
  const std::unique_ptr<SceneMotion> motion = loadMotion(source, options, progress);
  if (motion == nullptr) {
    throw InputError("this scene does not move", source, "leave out --time, or give a scene that moves");
  }
  const double seconds = *options.motion.seconds;
  if (!(seconds >= 0 && seconds <= motion->durationSeconds())) {
    throw InputError(fmt::format("this motion has no time {:g} s: it takes {:g} s", seconds, motion->durationSeconds()),
                     "--time", fmt::format("give a time from 0 to {:g}", motion->durationSeconds()));
  }
  Mesh mesh = motion->at(seconds);
  std::vector<uint32_t> objects(mesh.triangles.size(), 0);
  return {std::move(mesh), std::move(objects), {}, motion->worldFromScene(), motion->facts().points};
}

/// What is said of a motion where none is played.
void refuseUnusedMotion(const std::string& source, const SceneOptions& options) {
  if (std::error_code ignored; std::filesystem::is_directory(source, ignored)) {
    throw InputError("this is a folder; of numbered meshes in a folder a command takes one moment", source,
                     "--time 0 where the command has it, one of the meshes, or ocelli present");
  }
  if (!options.motion.animation.empty() || options.motion.meshesPerSecond) {
    throw InputError("an animation and a rate are of a moving scene at a time", source,
                     "give --time, or leave out --animation and --rate");
  }
}

}  // namespace

VolumeSceneOptions volumeOptionsOf(const SceneOptions& options) {
  return {.fit = options.fit,
          .transfer = options.transfer,
          .series = options.series,
          .seconds = options.motion.seconds,
          .warn = options.warn};
}

SceneFileOptions fileOptionsOf(const SceneOptions& options) {
  return {.textures = options.textures, .textureTriangles = options.textureTriangles, .points = options.points};
}

void refuseUnusedPoints(const std::optional<PointFacts>& points, const SceneOptions& options) {
  if (!points && options.points.width) {
    throw InputError("this scene has triangles, and no points or lines of a width", "--point-size", "leave it out");
  }
}

void requireSurfaceOfVolume(const std::string& source, const SceneOptions& options) {
  const bool isVolume = isVolumeSource(source);
  if (!isVolume && options.iso) {
    throw InputError("this scene is no volume, so it has no surface at a value", "--iso", "leave it out");
  }
  if (!isVolume && !options.series.empty()) {
    throw InputError("this scene is no volume, and only folders of DICOM files have series", "--series",
                     "leave it out");
  }
  if (!isVolume && !options.transfer.empty()) {
    throw InputError("this scene is no volume, so it has no transfer function", "--transfer", "leave it out");
  }
  if (isVolume && !options.iso) {
    throw InputError("this is a volume, which has no triangles", source,
                     "ocelli render draws it; for a mesh of a surface in it give --iso VALUE");
  }
}

GuidedScene loadVolumeSurface(const std::string& source, const SceneOptions& options, const Progress& progress) {
  requireSurfaceOfVolume(source, options);
  refuseUnusedPoints({}, options);
  refuseLabelsOfVolume(options.labels);
  if (!options.motion.animation.empty() || options.motion.meshesPerSecond ||
      options.motion.between != BetweenMeshes::kHold) {
    throw InputError("a volume has no animations or meshes", source, "leave out --animation, --rate and --between");
  }
  const VolumeScene volume = loadVolumeScene(source, volumeOptionsOf(options), progress);
  const IsosurfaceOptions surface{.value = *options.iso, .isShaded = options.shading == Shading::kLambert};
  GuidedScene loaded;
  loaded.mesh = isosurface(volume, surface, source, progress);
  loaded.objectOfTriangle.assign(loaded.mesh.triangles.size(), 0);
  const VolumeGrid& grid = volume.volume->grid();
  const glm::dmat4 sceneFromIndex = grid.isAnatomical ? sceneFromPatient() * grid.worldFromIndex : grid.worldFromIndex;
  loaded.worldFromScene = glm::mat4(volume.worldFromIndex * glm::inverse(sceneFromIndex));
  return loaded;
}

GuidedScene loadGuidedScene(const std::string& source, const SceneOptions& options, const Progress& progress) {
  refuseOwnFile(source);
  requireSurfaceOfVolume(source, options);
  report(progress, "loading the scene", 0);
  if (options.iso) {
    return loadVolumeSurface(source, options, progress);
  }
  if (options.motion.seconds) {
    return momentOf(source, options, progress);
  }
  refuseUnusedMotion(source, options);
  if (isPackedScene(source)) {
    refuseUnusedPoints({}, options);
    refuseLabels(options.labels, "a packed scene", "pack it with --labels");
    Mesh mesh = unpackedMesh(openPacked(source, options));
    std::vector<uint32_t> objects(mesh.triangles.size(), 0);
    return {std::move(mesh), std::move(objects), {}, glm::mat4(1)};
  }
  Scene scene = readLabelledScene(source, options, progress);
  refuseUnusedPoints(scene.points, options);
  for (const std::string& warning : scene.warnings) {
    if (options.warn) {
      options.warn(warning);
    }
  }
  if (const size_t triangles = triangleCount(scene); triangles > kMaxSceneTriangles) {
    throw InputError(fmt::format("this scene has {} triangles, more than the {} that fit into memory as one mesh",
                                 triangles, kMaxSceneTriangles),
                     source, "pack it with ocelli scene pack, and give the .opack file");
  }
  const std::vector<uint8_t> unlit = unlitVertices(scene);
  GuidedScene loaded = flattened(scene);
  scene = {};  // its memory, before its mesh is worked on
  Mesh& mesh = loaded.mesh;
  validate(mesh, source);
  report(progress, "loading the scene", 0.7);
  if (options.fit) {
    loaded.worldFromScene = unitFromWorld(mesh, source);
    transform(mesh, loaded.worldFromScene);
    loaded.guides = moved(loaded.guides, loaded.worldFromScene);
  }
  switch (options.shading) {
    case Shading::kLambert:
      bakeLambert(mesh, unlit);
      break;
    case Shading::kNone:
      break;
  }
  report(progress, "loading the scene", 1);
  return loaded;
}

Mesh loadScene(const std::string& source, const SceneOptions& options, const Progress& progress) {
  return loadGuidedScene(source, options, progress).mesh;
}

}  // namespace ocelli
