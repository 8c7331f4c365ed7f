#include "oc_core/walkable/walk_direction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

constexpr int kDirectionBins = 360;  // of a quarter degree
constexpr double kQuarterTurn = kPi / 2;
constexpr float kSteepNormal = 0.3f;  // walls lean by less than 17 degrees

/// Of the normal of a wall, in [0, quarter turn); its area in `area`. False where the triangle is no wall.
bool wallAngle(const Mesh& mesh, const glm::uvec3& triangle, double& angle, double& area) {
  const glm::dvec3 a(mesh.positions[triangle.x]);
  const glm::dvec3 normal =
      glm::cross(glm::dvec3(mesh.positions[triangle.y]) - a, glm::dvec3(mesh.positions[triangle.z]) - a);
  area = glm::length(normal);
  if (!(area > 0) || std::abs(normal.y) > kSteepNormal * area) {
    return false;
  }
  angle = std::fmod(std::atan2(-normal.z, normal.x) + 4 * kQuarterTurn, kQuarterTurn);
  return true;
}

}  // namespace

double wallDirection(const Mesh& mesh) {
  std::array<double, kDirectionBins> areas{};
  double angle = 0;
  double area = 0;
  for (const glm::uvec3& triangle : mesh.triangles) {
    if (wallAngle(mesh, triangle, angle, area)) {
      areas[std::min(static_cast<int>(angle / kQuarterTurn * kDirectionBins + 0.5) % kDirectionBins,
                     kDirectionBins - 1)] += area;
    }
  }
  const auto most = static_cast<int>(std::max_element(areas.begin(), areas.end()) - areas.begin());
  if (areas[most] == 0) {
    return 0;
  }
  // The mean of what lies within a degree of the fullest bin.
  const double middle = most * kQuarterTurn / kDirectionBins;
  double sum = 0;
  double weights = 0;
  for (const glm::uvec3& triangle : mesh.triangles) {
    if (wallAngle(mesh, triangle, angle, area)) {
      const double off = std::remainder(angle - middle, kQuarterTurn);
      if (std::abs(off) < radiansFromDegrees(1)) {
        sum += off * area;
        weights += area;
      }
    }
  }
  const double found = std::fmod(middle + sum / weights + kQuarterTurn, kQuarterTurn);
  // Rounding of coordinates is no direction.
  constexpr double kAligned = 1e-4;
  return found < kAligned || found > kQuarterTurn - kAligned ? 0 : found;
}

Mesh turnedAboutVertical(const Mesh& mesh, double angle) {
  Mesh turned;
  turned.triangles = mesh.triangles;
  turned.positions = mesh.positions;
  if (angle != 0) {
    const auto c = static_cast<float>(std::cos(angle));
    const auto s = static_cast<float>(std::sin(angle));
    for (glm::vec3& p : turned.positions) {
      p = {c * p.x + s * p.z, p.y, -s * p.x + c * p.z};
    }
  }
  return turned;
}

}  // namespace ocelli
