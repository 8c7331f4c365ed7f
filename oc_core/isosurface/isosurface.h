// The surface where the field of a volume has one value, as a mesh.
//
// OpenVDB's extractor gives one vertex for each sheet of the surface in a cell between eight voxel centres, and a
// quadrilateral for each edge between voxel centres that the surface crosses (dual marching cubes). The vertices are
// then moved to where the field, interpolated trilinearly as everywhere (volume_grid.h), has the value.
//
// Inside is where the field is above the value, outside where it is not: triangles run counter-clockwise seen from
// lower values. Beyond the box of the volume there is nothing, so that a surface which reaches a face of the box is
// closed along it, there where the box ends. The mesh is closed: as many triangles run along each edge one way as the
// other; two as a rule, four where two sheets touch.
#pragma once

#include <cstddef>
#include <string>

#include "oc_core/base/progress.h"
#include "oc_core/scene/scene.h"
#include "oc_core/volume/volume_scene.h"

namespace ocelli {

struct IsosurfaceOptions {
  double value = 0;
  size_t maxTriangles = kMaxSceneTriangles;
  bool isShaded = true;  ///< by the fixed light of meshes (shading.h), with the gradient of the field as the normal
};

/// Whether this build can extract one: it needs OpenVDB.
bool canExtractIsosurfaces();

/// In the world of the scene. Its colour is that of the transfer function at the value; the clip planes and the
/// surfaces of the scene do not count. Reads the volume block by block, and keeps those blocks alone that the surface
/// runs through. `where` names the volume in errors. Throws InputError where no voxel is above the value, or all are,
/// where a voxel is no number, where there would be more triangles than that, and where this build has no
/// extractor.
Mesh isosurface(const VolumeScene& scene, const IsosurfaceOptions& options, const std::string& where,
                const Progress& progress = {});

}  // namespace ocelli
