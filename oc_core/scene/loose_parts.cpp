#include "oc_core/scene/loose_parts.h"

#include <array>
#include <glm/geometric.hpp>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/scene/line_mesh.h"
#include "oc_core/scene/point_mesh.h"

namespace ocelli {
namespace {

class LooseMaker {
 public:
  LooseMaker(const std::vector<Instance>& instances, const std::vector<TexturedMesh>& parts, const PlaceOfVertex& place,
             const PointSceneOptions& options, const std::string& where, const Progress& progress)
      : instances_(instances), parts_(parts), place_(place), options_(options), where_(where), progress_(progress) {}

  LooseParts make() {
    const std::array<Placed<LineSet>, 2> lines{linesOf(true), linesOf(false)};
    Placed<PointCloud> points = pointsOf();
    const size_t segments = lines[0].shape.segments.size() + lines[1].shape.segments.size();
    if (segments == 0 && points.shape.positions.empty()) {
      return {};
    }
    const Box box = boxOfLinesAndTriangles();
    PointFacts facts;
    facts.areWidthsChosen = !options_.width;
    if (!points.shape.positions.empty()) {
      try {
        std::vector<uint32_t> sources;
        PointMesh made = meshOfPoints(std::move(points.shape), options_, where_, progress_, &sources);
        facts = made.facts;
        add(std::move(made.mesh), true, points.origins, sources);
      } catch (const InputError& error) {
        if (box.empty()) {
          throw;
        }
        made_.warnings.push_back(where_ + ": its points are left out: " + error.what());
      }
    }
    if (segments > 0) {
      const double diagonal = glm::length(glm::dvec3(box.upper) - glm::dvec3(box.lower));
      const double width = options_.width.value_or(diagonal * kLineShare);
      if (!(width > 0)) {
        throw InputError("its lines have no length", where_, "export the scene again");
      }
      for (const Placed<LineSet>& set : lines) {
        if (!set.shape.segments.empty()) {
          std::vector<uint32_t> sources;
          Mesh mesh = meshOfLines(set.shape, width, where_, &sources);
          add(std::move(mesh), &set == &lines[0], set.origins, sources);
        }
      }
      facts.lines = segments;
    }
    made_.facts = facts;
    return std::move(made_);
  }

 private:
  /// A LineSet or a PointCloud.
  template <class Shape>
  struct Placed {
    Shape shape;
    std::vector<LooseOrigin> origins;  ///< of each of its positions
  };

  /// Around what all copies have of lines and triangles.
  Box boxOfLinesAndTriangles() const {
    Box box;
    for (size_t i = 0; i < instances_.size(); ++i) {
      const TexturedMesh& part = parts_[instances_[i].mesh];
      for (const glm::uvec3& t : part.mesh.triangles) {
        for (const uint32_t vertex : {t.x, t.y, t.z}) {
          box.add(place_(i, vertex));
        }
      }
      for (const glm::uvec2& line : part.lines) {
        box.add(place_(i, line.x));
        box.add(place_(i, line.y));
      }
    }
    return box;
  }

  template <class Shape>
  void addPlaced(Placed<Shape>& placed, size_t instance, uint32_t vertex) const {
    placed.shape.positions.push_back(place_(instance, vertex));
    placed.shape.colors.push_back(parts_[instances_[instance].mesh].mesh.color(vertex));
    placed.origins.push_back({static_cast<uint32_t>(instance), vertex});
  }

  /// Of copies that are lit, or of those that are not.
  Placed<LineSet> linesOf(bool isLit) const {
    Placed<LineSet> set;
    for (size_t i = 0; i < instances_.size(); ++i) {
      const TexturedMesh& part = parts_[instances_[i].mesh];
      if (instances_[i].isLit != isLit) {
        continue;
      }
      // Each vertex once, as tubes go on where segments share one.
      std::vector<uint32_t> placed(part.lines.empty() ? 0 : part.mesh.positions.size(), 0);
      const auto place = [&](uint32_t vertex) {
        if (placed[vertex] == 0) {
          addPlaced(set, i, vertex);
          placed[vertex] = static_cast<uint32_t>(set.shape.positions.size());
        }
        return placed[vertex] - 1;
      };
      for (const glm::uvec2& line : part.lines) {
        const uint32_t from = place(line.x);
        set.shape.segments.emplace_back(from, place(line.y));
      }
    }
    return set;
  }

  Placed<PointCloud> pointsOf() const {
    Placed<PointCloud> cloud;
    for (size_t i = 0; i < instances_.size(); ++i) {
      for (const uint32_t vertex : parts_[instances_[i].mesh].points) {
        addPlaced(cloud, i, vertex);
      }
    }
    return cloud;
  }

  void add(Mesh mesh, bool isLit, const std::vector<LooseOrigin>& origins, const std::vector<uint32_t>& sources) {
    LooseMesh loose{std::move(mesh), isLit, {}};
    loose.origins.reserve(sources.size());
    for (const uint32_t source : sources) {
      loose.origins.push_back(origins[source]);
    }
    made_.meshes.push_back(std::move(loose));
  }

  const std::vector<Instance>& instances_;
  const std::vector<TexturedMesh>& parts_;
  const PlaceOfVertex& place_;
  const PointSceneOptions& options_;
  const std::string& where_;
  const Progress& progress_;
  LooseParts made_;
};

}  // namespace

LooseParts makeLooseParts(const std::vector<Instance>& instances, const std::vector<TexturedMesh>& parts,
                          const PlaceOfVertex& place, const PointSceneOptions& options, const std::string& where,
                          const Progress& progress) {
  return LooseMaker(instances, parts, place, options, where, progress).make();
}

void addLooseParts(Scene& scene, const std::vector<TexturedMesh>& parts, const PointSceneOptions& options,
                   const std::string& where, const Progress& progress) {
  const PlaceOfVertex place = [&](size_t instance, uint32_t vertex) {
    const Instance& copy = scene.instances[instance];
    return glm::vec3(copy.worldFromMesh * glm::vec4(parts[copy.mesh].mesh.positions[vertex], 1));
  };
  LooseParts loose = makeLooseParts(scene.instances, parts, place, options, where, progress);
  for (LooseMesh& each : loose.meshes) {
    scene.add(std::move(each.mesh));
    scene.instances.back().isLit = each.isLit;
  }
  scene.warnings.insert(scene.warnings.end(), loose.warnings.begin(), loose.warnings.end());
  scene.points = loose.facts;
}

}  // namespace ocelli
