// Ways to show a volume on a display that hides nothing, compared: how solid each looks.
//
// To add a way: a row in volume_ways.cpp. `ocelli solidity VOLUME --ways NAME` finds it there.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "display_sim/solidity/solidity.h"
#include "display_sim/volume_solidity/shown_volume.h"

namespace ocelli {

struct VolumeWaySettings {
  glm::vec3 referenceEye{0};
  std::vector<glm::vec3> cellEyes{};  ///< the reference eye and the corners of the view cell
  double fullLightGradient = 0.1;     ///< as SweptSampling::fullLightGradient
  double cutaway = 0;                 ///< as ShownVolumeOptions::cutaway
  double seenOpacity = 0.5;           ///< as ShownVolumeOptions::seenOpacity, and where the truth calls light hidden
};

struct VolumeWay {
  std::string_view name;
  std::string_view summary;  ///< one line
  void (*set)(ShownVolumeOptions& options, const VolumeWaySettings& settings);
  SolidityMeter::Shown shown = SolidityMeter::Shown::kEverything;
};

const std::vector<VolumeWay>& volumeWays();
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
