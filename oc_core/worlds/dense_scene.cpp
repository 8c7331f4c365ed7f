#include "oc_core/worlds/dense_scene.h"

#include "oc_core/base/check.h"
#include "oc_core/scene/densify.h"

namespace ocelli {

void densifyScene(Scene& scene, size_t triangles) {
  OC_CHECK(scene.meshes.size() == scene.instances.size(), "each mesh of a scene to densify is used once");
  const size_t now = triangleCount(scene);
  if (now >= triangles) {
    return;
  }
  size_t before = 0;  // triangles of the meshes so far, as they were
  size_t made = 0;    // of the same, as they are
  for (Mesh& mesh : scene.meshes) {
    before += mesh.triangles.size();
    // What is due to all meshes so far, so that shares that are rounded do not add up. 64 bits hold the product: both
    // are below kMaxSceneTriangles.
    const size_t due = before * triangles / now;
    densify(mesh, due > made ? due - made : 0);
    made += mesh.triangles.size();
  }
}

}  // namespace ocelli
