// Who walks in a scene, and how finely the scene is looked at to find where.
#pragma once

#include <span>
#include <string>

#include "oc_core/worlds/scene_source.h"

namespace ocelli {

/// Lengths are in the units of the scene; the defaults are those of a person where these are metres.
struct WalkOptions {
  double agentHeight = 1.8;
  double agentRadius = 0.25;
  double stepHeight = 0.35;
  double slopeDegrees = 40;
  double cellSize = 0.1;   ///< of the height field, level; its heights are in halves of it
  double partShare = 0.5;  ///< of the largest part's area: smaller parts, roofs and attics are left out; 0: none
};

/// One option as users see it.
struct WalkOption {
  const char* name;  ///< as in files; on the command line with - for _
  const char* meaning;
  double min;
  double max;
  bool isLength;  ///< in metres for users, and in the units of the scene in WalkOptions
  double WalkOptions::*value;
};

/// All of them: parsers, help and documents come from this table.
std::span<const WalkOption> walkOptionTable();

/// The same for a scene in which a metre is so many units.
WalkOptions inUnits(const WalkOptions& metres, double unitsPerMetre);

/// How long a metre is in a scene.
struct SceneMetre {
  double units = 1;
  bool isKnown = false;  ///< else it was guessed from the size of the scene
};

/// A scene whose longer level side had 2.5 to 20,000 units before it was fitted (GuidedScene::worldFromScene) is taken
/// to be in metres, as all built-in scenes of that size are; of others that side is taken to be 20 metres.
SceneMetre metreOf(const std::string& source, const GuidedScene& scene);

}  // namespace ocelli
