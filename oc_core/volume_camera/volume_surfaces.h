// Opaque surfaces inside of volumes: meshes that stand where the volume's own coordinates say.
#pragma once

#include <string>

#include "oc_core/base/progress.h"
#include "oc_core/volume/volume_scene.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {

/// Which coordinates the mesh has.
enum class SurfaceFrame {
  kVolume,  ///< the world of the volume's grid: what its file says, of patients LPS
  kScene,   ///< the scene's, where the volume stands now: as meshes that the toolkit wrote of it
};

/// From the world of the volume's grid to the scene.
glm::dmat4 sceneFromGridWorld(const VolumeScene& scene);

/// Loads a mesh, moves it, lights it as `options.shading` says, and makes it the surfaces of the scene. The other
/// options are those of every mesh; it is not fitted by itself. Throws as loadScene() does.
void addSurfaces(VolumeScene& scene, const std::string& source, SurfaceFrame frame, SceneOptions options,
                 const Progress& progress = {});
/// The same of a mesh, with the colours that it has; `isLit`: times the fixed light of meshes (shading.h). `where`
/// names it in errors. Throws InputError where its places in the scene are no numbers.
void addSurfaces(VolumeScene& scene, const Mesh& mesh, SurfaceFrame frame, bool isLit, const std::string& where);

}  // namespace ocelli
