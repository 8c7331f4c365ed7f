// From what a user writes (`SCENE` on the command line) to the mesh that everything downstream takes.
//
// SCENE is a file that Assimp reads, `builtin:NAME[,key=value...]` (see builtin_scenes.h), of a moving scene at a time,
// a folder of numbered meshes, or a volume (oc_core/volume), of which a surface is taken.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/scene/mesh.h"
#include "oc_core/scene/mesh_series.h"
#include "oc_core/scene/point_cloud.h"
#include "oc_core/scene/scene_file.h"
#include "oc_core/scene/scene_guides.h"

namespace ocelli {

struct VolumeSceneOptions;

enum class Shading {
  kLambert,  ///< vertex colours times a fixed light, baked (see shading.h)
  kNone,     ///< vertex colours as they are
};

/// Of a SCENE that moves in time (scene_motion.h).
struct MotionOptions {
  /// The moment of its motion that is taken; nothing: it is taken as it is at rest, as a still scene.
  std::optional<double> seconds{};
  std::string animation{};                  ///< of a file: its name, or its number from 1 on; empty: the first one
  std::optional<double> meshesPerSecond{};  ///< of a folder of meshes; nothing: 24
  BetweenMeshes between = BetweenMeshes::kHold;
};

/// Texts in a scene that is no volume and not packed.
struct LabelOptions {
  std::string file{};         ///< a table (oc_core/labels/label_table.h); empty: none
  glm::vec3 facing{0, 0, 1};  ///< from where those can be read that do not say it themselves; not 0
};

struct SceneOptions {
  bool fit = true;  ///< into the unit sphere
  Shading shading = Shading::kLambert;
  bool textures = true;                              ///< bake the textures of a file to vertex colours
  size_t textureTriangles = kUsualTextureTriangles;  ///< as SceneFileOptions has it
  MotionOptions motion{};
  PointSceneOptions points{};  ///< of a scene of points
  LabelOptions labels{};
  /// Of a volume (oc_core/volume): the scene is the surface at this value (oc_core/isosurface). Without it a volume is
  /// no mesh.
  std::optional<double> iso{};
  std::string transfer{};  ///< of a volume: whose colours it has, as VolumeSceneOptions::transfer
  std::string series{};    ///< of a folder of DICOM files: as VolumeSceneOptions::series
  /// Is told what the user should know of the scene, a sentence each: a texture that is missing, for example.
  std::function<void(const std::string&)> warn{};
};

/// A scene with what its mesh alone does not say.
struct GuidedScene {
  Mesh mesh;
  std::vector<uint32_t> objectOfTriangle;  ///< the identity of each triangle of `mesh`; 0 is structure
  SceneGuides guides;                      ///< in the world of `mesh`
  glm::mat4 worldFromScene{1};             ///< what fitted it: a uniform scale and a translation
  std::optional<PointFacts> points = {};   ///< of a scene of points, in its units before it was fitted
};

/// What of them concerns a volume (oc_core/volume/volume_scene.h).
VolumeSceneOptions volumeOptionsOf(const SceneOptions& options);

/// What of them concerns the files of a scene.
SceneFileOptions fileOptionsOf(const SceneOptions& options);
/// Throws InputError for a volume of which no surface is asked, and where one is asked of what is no volume.
void requireSurfaceOfVolume(const std::string& source, const SceneOptions& options);
/// The surface of a volume, fitted as the volume itself is, so that it lies in it.
GuidedScene loadVolumeSurface(const std::string& source, const SceneOptions& options, const Progress& progress = {});
/// Throws InputError where something is said of points and the scene has none.
void refuseUnusedPoints(const std::optional<PointFacts>& points, const SceneOptions& options);

/// Throws InputError for a spec or a file that is wrong, where a moment is asked of a scene that stands still, and
/// where the size of points is told of a scene that has none.
GuidedScene loadGuidedScene(const std::string& source, const SceneOptions& options = {}, const Progress& progress = {});

/// The scene as one validated mesh. Throws InputError for a spec or a file that is wrong.
Mesh loadScene(const std::string& source, const SceneOptions& options = {}, const Progress& progress = {});

}  // namespace ocelli
