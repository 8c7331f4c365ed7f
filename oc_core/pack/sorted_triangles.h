// The triangles of a scene on disk, those of each part together.
#pragma once

#include <filesystem>

#include "oc_core/pack/cluster.h"
#include "oc_core/pack/fixed_places.h"
#include "oc_core/pack/scene_parts.h"

namespace ocelli {

struct SortedPaths {
  std::filesystem::path triangles;
  std::filesystem::path places;  ///< what triangles of other parts fix in each part (fixed_places.h)
};

/// Writes both; each appears complete or not at all, and the triangles last. `progress` gets shares of the triangles.
/// Throws WorkError naming the file.
void sortTriangles(const TriangleSource& source, const ScenePlan& plan, const SortedPaths& paths,
                   const std::function<void(double share)>& progress);

struct PartTriangles {
  WeldedTriangles triangles;
  std::vector<FixedPlace> fixed;  ///< in order, each once
};

/// Those of a part without children. Throws WorkError naming the file.
PartTriangles readPartTriangles(const SortedPaths& paths, const ScenePlan& plan, uint32_t part);

}  // namespace ocelli
