#include "oc_core/shade/vertex_normals.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>
#include <tuple>

#include "oc_core/scene/shading.h"

namespace ocelli {
namespace {

/// Vertices by their places: equal ones follow each other.
std::vector<uint32_t> sortedByPlace(const Mesh& mesh) {
  std::vector<uint32_t> order(mesh.positions.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](uint32_t vertex) {
    const glm::vec3& p = mesh.positions[vertex];
    return std::tuple(p.x, p.y, p.z, vertex);
  };
  std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return key(a) < key(b); });
  return order;
}

}  // namespace

std::vector<glm::vec3> vertexNormals(const Mesh& mesh) {
  std::vector<glm::vec3> sums(mesh.positions.size(), glm::vec3(0));
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::vec3 normal = areaNormal(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]);
    for (int corner = 0; corner < 3; ++corner) {
      sums[t[corner]] += normal;
    }
  }
  std::vector<glm::vec3> normals(sums.size());
  const std::vector<uint32_t> order = sortedByPlace(mesh);
  for (size_t begin = 0; begin < order.size();) {
    size_t end = begin + 1;
    while (end < order.size() && mesh.positions[order[end]] == mesh.positions[order[begin]]) {
      ++end;
    }
    for (size_t i = begin; i < end; ++i) {
      glm::vec3 sum(0);
      for (size_t k = begin; k < end; ++k) {
        sum += smoothTogether(sums[order[i]], sums[order[k]]) ? sums[order[k]] : glm::vec3(0);
      }
      const float length = glm::length(sum);
      normals[order[i]] = length > 0 ? sum / length : glm::vec3(0, 1, 0);
    }
    begin = end;
  }
  return normals;
}

glm::vec3 normalAt(const Fragment& fragment, const Mesh& mesh, const std::vector<glm::vec3>& normals,
                   const glm::vec3& incoming) {
  const glm::uvec3& t = mesh.triangles[fragment.triangle];
  glm::vec3 normal =
      normals[t.x] * (1 - fragment.b1 - fragment.b2) + normals[t.y] * fragment.b1 + normals[t.z] * fragment.b2;
  const glm::vec3 face = areaNormal(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]);
  normal = glm::dot(normal, normal) > 0 ? glm::normalize(normal) : glm::normalize(face);
  // The winding of a mesh may be wrong; both are turned alike.
  const float side = glm::dot(face, incoming) > 0 ? -1.0f : 1.0f;
  normal = glm::dot(face, normal) < 0 ? -normal : normal;
  return normal * side;
}

}  // namespace ocelli
