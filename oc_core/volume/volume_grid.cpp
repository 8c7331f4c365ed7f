#include "oc_core/volume/volume_grid.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace ocelli {

glm::dvec3 VolumeGrid::spacing() const {
  return {glm::length(glm::dvec3(worldFromIndex[0])), glm::length(glm::dvec3(worldFromIndex[1])),
          glm::length(glm::dvec3(worldFromIndex[2]))};
}

double VolumeGrid::meanSpacing() const {
  return std::cbrt(std::abs(glm::determinant(glm::dmat3(worldFromIndex))));
}

Box boundsOf(const VolumeGrid& grid, const glm::dmat4& otherFromIndex) {
  Box box;
  Box index;
  index.lower = glm::vec3(-0.5f);
  index.upper = glm::vec3(grid.size) - 0.5f;
  for (const glm::vec3& corner : cornersOf(index)) {
    box.add(glm::vec3(otherFromIndex * glm::dvec4(corner, 1)));
  }
  return box;
}

glm::dmat4 sceneFromPatient() {
  return {glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 0, -1, 0), glm::dvec4(0, 1, 0, 0), glm::dvec4(0, 0, 0, 1)};
}

}  // namespace ocelli
