#include "display_sim/viewer/viewer_data.h"

namespace ocelli {

void ViewerData::take(GlContext& context, const WorkResult& result) {
  ++version;
  if (result.scene) {
    cameraMesh.reset();
    sceneMesh.reset();
    scene = nullptr;
    camera = nullptr;
    rays = nullptr;
    volume = nullptr;
    if (!result.scene->mesh.triangles.empty()) {
      sceneMesh.emplace(context, result.scene->mesh);
    }
    scene = result.scene;
  }
  if (result.camera) {
    cameraMesh.reset();
    camera = nullptr;
    rays = nullptr;
    cameraMesh.emplace(context, result.camera->representation.mesh);
    camera = result.camera;
  }
  if (result.rays) {
    rays = result.rays;
  }
  if (result.volume) {
    volume = result.volume;
  }
  if (result.error && result.step == WorkStep::kCamera) {
    cameraMesh.reset();
    camera = nullptr;
    rays = nullptr;
    volume = nullptr;
  }
  if (result.error && result.step == WorkStep::kVolume) {
    volume = nullptr;
  }
}

}  // namespace ocelli
