// A mirror before a box and a wall.
#pragma once

#include "oc_core/shade/shaded_scene.h"
#include "oc_core/shade/vertex_normals.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli::test {

inline SpecularObject specularObject(Mesh mesh, double refractiveIndex = 1.5) {
  SpecularObject made{std::move(mesh), {}, refractiveIndex};
  made.normals = vertexNormals(made.mesh);
  return made;
}

/// The eye of smallCamera() at (0, 0, 10) sees a mirror of half side 0.5 at z = 0, which it looks at along the normal.
/// Before it, to the left and towards the eye, stands a red box; the wall of billboards is far behind the eye.
inline ShadedScene mirrorBeforeBox() {
  ShadedScene scene;
  scene.mirrors.push_back(specularObject(wall(0, 0.5f)));
  Mesh box = makeBox(glm::vec3(0.1f));
  paint(box, {0.8f, 0.1f, 0.1f});
  append(scene.cast, box, glm::translate(glm::mat4(1), {0.25f, 0.2f, 2}));
  addWall(scene.billboards, 12, 50, {0.1f, 0.6f, 0.1f});
  return scene;
}

}  // namespace ocelli::test
