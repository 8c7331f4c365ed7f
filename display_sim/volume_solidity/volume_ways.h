// Ways to show a volume on a display that hides nothing, compared: how solid each looks.
//
// Recipe for a new way:
//   1. display_sim/volume_solidity/volume_ways.cpp: a function that sets what is shown, and its row.
// `ocelli solidity VOLUME --ways NAME` and the tests that run over every way find it there. From outside of the tree:
// registerVolumeWay() with the same row.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "display_sim/solidity/solidity.h"
#include "display_sim/volume_solidity/shown_volume.h"
#include "oc_core/base/registry.h"

namespace ocelli {

struct VolumeWaySettings {
  glm::vec3 referenceEye{0};
  std::vector<glm::vec3> cellEyes{};  ///< the reference eye and the corners of the view cell
  double fullLightGradient = 0.1;     ///< as SweptSampling::fullLightGradient
  double cutaway = 0;                 ///< as ShownVolumeOptions::cutaway
  double seenOpacity = 0.5;           ///< as ShownVolumeOptions::seenOpacity, and where the truth calls light hidden
};

struct VolumeWay {
  std::string name;
  std::string summary;  ///< one line
  /// Called from any thread.
  std::function<void(ShownVolumeOptions& options, const VolumeWaySettings& settings)> set;
  SolidityMeter::Shown shown = SolidityMeter::Shown::kEverything;
};

/// The built-in ones, then those that were registered. A row stays where it is until the program ends. Any thread may
/// call it at any time.
Rows<VolumeWay> volumeWays();
/// Throws InputError where the name is empty, holds a comma, which separates names, or is taken, and where there is no
/// function.
void registerVolumeWay(VolumeWay way);
/// Throws InputError, naming `option`, for an unknown name.
const VolumeWay& volumeWayByName(const std::string& name, const std::string& option);

struct VolumeWaysToMeasure {
  VolumeScene scene;
  ShownVolumeOptions shown{};  ///< what all ways have: a surface, a mask, a gain
  std::vector<std::string> ways{};
  VolumeWaySettings settings{};
};

/// Of each way in turn; `visitor` gives what is told of the frames of a way, and may be empty. The truth of a way is
/// the opaque image of what it shows: of a cutaway, that of the volume cut away; of a mask, that of what it marks.
std::vector<SolidityFigures> measureVolumeWays(
    const VolumeWaysToMeasure& wanted, const SolidityOptions& options, const Progress& progress = {},
    const std::function<SolidityMeter::Visitor(const std::string& way)>& visitor = {});

}  // namespace ocelli
