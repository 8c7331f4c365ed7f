#include "oc_core/ocri/simplified_mesh.h"

#include <meshoptimizer.h>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/scene/share_vertices.h"

namespace ocelli {
namespace {

static_assert(sizeof(glm::uvec3) == 3 * sizeof(unsigned int));

/// Returns how many indices were written.
size_t simplifyIndices(const Mesh& mesh, size_t targetTriangles, SimplifyMethod method, glm::uvec3* triangles,
                       float& relativeError) {
  constexpr float kAnyError = 1e9f;
  auto* indices = reinterpret_cast<unsigned int*>(triangles);
  const auto* source = reinterpret_cast<const unsigned int*>(mesh.triangles.data());
  const size_t count = mesh.triangles.size() * 3;
  const float* positions = &mesh.positions[0].x;
  switch (method) {
    case SimplifyMethod::kTopological:
      return meshopt_simplify(indices, source, count, positions, mesh.positions.size(), sizeof(glm::vec3),
                              targetTriangles * 3, kAnyError, 0, &relativeError);
    case SimplifyMethod::kSloppy:
      return meshopt_simplifySloppy(indices, source, count, positions, mesh.positions.size(), sizeof(glm::vec3),
                                    targetTriangles * 3, kAnyError, &relativeError);
  }
  OC_CHECK(false, "every method is handled");
}

}  // namespace

SimplifiedMesh simplifyMesh(const Mesh& mesh, size_t targetTriangles, SimplifyMethod method) {
  validate(mesh, "the mesh to simplify");
  if (targetTriangles == 0) {
    throw InputError("a mesh cannot be simplified to no triangles at all", "target", "choose 1 or more");
  }
  SimplifiedMesh simplified{mesh, targetTriangles, 0};
  shareVertices(simplified.mesh);
  if (targetTriangles >= mesh.triangles.size()) {
    return simplified;
  }
  std::vector<glm::uvec3> triangles(mesh.triangles.size());
  float relativeError = 0;
  const size_t indices = simplifyIndices(simplified.mesh, targetTriangles, method, triangles.data(), relativeError);
  const Mesh& welded = simplified.mesh;
  simplified.error =
      relativeError * meshopt_simplifyScale(&welded.positions[0].x, welded.positions.size(), sizeof(glm::vec3));
  triangles.resize(indices / 3);
  simplified.mesh.triangles = std::move(triangles);
  dropUnusedVertices(simplified.mesh);
  return simplified;
}

}  // namespace ocelli
