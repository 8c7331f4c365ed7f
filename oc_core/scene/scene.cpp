#include "oc_core/scene/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <utility>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

constexpr size_t kItemsPerRange = 1 << 15;

glm::vec3 movedPoint(const glm::mat4& newFromOld, const glm::vec3& point) {
  return glm::vec3(newFromOld * glm::vec4(point, 1));
}

/// Writes a copy of `part` into `flat`, which has room for it, and for its colours where it has any.
void placeInstance(const Mesh& part, const Instance& instance, Mesh& flat, size_t firstVertex, size_t firstTriangle) {
  parallelFor(part.positions.size(), kItemsPerRange, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      flat.positions[firstVertex + i] = movedPoint(instance.worldFromMesh, part.positions[i]);
      if (!flat.colors.empty()) {
        flat.colors[firstVertex + i] = part.color(static_cast<uint32_t>(i)) * instance.tint;
      }
    }
  });
  const bool mirrored = glm::determinant(glm::mat3(instance.worldFromMesh)) < 0;
  parallelFor(part.triangles.size(), kItemsPerRange, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const glm::uvec3& t = part.triangles[i];
      flat.triangles[firstTriangle + i] =
          (mirrored ? glm::uvec3(t.x, t.z, t.y) : t) + static_cast<uint32_t>(firstVertex);
    }
  });
}

}  // namespace

void Scene::add(Mesh mesh, const glm::mat4& worldFromMesh) {
  meshes.push_back(std::move(mesh));
  instances.push_back({meshes.size() - 1, worldFromMesh});
}

size_t triangleCount(const Scene& scene) {
  size_t count = 0;
  for (const Instance& instance : scene.instances) {
    count += scene.meshes[instance.mesh].triangles.size();
  }
  return count;
}

Mesh flatten(const Scene& scene) {
  size_t vertices = 0;
  bool colored = false;
  for (const Instance& instance : scene.instances) {
    OC_CHECK(instance.mesh < scene.meshes.size(), "an instance names a mesh of its scene");
    const Mesh& part = scene.meshes[instance.mesh];
    vertices += part.positions.size();
    colored |= !part.colors.empty() || instance.tint != glm::vec3(1);
  }
  OC_CHECK(vertices <= 0xffffffffu, "a flat mesh has 32-bit vertex indices");

  Mesh flat;
  flat.positions.resize(vertices);
  flat.colors.resize(colored ? vertices : 0);
  flat.triangles.resize(triangleCount(scene));
  size_t firstVertex = 0;
  size_t firstTriangle = 0;
  for (const Instance& instance : scene.instances) {
    const Mesh& part = scene.meshes[instance.mesh];
    placeInstance(part, instance, flat, firstVertex, firstTriangle);
    firstVertex += part.positions.size();
    firstTriangle += part.triangles.size();
  }
  return flat;
}

std::vector<uint8_t> unlitVertices(const Scene& scene) {
  std::vector<uint8_t> unlit;
  if (std::ranges::all_of(scene.instances, &Instance::isLit)) {
    return unlit;
  }
  for (const Instance& instance : scene.instances) {
    unlit.insert(unlit.end(), scene.meshes[instance.mesh].positions.size(), instance.isLit ? 0 : 1);
  }
  return unlit;
}

Mesh flattenInstance(const Scene& scene, size_t instance) {
  OC_CHECK(instance < scene.instances.size() && scene.instances[instance].mesh < scene.meshes.size(),
           "an instance is one of its scene, and names one of its meshes");
  const Mesh& part = scene.meshes[scene.instances[instance].mesh];
  Mesh flat;
  flat.positions.resize(part.positions.size());
  flat.colors.resize(part.positions.size());
  flat.triangles.resize(part.triangles.size());
  placeInstance(part, scene.instances[instance], flat, 0, 0);
  return flat;
}

std::vector<uint32_t> objectOfTriangles(const Scene& scene) {
  std::vector<uint32_t> objects;
  objects.reserve(triangleCount(scene));
  for (const Instance& instance : scene.instances) {
    objects.insert(objects.end(), scene.meshes[instance.mesh].triangles.size(), instance.object);
  }
  return objects;
}

glm::mat4 unitFromSphere(const glm::dvec3& center, double radius, const std::string& where) {
  const double scale = 1 / radius;
  const glm::vec3 translation(-center * scale);
  if (!std::isfinite(static_cast<float>(scale)) || static_cast<float>(scale) < 1e-30f) {
    throw InputError("the scene is too " + std::string(radius < 1 ? "small" : "large") +
                         " to be fitted to the unit sphere (radius " + fmt::format("{:g}", radius) + ")",
                     where, "rescale the mesh, or repair it if its vertices should not coincide");
  }
  glm::mat4 unit(static_cast<float>(scale));
  unit[3] = glm::vec4(translation, 1);
  return unit;
}

double reachOf(const Mesh& mesh, const glm::dvec3& center) {
  double reach = 0;
  for (const glm::vec3& position : mesh.positions) {
    reach = std::max(reach, glm::length(glm::dvec3(position) - center));
  }
  return reach;
}

glm::mat4 unitFromWorld(const Mesh& mesh, const std::string& where) {
  const Box box = boundsOf(mesh);
  OC_CHECK(!box.empty(), "only a mesh with vertices has a bounding sphere");
  const glm::dvec3 center = (glm::dvec3(box.lower) + glm::dvec3(box.upper)) * 0.5;
  return unitFromSphere(center, reachOf(mesh, center), where);
}

void transform(Mesh& mesh, const glm::mat4& newFromOld) {
  OC_CHECK(glm::determinant(glm::mat3(newFromOld)) >= 0, "a mirroring transform would turn the triangles inside out");
  parallelFor(mesh.positions.size(), kItemsPerRange, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      mesh.positions[i] = movedPoint(newFromOld, mesh.positions[i]);
    }
  });
}

}  // namespace ocelli
