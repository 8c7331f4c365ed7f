#include "oc_core/scene/winding_number.h"

#include <cmath>
#include <glm/geometric.hpp>

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

}  // namespace

double windingNumber(const Mesh& mesh, const glm::vec3& point) {
  // Summed by fixed parts, so that the rounding is the same for any number of threads.
  constexpr size_t kParts = 64;
  std::vector<double> sums(kParts);
  const glm::dvec3 origin(point);
  parallelChunks(mesh.triangles.size(), kParts, [&](size_t part, size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const glm::uvec3& t = mesh.triangles[i];
      sums[part] += solidAngle(glm::dvec3(mesh.positions[t.x]) - origin, glm::dvec3(mesh.positions[t.y]) - origin,
                               glm::dvec3(mesh.positions[t.z]) - origin);
    }
  });
  double sum = 0;
  for (const double part : sums) {
    sum += part;
  }
  return sum / (4 * kPi);
}

void requireOutside(const Mesh& mesh, const glm::vec3& eye, const std::string& where) {
  // Scans are not quite closed: a few percent of the directions may leave through holes.
  constexpr double kInside = 0.95;
  if (std::abs(windingNumber(mesh, eye)) > kInside) {
    throw InputError("the eye lies inside an object of the scene, so the view would show its inside only", where,
                     "move \"eye\" out of it, or leave --view away");
  }
}

}  // namespace ocelli
