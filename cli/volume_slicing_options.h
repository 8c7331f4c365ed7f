// The options of commands that show volumes on displays, beside those of every volume (volume_options.h).
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/slicing_options.h"
#include "cli/volume_options.h"
#include "display_sim/volume_solidity/shown_volume.h"

namespace CLI {
class App;
}

namespace ocelli {

struct VolumeSlicingChoice {
  std::string mask;
  double gain = 1;
  double fullLightGradient = 0;
  std::optional<double> cutaway;
  std::vector<std::string> viewers;
  std::optional<double> seenOpacity;
};

/// After addSceneOptions(), whose --iso it tells otherwise. Adds --mask, --light-gain, --gradient-light, --cutaway,
/// --seen-opacity and --viewer. `choice` must outlive the parsing.
void addVolumeSlicingOptions(CLI::App& command, VolumeSlicingChoice& choice);
/// For scenes that are no volumes: throws InputError where one of them is given.
void refuseVolumeSlicingOptions(const VolumeSlicingChoice& choice);

/// How volumes are dithered. Throws InputError for options of meshes alone.
SliceOptions volumeSliceOptionsOf(const SlicingChoice& slicing);

/// The eyes of --viewer, or that of the default view.
std::vector<glm::vec3> viewersOf(const VolumeSlicingChoice& choice);

struct VolumeToShow {
  SceneChoice scene;
  VolumeChoice volume;
  VolumeSlicingChoice slicing;
  std::string laterTransfer{};  ///< the name or file of a transfer function that it will have, too; or empty
};

/// The options that say what of a volume is shown; `scene` is the volume.
ShownVolumeOptions shownVolumeOptionsOf(const VolumeToShow& choice, const VolumeScene& scene,
                                        const CommandContext& context);

/// All moments of a time series for a display, or the one of --time or of a volume that does not move: at least 1.
/// Throws InputError for a series that takes more memory than kMaxSeriesBytes.
struct ShownSeries {
  std::vector<std::unique_ptr<ShownVolume>> volumes;
  std::vector<double> times;  ///< s, one a volume; empty where there is one
};
inline constexpr size_t kMaxSeriesBytes = size_t{2} << 30;
ShownSeries loadShownSeries(const VolumeToShow& choice, const DisplayProfile& profile, const CommandContext& context);

/// SCENE, which is a volume, for a display. --iso shows the surface at that value, straight from the field. Throws
/// InputError where no surface has it.
ShownVolume loadShownVolume(const VolumeToShow& choice, const DisplayProfile& profile, const CommandContext& context);

}  // namespace ocelli
