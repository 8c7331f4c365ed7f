#include "oc_core/scene/loose_parts.h"

#include <array>
#include <glm/geometric.hpp>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/scene/line_mesh.h"
#include "oc_core/scene/point_mesh.h"

namespace ocelli {
namespace {

glm::vec3 worldPlace(const Instance& instance, const TexturedMesh& part, uint32_t vertex) {
  return glm::vec3(instance.worldFromMesh * glm::vec4(part.mesh.positions[vertex], 1));
}

/// Around what all copies have of lines and triangles.
Box boxOfLinesAndTriangles(const std::vector<Instance>& instances, const std::vector<TexturedMesh>& parts) {
  Box box;
  for (const Instance& instance : instances) {
    const TexturedMesh& part = parts[instance.mesh];
    for (const glm::uvec3& t : part.mesh.triangles) {
      for (const uint32_t vertex : {t.x, t.y, t.z}) {
        box.add(worldPlace(instance, part, vertex));
      }
    }
    for (const glm::uvec2& line : part.lines) {
      box.add(worldPlace(instance, part, line.x));
      box.add(worldPlace(instance, part, line.y));
    }
  }
  return box;
}

/// To positions and colours of a LineSet or a PointCloud.
template <class Shape>
void addPlaced(Shape& shape, const Instance& instance, const TexturedMesh& part, uint32_t vertex) {
  shape.positions.push_back(worldPlace(instance, part, vertex));
  shape.colors.push_back(part.mesh.color(vertex));
}

/// Of copies that are lit, or of those that are not.
LineSet linesOf(const std::vector<Instance>& instances, const std::vector<TexturedMesh>& parts, bool isLit) {
  LineSet set;
  for (const Instance& instance : instances) {
    const TexturedMesh& part = parts[instance.mesh];
    if (instance.isLit != isLit) {
      continue;
    }
    // Each vertex once, as tubes go on where segments share one.
    std::vector<uint32_t> placed(part.lines.empty() ? 0 : part.mesh.positions.size(), 0);
    const auto place = [&](uint32_t vertex) {
      if (placed[vertex] == 0) {
        addPlaced(set, instance, part, vertex);
        placed[vertex] = static_cast<uint32_t>(set.positions.size());
      }
      return placed[vertex] - 1;
    };
    for (const glm::uvec2& line : part.lines) {
      const uint32_t from = place(line.x);
      set.segments.emplace_back(from, place(line.y));
    }
  }
  return set;
}

PointCloud pointsOf(const std::vector<Instance>& instances, const std::vector<TexturedMesh>& parts) {
  PointCloud cloud;
  for (const Instance& instance : instances) {
    const TexturedMesh& part = parts[instance.mesh];
    for (const uint32_t vertex : part.points) {
      addPlaced(cloud, instance, part, vertex);
    }
  }
  return cloud;
}

}  // namespace

void addLooseParts(Scene& scene, const std::vector<TexturedMesh>& parts, const PointSceneOptions& options,
                   const std::string& where, const Progress& progress) {
  const std::vector<Instance> instances = scene.instances;
  const std::array<LineSet, 2> lines{linesOf(instances, parts, true), linesOf(instances, parts, false)};
  PointCloud cloud = pointsOf(instances, parts);
  const size_t segments = lines[0].segments.size() + lines[1].segments.size();
  if (segments == 0 && cloud.positions.empty()) {
    return;
  }
  const Box box = boxOfLinesAndTriangles(instances, parts);
  PointFacts facts;
  facts.areWidthsChosen = !options.width;
  if (!cloud.positions.empty()) {
    try {
      PointMesh points = meshOfPoints(std::move(cloud), options, where, progress);
      facts = points.facts;
      scene.add(std::move(points.mesh));
    } catch (const InputError& error) {
      if (box.empty()) {
        throw;
      }
      scene.warnings.push_back(where + ": its points are left out: " + error.what());
    }
  }
  if (segments > 0) {
    const double diagonal = glm::length(glm::dvec3(box.upper) - glm::dvec3(box.lower));
    const double width = options.width.value_or(diagonal * kLineShare);
    if (!(width > 0)) {
      throw InputError("its lines have no length", where, "export the scene again");
    }
    for (const LineSet& set : lines) {
      if (!set.segments.empty()) {
        scene.add(meshOfLines(set, width, where));
        scene.instances.back().isLit = &set == &lines[0];
      }
    }
    facts.lines = segments;
  }
  scene.points = facts;
}

}  // namespace ocelli
