// Scenes by name, packed (oc_core/pack), and packed scenes as the mesh that everything downstream takes.
#pragma once

#include <filesystem>
#include <string>

#include "oc_core/pack/pack_scene.h"
#include "oc_core/pack/packed_scene.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {

/// Whether SCENE names a packed scene.
bool isPackedScene(const std::string& source);

/// Packs what SCENE names, fitted and shaded as `options` say. It may be larger than memory where it is made of copies
/// that are not, and where it is a PLY file (streamed_ply.h). Throws as loadScene() and packScene() do.
PackReport packSource(const std::string& source, const SceneOptions& options, const std::filesystem::path& path,
                      const Progress& progress = {});

/// Opens one. Throws InputError where `options` ask for another fit or shading than it was packed with.
PackedScene openPacked(const std::string& source, const SceneOptions& options);

/// What a packed scene says of where it comes from.
struct PackedOrigin {
  std::string scene;  ///< as it was given to `scene pack`; empty where the file does not say
  bool fit = false;
  std::string shading;
};
/// Throws InputError where its description is none.
PackedOrigin originOf(const PackedScene& scene);

/// All of it as one mesh. Throws InputError where it has more than kMaxSceneTriangles.
Mesh unpackedMesh(const PackedScene& scene);

}  // namespace ocelli
