#include "oc_core/scene/scene_source.h"

#include "oc_core/scene/builtin_scenes.h"
#include "oc_core/scene/scene.h"
#include "oc_core/scene/scene_file.h"
#include "oc_core/scene/shading.h"

namespace ocelli {

Mesh loadScene(const std::string& source, const SceneOptions& options, const Progress& progress) {
  report(progress, "loading the scene", 0);
  Mesh mesh = flatten(isBuiltinScene(source) ? makeBuiltinScene(source)
                                             : readSceneFile(source, {.textures = options.textures}));
  validate(mesh, source);
  report(progress, "loading the scene", 0.7);
  if (options.fit) {
    transform(mesh, unitFromWorld(mesh, source));
  }
  switch (options.shading) {
    case Shading::kLambert:
      bakeLambert(mesh);
      break;
    case Shading::kNone:
      break;
  }
  report(progress, "loading the scene", 1);
  return mesh;
}

}  // namespace ocelli
