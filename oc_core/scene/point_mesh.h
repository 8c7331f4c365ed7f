// Points as geometry, so that all that takes meshes takes them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/scene/mesh.h"
#include "oc_core/scene/point_cloud.h"

namespace ocelli {

struct PointMesh {
  Mesh mesh;
  PointFacts facts;
};

/// Each point in its colour, in the order of the file, where another point does not stand there before it
/// (to the rounding of floats from -1 to 1, over the box of all points):
///
/// - where it has a normal, or its neighbours lie about in a plane, a panel in that plane: a rectangle of two
///   triangles,
///   just so large that the surface is closed: it holds the Voronoi cell among the neighbours (point_shape.h);
/// - otherwise, as along a line, in a cloud that fills space, or at a sharp edge, a closed octahedron that reaches the
///   neighbours.
///
/// Estimated normals are turned outwards (point_orientation.h). A point far from all others is no larger than four
/// times the median. With PointSceneOptions::width panels are squares, and octahedra as high, of that width.
///
/// Throws InputError naming `where` where there is no point or a coordinate is not a finite number, where all points
/// stand at one place and no width is given, or where the mesh would have more than kMaxSceneTriangles. Takes 150 to
/// 200 bytes a point besides the mesh. `sources` gets of each vertex of the mesh the point that it is of.
PointMesh meshOfPoints(PointCloud cloud, const PointSceneOptions& options, const std::string& where,
                       const Progress& progress = {}, std::vector<uint32_t>* sources = nullptr);

}  // namespace ocelli
