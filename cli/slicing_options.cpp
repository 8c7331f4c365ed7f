#include "cli/slicing_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/dither_options.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/ocri/reference_image_file.h"
#include "oc_core/ocri/union_mesh.h"
#include "oc_core/pack/cluster_cut.h"
#include "oc_core/worlds/packed_source.h"

namespace ocelli {
namespace {

/// Display radii. Within a slice: between slices voxels are as wide as that at some radius, and narrower inside.
double shortestVoxelSide(const DisplayProfile& profile) {
  return std::min(2.0 / profile.width, 2 * profile.halfHeightRadii / profile.height);
}

}  // namespace

void addSlicingOptions(CLI::App& command, SlicingChoice& choice) {
  const auto undithered =
      command.add_flag("--undithered", choice.undithered, "Light a channel wherever it has any light at all");
  command.add_option("--dither", choice.dither, "How colours become the levels of the display")
      ->check(CLI::IsMember(ditherNames()))
      ->type_name("NAME")
      ->capture_default_str()
      ->excludes(undithered);
  command
      .add_option("--even-light", choice.evenLightRadius,
                  "Surfaces within this radius get the same light for their area, as much as the dimmest there have")
      ->check(radiusCheck())
      ->type_name("RADIUS")
      ->excludes(undithered);
  command.add_flag("--antialias", choice.antialiased,
                   "Light both slices between which a surface lies, in proportion to how near it is");
  command.add_flag("--exact", choice.exact, "Light every voxel that the surface touches, even where it grazes it");
}

SliceOptions sliceOptionsOf(const SlicingChoice& choice) {
  if (choice.undithered && choice.antialiased) {
    throw InputError("--undithered gives full light to any share of it, so there is nothing to share", "--antialias",
                     "leave one of the two out");
  }
  return {choice.undithered ? ColorReduction::kOccupancy : ditherOfName(choice.dither), choice.antialiased,
          choice.evenLightRadius};
}

void addProfileOption(CLI::App& command, std::string& profile) {
  command.add_option("--profile", profile, "The display: a name, or a profile of your own")
      ->type_name("NAME|FILE.json");
}

Mesh loadMeshToSlice(const SceneChoice& scene, const DisplayProfile& profile, bool exact, const Progress& progress) {
  if (scene.source.ends_with(".exr")) {
    return unionMesh(readReferenceImages(scene.source));
  }
  if (!isPackedScene(scene.source) || exact) {
    return loadScene(scene.source, scene.options, progress);
  }
  const PackedScene packed = openPacked(scene.source, scene.options);
  return weldedMeshOf(packed,
                      coarsestClusters(packed, kPackedErrorVoxels * static_cast<float>(shortestVoxelSide(profile))));
}

std::string sliceMetadata(const SceneChoice& scene, const SlicingChoice& choice) {
  nlohmann::ordered_json json = {{"software", "ocelli " OCELLI_VERSION},
                                 {"scene", scene.source},
                                 {"dither", choice.undithered ? "none: any light is full light" : choice.dither},
                                 {"even_light_radius", choice.evenLightRadius},
                                 {"antialiased", choice.antialiased}};
  if (scene.options.motion.seconds) {
    json["time_seconds"] = *scene.options.motion.seconds;
  }
  return textOfJson(json);
}

}  // namespace ocelli
