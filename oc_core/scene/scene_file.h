// Scene files: everything that Assimp reads (PLY, OBJ, STL, glTF, ...).
#pragma once

#include <filesystem>

#include "oc_core/scene/scene.h"

namespace ocelli {

/// Reads a file with its node transforms and copies. Polygons are triangulated, points and lines left out, vertices
/// that no triangle uses dropped, and formats that repeat a vertex for each triangle (OBJ, STL) get shared ones back.
/// Throws InputError naming the file where it is missing, is a folder, is empty, cannot be parsed, holds no triangle,
/// an index out of range or a coordinate that is not finite, or is larger than 8 GiB or kMostSceneTriangles.
Scene readSceneFile(const std::filesystem::path& path);

}  // namespace ocelli
