// Scene files: PLY through our own reader, and everything else that Assimp reads (OBJ, STL, glTF, ...) through a
// process of its own (scene_reader.h).
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/scene/moving_scene.h"
#include "oc_core/scene/scene.h"
#include "oc_core/scene/texture_bake.h"

namespace ocelli {

inline constexpr size_t kUsualTextureTriangles = 1'000'000;

struct SceneFileOptions {
  bool textures = true;  ///< bake them to vertex colours; else materials have their plain colours
  /// Triangles that may be added, in all, so that textures survive (texture_bake.h).
  size_t textureTriangles = kUsualTextureTriangles;
  PointSceneOptions points{};  ///< of a file with points or lines
};

/// Whether a file is PLY by its name or its first bytes.
bool isPlyFile(const std::filesystem::path& path);

/// Reads a file with its node transforms and copies. Points become geometry (point_mesh.h), and so do lines
/// (line_mesh.h). Of other files polygons are triangulated, vertices that nothing uses dropped, and formats that repeat
/// a vertex for each triangle (OBJ, STL) get shared ones back. Bones of a file stand as they do at rest.
///
/// Colours are those of the vertices, else the diffuse or base colours of the materials, times their diffuse texture,
/// plus their emissive colour times its texture; there are none where the file says nothing of colours. Textures may be
/// embedded, or files that import/texture_search.h finds. One that is missing or no image is among Scene::warnings, and
/// so is where `textureTriangles` do not let them be whole. The
/// colours of glTF are linear and multiply each other; all others are sRGB.
///
/// Where materials have masks of alpha, what these leave out is cut away; copies of unlit materials are not lit.
///
/// Throws InputError naming the file where it is missing, is a folder, is empty, cannot be parsed, holds no triangle,
/// an index out of range or a coordinate that is not finite, is larger than 8 GiB or kMaxSceneTriangles, where Assimp
/// crashes on it, or where reading it takes more time or memory than ReadingLimits; WorkError where the program that
/// reads it is missing. `progress` is called some times a second, and may throw to end the reading.
Scene readSceneFile(const std::filesystem::path& path, const SceneFileOptions& options = {},
                    const Progress& progress = {});

/// The same file as it moves: the meshes, lines and points of its copies as an animation moves them, by nodes, bones
/// and morph targets.
/// Nothing where it has no animation that takes some time, as files of PLY. `animation` is a name or a number from 1
/// on; empty for the first one. What the file says that is not played so is among `warnings`, as are missing textures.
/// Throws as readSceneFile() does, and InputError for an animation that is not there.
///
/// Vertices are not shared anew: where a file repeats them for each triangle, triangles are shaded one by one.
std::unique_ptr<MovingScene> readAnimatedFile(const std::filesystem::path& path, const SceneFileOptions& options,
                                              const std::string& animation, std::vector<std::string>& warnings,
                                              const Progress& progress = {});

}  // namespace ocelli
