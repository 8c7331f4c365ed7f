// The options of every command that slices.
#pragma once

#include <string>

#include "cli/scene_options.h"
#include "display_sim/dither/slice_options.h"
#include "display_sim/frames/display_profile.h"
#include "oc_core/base/progress.h"

namespace CLI {
class App;
}

namespace ocelli {

struct SlicingChoice {
  bool undithered = false;
  std::string dither = "ordered";
  double evenLightRadius = 0;
  bool antialiased = false;
  bool exact = false;
};

/// Adds --undithered, --dither, --even-light, --antialias and --exact. `choice` must outlive the parsing.
void addSlicingOptions(CLI::App& command, SlicingChoice& choice);
/// Throws InputError for options that contradict each other.
SliceOptions sliceOptionsOf(const SlicingChoice& choice);

/// Adds --profile. Read it with loadProfile() when the command runs.
void addProfileOption(CLI::App& command, std::string& profile);

/// A scene, or the mesh of a reference image (.exr). Of a packed scene its surfaces as coarse as an eighth of a voxel
/// of that display allows, so that its size does not matter; or all of it, where `exact` asks for that.
Mesh loadMeshToSlice(const SceneChoice& scene, const DisplayProfile& profile, bool exact, const Progress& progress);
/// What `ocelli volume info` tells later of a volume that was sliced so.
std::string sliceMetadata(const SceneChoice& scene, const SlicingChoice& choice);

}  // namespace ocelli
