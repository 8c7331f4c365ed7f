// More triangles for the same surfaces of a scene of many meshes.
#pragma once

#include <cstddef>

#include "oc_core/scene/scene.h"

namespace ocelli {

/// Splits edges (densify()) until the scene has about `triangles` triangles, or those that it has already: each mesh
/// gets as many times more as the others, and may end with one triangle more than its share. Each mesh must be used
/// once.
void densifyScene(Scene& scene, size_t triangles);

}  // namespace ocelli
