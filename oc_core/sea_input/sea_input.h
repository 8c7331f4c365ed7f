// What a user gives to make a sea from: a scene and places in it, or a folder of images with their poses.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "oc_core/base/progress.h"
#include "oc_core/scene/mesh.h"
#include "oc_core/sea/sea_file.h"
#include "oc_core/sea/sea_source.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {

struct SeaInputOptions {
  glm::ivec2 size{1024, 1024};    ///< of panoramas that are rendered
  int samples = 2;                ///< a side of each of their pixels
  std::string positions;          ///< of a scene: a table of places; empty: along its path, or on a grid
  std::optional<double> spacing;  ///< along the path
  std::string grid;               ///< "X0,Z0,X1,Z1,SPACING"; empty: none
  double eyeHeight = 1.6;         ///< of a grid
  size_t first = 0;               ///< images before it are left out
  size_t count = 0;               ///< 0: all
  std::string proxy;              ///< a mesh, or a name of a row of sea_proxies.h; empty: by the input
  size_t proxyTriangles = 20000;  ///< of a scene that is simplified
};

struct SeaInput {
  std::unique_ptr<SeaSource> source;
  Mesh proxy;
  bool arePosesExact = false;
  std::shared_ptr<const Mesh> scene;  ///< what `source` renders
};

/// A folder is taken as images with poses, all else as a scene, which is not fitted: places are in its own units.
/// Throws InputError for what cannot be read, options that do not go together, and places that are none.
SeaInput openSeaInput(const std::string& input, SceneOptions sceneOptions, const SeaInputOptions& options,
                      const Progress& progress = {});

/// The images that a sea was made of: a scene is rendered at its positions, a folder has those of its names. Throws
/// InputError as above, and where the folder lacks some.
SeaInput openSeaSource(const std::string& input, SceneOptions sceneOptions, const SeaFile& sea, int samples,
                       const Progress& progress = {});

}  // namespace ocelli
