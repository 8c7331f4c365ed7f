// A scene: meshes and where copies of them stand. Renderers take the flat mesh that flatten() makes of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/scene/mesh.h"
#include "oc_core/scene/point_cloud.h"
#include "oc_core/scene/scene_guides.h"

namespace ocelli {

/// A copy of a mesh, moved into the world.
struct Instance {
  size_t mesh = 0;
  glm::mat4 worldFromMesh{1};
  glm::vec3 tint{1};    ///< linear; multiplies the colours of the mesh
  uint32_t object = 0;  ///< its identity; 0 is the structure, such as floors, walls and what no one asks for
  bool isLit = true;    ///< false: its colours are light already, which a fixed light (shading.h) leaves as they are
};

struct Scene {
  std::string name;  ///< as the user wrote it
  std::vector<Mesh> meshes;
  std::vector<Instance> instances;
  SceneGuides guides;
  std::optional<PointFacts> points;   ///< of a file with points or lines; its meshes have them as geometry
  std::vector<std::string> warnings;  ///< what the user should know of the file, such as a missing texture

  /// Adds a mesh and one copy of it.
  void add(Mesh mesh, const glm::mat4& worldFromMesh = glm::mat4(1));
};

/// The most triangles that a scene may have: a guard against typing errors and hostile files, 1 GB as a flat mesh.
inline constexpr size_t kMaxSceneTriangles = 40'000'000;

/// Triangles that flatten() would make.
size_t triangleCount(const Scene& scene);

/// One mesh of all copies, in the order of the instances. It has colours where any mesh has some or any copy has a
/// tint.
Mesh flatten(const Scene& scene);

/// Of each vertex of the flat mesh: 1 where it is of a copy that is not lit, otherwise 0. Empty where all are lit.
std::vector<uint8_t> unlitVertices(const Scene& scene);

/// One copy alone: the vertices and triangles that it has in the flat mesh, with colours.
Mesh flattenInstance(const Scene& scene, size_t instance);

/// The identity of each triangle that flatten() makes.
std::vector<uint32_t> objectOfTriangles(const Scene& scene);

/// The uniform scale and translation that put the bounding sphere of `mesh` onto the unit sphere around the origin.
/// The sphere is the one around the centre of the bounding box that holds every vertex. Throws InputError naming
/// `where` if the mesh has no extent.
glm::mat4 unitFromWorld(const Mesh& mesh, const std::string& where);

/// The same of a sphere.
glm::mat4 unitFromSphere(const glm::dvec3& center, double radius, const std::string& where);
/// The distance of the farthest vertex from a point.
double reachOf(const Mesh& mesh, const glm::dvec3& center);

/// Moves every vertex. `newFromOld` must be affine and must not mirror: append() is the one that turns triangles round.
void transform(Mesh& mesh, const glm::mat4& newFromOld);

}  // namespace ocelli
