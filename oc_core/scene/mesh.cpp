#include "oc_core/scene/mesh.h"

#include <array>
#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/finite.h"
#include "oc_core/base/parallel.h"

namespace ocelli {

Box boundsOf(const Mesh& mesh) {
  constexpr size_t kChunks = 32;
  std::array<Box, kChunks> boxes;
  parallelChunks(mesh.positions.size(), kChunks, [&](size_t chunk, size_t begin, size_t end) {
    Box box;
    for (size_t i = begin; i < end; ++i) {
      box.lower = glm::min(box.lower, mesh.positions[i]);
      box.upper = glm::max(box.upper, mesh.positions[i]);
    }
    boxes[chunk] = box;
  });
  Box bounds;
  for (const Box& box : boxes) {
    bounds.lower = glm::min(bounds.lower, box.lower);
    bounds.upper = glm::max(bounds.upper, box.upper);
  }
  return bounds;
}

void append(Mesh& mesh, const Mesh& part, const glm::mat4& worldFromPart) {
  const auto base = static_cast<uint32_t>(mesh.positions.size());
  if (!part.colors.empty() || !mesh.colors.empty()) {
    mesh.colors.resize(mesh.positions.size(), glm::vec3(1));
    mesh.colors.insert(mesh.colors.end(), part.colors.begin(), part.colors.end());
    mesh.colors.resize(mesh.positions.size() + part.positions.size(), glm::vec3(1));
  }
  mesh.positions.reserve(mesh.positions.size() + part.positions.size());
  for (const glm::vec3& position : part.positions) {
    mesh.positions.push_back(glm::vec3(worldFromPart * glm::vec4(position, 1)));
  }
  const bool mirrored = glm::determinant(glm::mat3(worldFromPart)) < 0;
  mesh.triangles.reserve(mesh.triangles.size() + part.triangles.size());
  for (const glm::uvec3& t : part.triangles) {
    mesh.triangles.push_back((mirrored ? glm::uvec3(t.x, t.z, t.y) : t) + base);
  }
}

void validate(const Mesh& mesh, const std::string& where) {
  const auto fail = [&](const std::string& what, const std::string& next) { throw InputError(what, where, next); };
  if (mesh.triangles.empty()) {
    fail("the scene has no triangle", "export it as a triangle mesh, not as points or lines");
  }
  if (!mesh.colors.empty() && mesh.colors.size() != mesh.positions.size()) {
    fail("there are " + std::to_string(mesh.colors.size()) + " colours for " + std::to_string(mesh.positions.size()) +
             " vertices",
         "give each vertex one colour");
  }
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::vec3& p = mesh.positions[i];
    if (!isFinite(p)) {
      fail("vertex " + std::to_string(i) + " has a coordinate that is not a finite number", "repair the mesh");
    }
  }
  for (size_t i = 0; i < mesh.triangles.size(); ++i) {
    const glm::uvec3& t = mesh.triangles[i];
    if (t.x >= mesh.positions.size() || t.y >= mesh.positions.size() || t.z >= mesh.positions.size()) {
      fail("triangle " + std::to_string(i) + " names a vertex that does not exist", "repair the mesh");
    }
  }
}

}  // namespace ocelli
