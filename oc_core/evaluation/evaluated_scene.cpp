#include "oc_core/evaluation/evaluated_scene.h"

#include <fmt/format.h>

#include "oc_core/ocri/union_mesh.h"
#include "oc_core/scene/winding_number.h"

namespace ocelli {

void MeshScene::requireViewpoint(const glm::vec3& eye) const {
  requireOutside(mesh_, eye, fmt::format("viewpoint ({:.3g}, {:.3g}, {:.3g}) of the view cell", eye.x, eye.y, eye.z));
}

Mesh MeshScene::depthImageMesh(const PinholeCamera& reference) const {
  return unionMesh({buildDepthImage(reference, mesh_)});
}

Mesh TargetScene::depthImageMesh(const PinholeCamera& reference) const {
  const TargetRenderer renderer(target_);
  return unionMesh({buildDepthImage(reference, renderer.mesh(), &renderer)});
}

}  // namespace ocelli
