// Where the voxels of a volume lie.
//
// Index coordinates count voxels: the centre of voxel (i, j, k) is at (i, j, k), and the voxel is the unit cube around
// it, so a volume fills the box from (-0.5, -0.5, -0.5) to size - 0.5. A field between centres is interpolated
// trilinearly; in the half voxel between the outermost centres and the faces of the box it is that of the nearest point
// among the centres; outside of the box there is nothing.
#pragma once

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <string>

#include "oc_core/scene/box.h"

namespace ocelli {

struct VolumeGrid {
  glm::ivec3 size{0};            ///< voxels along i, j and k; i runs fastest in memory
  glm::dmat4 worldFromIndex{1};  ///< affine; it mirrors where the file's axes do
  std::string unit{};            ///< of the world's lengths: "mm"; empty where a file says none
  /// Whether the world is the body of a patient, as scanners have it: x to the left, y to the back, z to the head (LPS,
  /// the frame of DICOM), whatever the file's own frame was.
  bool isAnatomical = false;

  size_t voxelCount() const { return size_t(size.x) * size_t(size.y) * size_t(size.z); }
  /// The lengths of the voxels' edges, in the world.
  glm::dvec3 spacing() const;
  /// The world's units a voxel: the cube root of a voxel's volume.
  double meanSpacing() const;
};

/// The box of the voxels of a grid that stands elsewhere: `otherFromIndex` takes index coordinates there.
Box boundsOf(const VolumeGrid& grid, const glm::dmat4& otherFromIndex);

/// From the frame of patients (LPS) to that of scenes, y up, seen from the front: x to the left of the patient, which
/// is the right of who looks, y to the head, z to the front.
glm::dmat4 sceneFromPatient();

}  // namespace ocelli
