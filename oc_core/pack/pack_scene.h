// Packs a scene of any size: see packed_scene.h for what it gives.
//
// The triangles are sorted on disk into parts of an octree (scene_parts.h); each part becomes clusters and levels of
// detail (hierarchy.h), then the parts that hold others go on with what these left. Memory is that of a part a thread,
// whatever the size of the scene.
#pragma once

#include <filesystem>
#include <string>

#include "oc_core/base/progress.h"
#include "oc_core/pack/triangle_source.h"

namespace ocelli {

struct PackOptions {
  /// What else the file tells of the scene, as JSON: name, how it was fitted and shaded.
  std::string description = "{}";
  /// Same source, same text: what a job that was ended had made of this source is used again. Empty: it is not.
  std::string sourceKey;
};

struct PackReport {
  uint64_t triangles = 0;  ///< of the scene
  uint64_t storedTriangles = 0;
  uint64_t clusters = 0;
  uint64_t groups = 0;
  uint64_t bytes = 0;
  size_t parts = 0;
  size_t partsAtHand = 0;  ///< made by an earlier job
};

/// Writes `path`, which appears complete or not at all; beside it stands a folder `PATH.work` until then, which an
/// ended job leaves and the next one with the same source goes on with. The same source gives the same bytes. Throws
/// InputError where the source has no triangle, WorkError where a disk is full or another job is writing `path`, and
/// what `progress` throws.
PackReport packScene(const TriangleSource& source, const std::filesystem::path& path, const PackOptions& options = {},
                     const Progress& progress = {});

}  // namespace ocelli
