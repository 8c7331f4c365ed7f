#include "oc_core/scene/scene_source.h"

#include <utility>

#include "oc_core/scene/builtin_scenes.h"
#include "oc_core/scene/scene.h"
#include "oc_core/scene/scene_file.h"
#include "oc_core/scene/shading.h"

namespace ocelli {
namespace {

/// Takes the scene, so that it is gone when its mesh is worked on.
GuidedScene flattened(Scene scene) {
  return {flatten(scene), objectOfTriangles(scene), std::move(scene.guides), glm::mat4(1)};
}

}  // namespace

GuidedScene loadGuidedScene(const std::string& source, const SceneOptions& options, const Progress& progress) {
  report(progress, "loading the scene", 0);
  GuidedScene loaded = flattened(isBuiltinScene(source) ? makeBuiltinScene(source)
                                                        : readSceneFile(source, {.textures = options.textures}));
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
      bakeLambert(mesh);
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
