#include "oc_core/scene/vertex_shading.h"

#include <numeric>
#include <utility>

#include "oc_core/base/check.h"
#include "oc_core/base/parallel.h"
#include "oc_core/scene/shading.h"

namespace ocelli {
namespace {

constexpr size_t kVerticesPerRange = 1 << 14;

/// The corners (3 * triangle + corner) at each vertex, one vertex after the other.
struct VertexCorners {
  std::vector<uint32_t> first;    ///< vertices + 1 offsets into `corners`
  std::vector<uint32_t> corners;  ///< in ascending order at each vertex

  explicit VertexCorners(const Mesh& mesh) : first(mesh.positions.size() + 1, 0), corners(mesh.triangles.size() * 3) {
    const auto vertexOf = [&](size_t corner) {
      return mesh.triangles[corner / 3][static_cast<glm::length_t>(corner % 3)];
    };
    for (size_t corner = 0; corner < corners.size(); ++corner) {
      ++first[vertexOf(corner) + 1];
    }
    for (size_t v = 0; v + 1 < first.size(); ++v) {
      first[v + 1] += first[v];
    }
    std::vector<uint32_t> next(first.begin(), first.end() - 1);
    for (size_t corner = 0; corner < corners.size(); ++corner) {
      corners[next[vertexOf(corner)]++] = static_cast<uint32_t>(corner);
    }
  }
};

/// Normals whose length is twice the area; zero where there is none.
void findAreaNormals(const Mesh& mesh, std::vector<glm::vec3>& normals) {
  normals.resize(mesh.triangles.size());
  parallelFor(normals.size(), kVerticesPerRange, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const glm::uvec3& t = mesh.triangles[i];
      normals[i] = areaNormal(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]);
    }
  });
}

/// One smooth side of a crease.
struct Side {
  glm::vec3 seed{0};    ///< normal of its first face that has an area
  uint32_t vertex = 0;  ///< that it gets
};

}  // namespace

VertexShading::VertexShading(Mesh& mesh) : sources_(mesh.positions.size()) {
  std::iota(sources_.begin(), sources_.end(), 0u);
  findAreaNormals(mesh, normals_);
  VertexCorners at(mesh);
  const size_t vertices = mesh.positions.size();
  std::vector<uint8_t> creased(vertices, 0);
  parallelFor(vertices, kVerticesPerRange, [&](size_t begin, size_t end) {
    for (size_t v = begin; v < end; ++v) {
      glm::vec3 sum(0);
      for (uint32_t i = at.first[v]; i < at.first[v + 1]; ++i) {
        sum += normals_[at.corners[i] / 3];
      }
      for (uint32_t i = at.first[v]; i < at.first[v + 1]; ++i) {
        creased[v] |= static_cast<uint8_t>(!smoothTogether(sum, normals_[at.corners[i] / 3]));
      }
    }
  });
  std::vector<Side> sides;
  for (uint32_t v = 0; v < vertices; ++v) {
    if (creased[v] == 0) {
      continue;
    }
    sides.clear();
    for (uint32_t i = at.first[v]; i < at.first[v + 1]; ++i) {
      const uint32_t corner = at.corners[i];
      const glm::vec3& normal = normals_[corner / 3];
      size_t side = 0;
      while (side < sides.size() && !smoothTogether(sides[side].seed, normal)) {
        ++side;
      }
      if (side == sides.size()) {
        sides.push_back({normal, side == 0 ? v : static_cast<uint32_t>(sources_.size())});
        if (side > 0) {
          sources_.push_back(v);
        }
      }
      if (sides[side].seed == glm::vec3(0)) {
        sides[side].seed = normal;
      }
      mesh.triangles[corner / 3][static_cast<glm::length_t>(corner % 3)] = sides[side].vertex;
    }
  }
  const bool split = sources_.size() > vertices;
  for (size_t i = vertices; i < sources_.size(); ++i) {
    mesh.positions.push_back(glm::vec3(mesh.positions[sources_[i]]));
    if (!mesh.colors.empty()) {
      mesh.colors.push_back(glm::vec3(mesh.colors[sources_[i]]));
    }
  }
  if (split) {
    at = VertexCorners(mesh);
  }
  first_ = std::move(at.first);
  faces_ = std::move(at.corners);
  parallelFor(faces_.size(), kVerticesPerRange, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      faces_[i] /= 3;
    }
  });
}

void VertexShading::shade(Mesh& mesh, std::span<const glm::vec3> unshaded, std::span<const uint8_t> unlit) {
  OC_CHECK(mesh.positions.size() + 1 == first_.size() && 3 * mesh.triangles.size() == faces_.size() &&
               (unshaded.empty() || unshaded.size() == mesh.positions.size()) &&
               (unlit.empty() || unlit.size() == mesh.positions.size()),
           "another mesh than was split, or too few colours");
  findAreaNormals(mesh, normals_);
  mesh.colors.resize(mesh.positions.size());
  parallelFor(mesh.positions.size(), kVerticesPerRange, [&](size_t begin, size_t end) {
    for (size_t v = begin; v < end; ++v) {
      glm::vec3 sum(0);
      for (uint32_t i = first_[v]; i < first_[v + 1]; ++i) {
        sum += normals_[faces_[i]];
      }
      const float shade = !unlit.empty() && unlit[v] != 0 ? 1.0f : shadeOfSum(sum);
      mesh.colors[v] = (unshaded.empty() ? glm::vec3(1) : unshaded[v]) * shade;
    }
  });
}

}  // namespace ocelli
