#include "oc_core/volume_camera/guided_volume.h"

#include <glm/gtc/matrix_transform.hpp>

#include "oc_core/worlds/solids.h"

namespace ocelli {

GuidedScene guidedVolume(const VolumeScene& scene) {
  // The voxels fill the box from -0.5 to size - 0.5 in index coordinates.
  const glm::dvec3 half = glm::dvec3(scene.volume->grid().size) / 2.0;
  const glm::dmat4 worldFromBox = scene.worldFromIndex * glm::translate(glm::dmat4(1), half - 0.5);
  GuidedScene guided;
  append(guided.mesh, makeBox(glm::vec3(half)), glm::mat4(worldFromBox));
  guided.objectOfTriangle.resize(guided.mesh.triangles.size(), 0);
  append(guided.mesh, scene.surfaces);
  guided.objectOfTriangle.resize(guided.mesh.triangles.size(), kSurfacesObject);
  guided.guides.walk.emplace();  // nobody walks on its box
  return guided;
}

}  // namespace ocelli
