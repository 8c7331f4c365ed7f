#include "study/task/object_picker.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/render/raycast.h"

namespace ocelli {
namespace {

/// By which a ray ends before the object, metres: what it stands on is no wall before it.
constexpr double kBefore = 1e-3;

/// Along from `from` to `to`, 0 to 1, to where the triangle is met; nothing where it is not.
std::optional<double> meeting(const glm::dvec3& from, const glm::dvec3& way, const glm::dvec3& a, const glm::dvec3& b,
                              const glm::dvec3& c) {
  // Moeller and Trumbore, 1997.
  const glm::dvec3 ab = b - a;
  const glm::dvec3 ac = c - a;
  const glm::dvec3 p = glm::cross(way, ac);
  const double determinant = glm::dot(ab, p);
  if (determinant == 0) {
    return std::nullopt;
  }
  const glm::dvec3 s = from - a;
  const glm::dvec3 q = glm::cross(s, ab);
  const double u = glm::dot(s, p) / determinant;
  const double v = glm::dot(way, q) / determinant;
  const double t = glm::dot(ac, q) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 && t >= 0 && t <= 1 ? std::optional(t) : std::nullopt;
}

}  // namespace

ObjectPicker::ObjectPicker(const StudyScene& scene) : scene_(scene), triangles_(scene.objectCount()) {
  const Mesh& mesh = scene.mesh();
  structure_.positions = mesh.positions;
  for (size_t i = 0; i < mesh.triangles.size(); ++i) {
    const uint32_t object = scene.objectOfTriangle()[i];
    (object == 0 ? structure_.triangles : triangles_[object - 1]).push_back(mesh.triangles[i]);
  }
  walls_ = std::make_unique<RayScene>(structure_);
}

ObjectPicker::~ObjectPicker() = default;

bool ObjectPicker::isOnRay(const RayPath& path, size_t object, const glm::vec3& offset) const {
  const std::vector<glm::vec3>& positions = scene_.mesh().positions;
  RayPath before;
  for (size_t i = 0; i + 1 < path.size(); ++i) {
    const glm::dvec3 from(path[i]);
    const glm::dvec3 way = glm::dvec3(path[i + 1]) - from;
    std::optional<double> first;
    for (const glm::uvec3& triangle : triangles_[object]) {
      const auto corner = [&](uint32_t vertex) { return glm::dvec3(positions[vertex] + offset); };
      const std::optional<double> t = meeting(from, way, corner(triangle.x), corner(triangle.y), corner(triangle.z));
      first = t && (!first || *t < *first) ? t : first;
    }
    before.push_back(path[i]);
    if (first) {
      const double length = glm::length(way);
      before.push_back(glm::vec3(from + way * std::max(0.0, *first - (length > 0 ? kBefore / length : 0))));
      return !walls_->intersect(before).covered();
    }
  }
  return false;
}

bool ObjectPicker::isUnder(const StudyCamera& camera, const glm::dvec2& pixel, double tolerancePixels, size_t object,
                           const glm::vec3& offset) const {
  constexpr int kRings = 3;
  constexpr int kAround = 12;
  return std::visit(
      [&](const auto& model) {
        const auto isAt = [&](const glm::dvec2& at) {
          return at.x >= 0 && at.y >= 0 && at.x < model.width() && at.y < model.height() &&
                 isOnRay(model.rayPath(glm::vec2(at)), object, offset);
        };
        bool found = isAt(pixel);
        for (int i = 0; !found && tolerancePixels > 0 && i < kRings * kAround; ++i) {
          const double radius = tolerancePixels * (i / kAround + 1) / kRings;
          const double angle = 2 * kPi * (i % kAround) / kAround;
          found = isAt(pixel + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
        }
        return found;
      },
      camera);
}

}  // namespace ocelli
