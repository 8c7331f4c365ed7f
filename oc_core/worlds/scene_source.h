// From what a user writes (`SCENE` on the command line) to the mesh that everything downstream takes.
//
// SCENE is a file that Assimp reads, or `builtin:NAME[,key=value...]` (see builtin_scenes.h).
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/scene/mesh.h"
#include "oc_core/scene/scene_guides.h"

namespace ocelli {

enum class Shading {
  kLambert,  ///< vertex colours times a fixed light, baked (see shading.h)
  kNone,     ///< vertex colours as they are
};

struct SceneOptions {
  bool fit = true;  ///< into the unit sphere
  Shading shading = Shading::kLambert;
  bool textures = true;  ///< bake the textures of a file to vertex colours
  /// Is told what the user should know of the scene, a sentence each: a texture that is missing, for example.
  std::function<void(const std::string&)> warn{};
};

/// A scene with what its mesh alone does not say.
struct GuidedScene {
  Mesh mesh;
  std::vector<uint32_t> objectOfTriangle;  ///< the identity of each triangle of `mesh`; 0 is structure
  SceneGuides guides;                      ///< in the world of `mesh`
  glm::mat4 worldFromScene{1};             ///< what fitted it: a uniform scale and a translation
};

/// Throws InputError for a spec or a file that is wrong.
GuidedScene loadGuidedScene(const std::string& source, const SceneOptions& options = {}, const Progress& progress = {});

/// The scene as one validated mesh. Throws InputError for a spec or a file that is wrong.
Mesh loadScene(const std::string& source, const SceneOptions& options = {}, const Progress& progress = {});

}  // namespace ocelli
