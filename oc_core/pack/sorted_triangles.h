// The triangles of a scene on disk, those of each part together.
#pragma once

#include <filesystem>

#include "oc_core/pack/cluster.h"
#include "oc_core/pack/scene_parts.h"

namespace ocelli {

/// Writes them to `path`, which appears complete or not at all. `progress` gets shares of the triangles. Throws
/// WorkError naming the file.
void sortTriangles(const TriangleSource& source, const ScenePlan& plan, const std::filesystem::path& path,
                   const std::function<void(double share)>& progress);

/// Those of a part without children, welded. Throws WorkError naming the file.
WeldedTriangles readPartTriangles(const std::filesystem::path& path, const ScenePart& part);

}  // namespace ocelli
