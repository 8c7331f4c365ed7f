#include "oc_core/scene/share_vertices.h"

#include <meshoptimizer.h>

#include <utility>

namespace ocelli {
namespace {

constexpr unsigned kUnused = 0xffffffffu;

static_assert(sizeof(glm::uvec3) == 3 * sizeof(unsigned), "triangles are handed to meshoptimizer as they stand");

unsigned* indicesOf(Mesh& mesh) {
  return reinterpret_cast<unsigned*>(mesh.triangles.data());
}

void applyRemap(Mesh& mesh, const std::vector<unsigned>& remap, size_t kept) {
  meshopt_remapIndexBuffer(indicesOf(mesh), indicesOf(mesh), mesh.triangles.size() * 3, remap.data());
  for (std::vector<glm::vec3>* stream : {&mesh.positions, &mesh.colors}) {
    if (!stream->empty()) {
      std::vector<glm::vec3> packed(kept);
      meshopt_remapVertexBuffer(packed.data(), stream->data(), stream->size(), sizeof(glm::vec3), remap.data());
      *stream = std::move(packed);
    }
  }
}

}  // namespace

void shareVertices(Mesh& mesh) {
  if (mesh.empty()) {
    return;
  }
  const meshopt_Stream streams[] = {{mesh.positions.data(), sizeof(glm::vec3), sizeof(glm::vec3)},
                                    {mesh.colors.data(), sizeof(glm::vec3), sizeof(glm::vec3)}};
  std::vector<unsigned> remap(mesh.positions.size());
  const size_t kept = meshopt_generateVertexRemapMulti(remap.data(), indicesOf(mesh), mesh.triangles.size() * 3,
                                                       mesh.positions.size(), streams, mesh.colors.empty() ? 1 : 2);
  applyRemap(mesh, remap, kept);
}

void dropUnusedVertices(Mesh& mesh) {
  std::vector<unsigned> remap(mesh.positions.size(), kUnused);
  for (const glm::uvec3& t : mesh.triangles) {
    remap[t.x] = remap[t.y] = remap[t.z] = 0;
  }
  unsigned kept = 0;
  for (unsigned& slot : remap) {
    slot = slot == kUnused ? kUnused : kept++;
  }
  if (kept < mesh.positions.size()) {
    applyRemap(mesh, remap, kept);
  }
}

}  // namespace ocelli
