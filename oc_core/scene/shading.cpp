#include "oc_core/scene/shading.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "oc_core/base/conventions.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

constexpr float kAmbient = 0.22f;
constexpr float kBack = 0.3f;
constexpr size_t kVerticesPerRange = 1 << 14;

glm::vec3 directionToLight() {
  return glm::normalize(glm::vec3(0.45f, 0.75f, 0.85f));
}

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
std::vector<glm::vec3> areaNormals(const Mesh& mesh) {
  std::vector<glm::vec3> normals(mesh.triangles.size());
  parallelFor(normals.size(), kVerticesPerRange, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const glm::uvec3& t = mesh.triangles[i];
      normals[i] = areaNormal(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]);
    }
  });
  return normals;
}

/// One smooth side of a crease.
struct Side {
  glm::vec3 seed{0};  ///< normal of its first face that has an area
  glm::vec3 sum{0};
};

}  // namespace

float lambertShade(const glm::vec3& normal) {
  static const glm::vec3 toLight = directionToLight();
  const float cosine = glm::dot(normal, toLight);
  return std::min(1.0f, kAmbient + (1 - kAmbient) * std::max(0.0f, cosine) + kBack * std::max(0.0f, -cosine));
}

bool smoothTogether(const glm::vec3& a, const glm::vec3& b) {
  static const float cosine = static_cast<float>(std::cos(radiansFromDegrees(kCreaseDegrees)));
  const float ab = glm::dot(a, b);
  const float lengths2 = glm::dot(a, a) * glm::dot(b, b);
  return lengths2 <= 0 || (ab > 0 && ab * ab >= cosine * cosine * lengths2);
}

glm::vec3 areaNormal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const glm::vec3 normal = glm::cross(b - a, c - a);
  const float length2 = glm::dot(normal, normal);
  return length2 > 0 && std::isfinite(length2) ? normal : glm::vec3(0);
}

float shadeOfSum(const glm::vec3& normalSum) {
  const float length = glm::length(normalSum);
  return length > 0 ? lambertShade(normalSum / length) : 1.0f;
}

void bakeLambert(Mesh& mesh) {
  const std::vector<glm::vec3> normals = areaNormals(mesh);
  const VertexCorners at(mesh);
  const size_t vertices = mesh.positions.size();
  std::vector<float> shade(vertices, 1.0f);
  std::vector<uint8_t> creased(vertices, 0);
  parallelFor(vertices, kVerticesPerRange, [&](size_t begin, size_t end) {
    for (size_t v = begin; v < end; ++v) {
      glm::vec3 sum(0);
      for (uint32_t i = at.first[v]; i < at.first[v + 1]; ++i) {
        sum += normals[at.corners[i] / 3];
      }
      shade[v] = shadeOfSum(sum);
      for (uint32_t i = at.first[v]; i < at.first[v + 1]; ++i) {
        creased[v] |= static_cast<uint8_t>(!smoothTogether(sum, normals[at.corners[i] / 3]));
      }
    }
  });

  mesh.colors.resize(vertices, glm::vec3(1));
  std::vector<Side> sides;
  std::vector<uint32_t> sideVertex;
  for (size_t v = 0; v < vertices; ++v) {
    if (creased[v] == 0) {
      mesh.colors[v] *= shade[v];
      continue;
    }
    sides.clear();
    sideVertex.clear();
    for (uint32_t i = at.first[v]; i < at.first[v + 1]; ++i) {
      const uint32_t corner = at.corners[i];
      const glm::vec3& normal = normals[corner / 3];
      size_t side = 0;
      while (side < sides.size() && !smoothTogether(sides[side].seed, normal)) {
        ++side;
      }
      if (side == sides.size()) {
        sides.push_back({normal, glm::vec3(0)});
        sideVertex.push_back(static_cast<uint32_t>(side == 0 ? v : mesh.positions.size()));
        if (side > 0) {
          mesh.positions.push_back(glm::vec3(mesh.positions[v]));
          mesh.colors.push_back(glm::vec3(mesh.colors[v]));
        }
      }
      if (sides[side].seed == glm::vec3(0)) {
        sides[side].seed = normal;
      }
      sides[side].sum += normal;
      mesh.triangles[corner / 3][static_cast<glm::length_t>(corner % 3)] = sideVertex[side];
    }
    for (size_t side = 0; side < sides.size(); ++side) {
      mesh.colors[sideVertex[side]] *= shadeOfSum(sides[side].sum);
    }
  }
}

}  // namespace ocelli
