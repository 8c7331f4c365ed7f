#include "oc_core/scene/winding_number.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <numeric>
#include <vector>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

double solidAngle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const double la = glm::length(a);
  const double lb = glm::length(b);
  const double lc = glm::length(c);
  const double volume = glm::dot(a, glm::cross(b, c));
  const double spread = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
  return 2 * std::atan2(volume, spread);
}

double solidAngle(const Mesh& mesh, const glm::uvec3& t, const glm::dvec3& origin) {
  return solidAngle(glm::dvec3(mesh.positions[t.x]) - origin, glm::dvec3(mesh.positions[t.y]) - origin,
                    glm::dvec3(mesh.positions[t.z]) - origin);
}

bool holds(const Box& box, const glm::vec3& p) {
  return glm::all(glm::lessThanEqual(box.lower, p)) && glm::all(glm::lessThanEqual(p, box.upper));
}

bool isInside(double windingNumber) {
  // Scans are not quite closed: a few percent of the directions may leave through holes.
  constexpr double kInside = 0.95;
  return std::abs(windingNumber) > kInside;
}

/// For each vertex one that stands for all those which triangles join to it.
std::vector<uint32_t> objectOfVertices(const Mesh& mesh) {
  std::vector<uint32_t> parent(mesh.positions.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](uint32_t v) {
    while (parent[v] != v) {
      parent[v] = parent[parent[v]];
      v = parent[v];
    }
    return v;
  };
  for (const glm::uvec3& t : mesh.triangles) {
    const uint32_t a = root(t.x);
    parent[root(t.y)] = a;
    parent[root(t.z)] = a;
  }
  for (uint32_t v = 0; v < parent.size(); ++v) {
    parent[v] = root(v);
  }
  return parent;
}

/// Object by object: walls and floors around a closed one take their share of the directions in the sum over all.
bool isInsideAnObject(const Mesh& mesh, const glm::vec3& point) {
  const std::vector<uint32_t> object = objectOfVertices(mesh);
  std::vector<double> sums(mesh.positions.size());
  for (const glm::uvec3& t : mesh.triangles) {
    sums[object[t.x]] += solidAngle(mesh, t, point);
  }
  return std::any_of(sums.begin(), sums.end(), [](double sum) { return isInside(sum / (4 * kPi)); });
}

}  // namespace

double windingNumber(const Mesh& mesh, const glm::vec3& point) {
  // Summed by fixed parts, so that the rounding is the same for any number of threads.
  constexpr size_t kParts = 64;
  std::vector<double> sums(kParts);
  const glm::dvec3 origin(point);
  parallelChunks(mesh.triangles.size(), kParts, [&](size_t part, size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      sums[part] += solidAngle(mesh, mesh.triangles[i], origin);
    }
  });
  double sum = 0;
  for (const double part : sums) {
    sum += part;
  }
  return sum / (4 * kPi);
}

void requireOutside(const Mesh& mesh, const glm::vec3& eye, const std::string& where) {
  if (!mesh.isPart && holds(boundsOf(mesh), eye) &&
      (isInside(windingNumber(mesh, eye)) || isInsideAnObject(mesh, eye))) {
    throw InputError("the eye lies inside an object of the scene, so the view would show its inside only", where,
                     "move \"eye\" out of it, or leave --view away");
  }
}

}  // namespace ocelli
