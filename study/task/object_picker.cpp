#include "study/task/object_picker.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "oc_core/render/raycast.h"

namespace ocelli {
namespace {

/// By which a ray ends before the object, metres: what it stands on is no wall before it.
constexpr double kBefore = 1e-3;
/// Tolerances of more pixels than that are looked at in larger steps.
constexpr int kMaxSteps = 20;

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

/// Whether the way from `from` enters the sphere around the box, moved by `offset`.
bool comesNear(const glm::dvec3& from, const glm::dvec3& way, const Box& box, const glm::vec3& offset) {
  const glm::dvec3 center(box.center() + offset);
  const double radius = static_cast<double>(glm::length(box.size())) / 2;
  const double length = glm::dot(way, way);
  const double along = length > 0 ? std::clamp(glm::dot(center - from, way) / length, 0.0, 1.0) : 0.0;
  return glm::distance(from + along * way, center) <= radius;
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
    if (!comesNear(from, way, scene_.boxOf(object), offset)) {
      before.push_back(path[i]);
      continue;
    }
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
  return std::visit(
      [&](const auto& model) {
        const auto isAt = [&](const glm::dvec2& at) {
          return at.x >= 0 && at.y >= 0 && at.x < model.width() && at.y < model.height() &&
                 isOnRay(model.rayPath(glm::vec2(at)), object, offset);
        };
        // The middles of the pixels around, as they are drawn: an object seen through a gap may be one pixel wide.
        const int step = std::max(1, static_cast<int>(tolerancePixels / kMaxSteps));
        const int reach = static_cast<int>(tolerancePixels) / step + 1;
        const glm::dvec2 middle = glm::floor(pixel) + 0.5;
        bool found = isAt(pixel);
        for (int i = -reach; !found && i <= reach; ++i) {
          for (int j = -reach; !found && j <= reach; ++j) {
            const glm::dvec2 at = middle + static_cast<double>(step) * glm::dvec2(j, i);
            found = glm::distance(at, pixel) <= tolerancePixels && isAt(at);
          }
        }
        return found;
      },
      camera);
}

}  // namespace ocelli
