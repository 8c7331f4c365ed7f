// Lines and points of scene files, which become geometry of the scene: tubes (line_mesh.h) and panels (point_mesh.h).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/scene/scene.h"
#include "oc_core/scene/texture_bake.h"

namespace ocelli {

/// The vertex of a copy that a vertex of loose geometry stands at.
struct LooseOrigin {
  uint32_t instance = 0;
  uint32_t vertex = 0;  ///< of the part that it is a copy of
};

struct LooseMesh {
  Mesh mesh;  ///< in the world
  bool isLit = true;
  std::vector<LooseOrigin> origins;  ///< of each vertex; each triangle is of one copy
};

struct LooseParts {
  std::vector<LooseMesh> meshes;
  std::optional<PointFacts> facts;  ///< nothing where there is neither line nor point
  std::vector<std::string> warnings;
};

/// Where a vertex of the part that a copy is of stands in the world.
using PlaceOfVertex = std::function<glm::vec3(size_t instance, uint32_t vertex)>;

/// What copies of `parts`, whose colours are baked, have besides triangles, as geometry. Without
/// PointSceneOptions::width lines are kLineShare of the diagonal of the box around all lines and triangles wide.
///
/// Points that cannot be drawn, as one alone has no size of its own, are an InputError naming `where`, and a warning
/// where there are lines or triangles to be seen.
LooseParts makeLooseParts(const std::vector<Instance>& instances, const std::vector<TexturedMesh>& parts,
                          const PlaceOfVertex& place, const PointSceneOptions& options, const std::string& where,
                          const Progress& progress);

/// Adds it to a scene whose copies stand still, and sets Scene::points where there is any.
void addLooseParts(Scene& scene, const std::vector<TexturedMesh>& parts, const PointSceneOptions& options,
                   const std::string& where, const Progress& progress);

}  // namespace ocelli
