#include "cli/viewed_scene.h"

#include "cli/scene_notes.h"
#include "oc_core/ocri/packed_view.h"
#include "oc_core/worlds/packed_source.h"

namespace ocelli {

ViewedScene::ViewedScene(const SceneChoice& scene, const CommandContext& context) {
  if (isPackedScene(scene.source)) {
    packed_.emplace(openPacked(scene.source, scene.options));
  } else {
    mesh_ = loadScene(scene.source, scene.options, context.progress());
    noteBlackScene(context, mesh_);
  }
}

const Mesh& ViewedScene::meshFor(const CameraChoice& choice, const PinholeCamera& reference) {
  if (packed_) {
    requireViewpointsOutside(*packed_, choice, reference);
    mesh_ = meshForView(*packed_, choice, reference);
  }
  return mesh_;
}

}  // namespace ocelli
