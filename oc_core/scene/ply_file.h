// PLY files (Greg Turk, Stanford 1994). They are read by our own reader, because Assimp's takes truncated files for
// whole ones, invents faces for them, or fills the memory.
//
// What is written is binary little-endian, with vertex colour: any mesh viewer opens it, and readPly() reads it back.
//
//   element vertex   float x y z; uchar red green blue (sRGB), left out where the mesh has no colours
//   element face     list uchar int vertex_indices
#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <string>

#include "oc_core/scene/mesh.h"
#include "oc_core/scene/point_cloud.h"

namespace ocelli {

/// Reads ascii and binary PLY of either byte order. The vertex element must have x, y and z, and may have sRGB colours
/// (red, green, blue, or r, g, b, or diffuse_red, ...) of any type: whole numbers fill the range of their type, others
/// run from 0 to 1. Faces with more than three corners become fans, strips of triangles (the element tristrips, in
/// whose lists -1 begins a new strip) triangles that all turn as the first of their strip. Everything else is skipped.
/// Throws InputError naming the file and the vertex or face for anything that is malformed, incomplete or out of range.
/// Memory is bounded by the mesh that results, and that by the size of the file.
Mesh readPly(const std::filesystem::path& path);
/// The same of a stream of `size` bytes; `where` stands in messages.
Mesh readPly(std::istream& stream, uint64_t size, const std::string& where);

/// Whether a PLY file holds points: it has vertices, and no faces and no strips of triangles. Throws InputError where
/// its header is malformed.
bool plyHoldsPoints(const std::filesystem::path& path);
/// The vertices of such a file, with their normals (nx, ny, nz), where they have some; what readPly() says holds for
/// the rest of them. Throws as that does, and where there are more than kMaxScenePoints.
PointCloud readPlyPoints(const std::filesystem::path& path);
PointCloud readPlyPoints(std::istream& stream, uint64_t size, const std::string& where);

/// What a PLY file holds, one after the other: for meshes that need not fit into memory.
class PlyVisitor {
 public:
  virtual ~PlyVisitor() = default;
  /// Before the first vertex.
  virtual void beginVertices(uint64_t count, bool colored) = 0;
  /// `color` is linear, and has no meaning where vertices have none.
  virtual void addVertex(const glm::vec3& position, const glm::vec3& color) = 0;
  /// After each vertex, where vertices have normals.
  virtual void addNormal(const glm::vec3& /*normal*/) {}
  /// Before the first face, of which each has one triangle or more, or strip, before both where a file has both.
  virtual void beginFaces(uint64_t count) = 0;
  /// Each corner is a vertex that came before.
  virtual void addTriangle(const glm::uvec3& corners) = 0;
};

/// Faces that the header of a PLY file tells of; 0 where it has none. Throws as readPly() does.
uint64_t plyFaceCount(const std::filesystem::path& path);

/// Visits what readPly() reads, and throws as that does. The memory that it takes does not depend on the file, which
/// may have `maxTriangles` triangles, and as many faces, and three times as many vertices.
void visitPly(const std::filesystem::path& path, PlyVisitor& visitor, uint64_t maxTriangles);

/// Writes the whole file or nothing: it grows under a temporary name in the same folder and gets its own at the end.
/// Throws WorkError naming the file where that fails. Memory use does not depend on the size of the mesh.
void writePly(const std::filesystem::path& path, const Mesh& mesh);

}  // namespace ocelli
