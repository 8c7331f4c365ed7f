#include "oc_core/walkable/walk_options.h"

#include <algorithm>
#include <array>

#include "oc_core/worlds/builtin_scenes.h"

namespace ocelli {
namespace {

constexpr std::array<WalkOption, 6> kWalkOptions{{
    {"agent_height", "how high the agent is", 0.1, 100, true, &WalkOptions::agentHeight},
    {"agent_radius", "half of its width", 0.01, 50, true, &WalkOptions::agentRadius},
    {"step_height", "how high it steps", 0, 50, true, &WalkOptions::stepHeight},
    {"slope_degrees", "how steep a floor it walks on", 0, 80, false, &WalkOptions::slopeDegrees},
    {"cell_size", "squares of the height field in which floors are found", 0.01, 50, true, &WalkOptions::cellSize},
    {"part_share",
     "parts out of reach that are smaller than this share of the largest part, roofs and attics are left out; 0: none",
     0, 1, false, &WalkOptions::partShare},
}};

}  // namespace

std::span<const WalkOption> walkOptionTable() {
  return kWalkOptions;
}

WalkOptions inUnits(const WalkOptions& metres, double unitsPerMetre) {
  WalkOptions options = metres;
  for (const WalkOption& option : kWalkOptions) {
    if (option.isLength) {
      options.*option.value *= unitsPerMetre;
    }
  }
  return options;
}

SceneMetre metreOf(const std::string& source, const GuidedScene& scene) {
  const double fitted = scene.worldFromScene[0][0];
  const glm::vec3 size = boundsOf(scene.mesh).size();
  const double longer = std::max(size.x, size.z) / fitted;
  constexpr double kSmallestScene = 2.5;
  constexpr double kLargestScene = 20000;
  if (longer >= kSmallestScene && longer <= kLargestScene) {
    return {fitted, isBuiltinScene(source)};
  }
  constexpr double kGuessedMetres = 20;
  return {std::max(size.x, size.z) / kGuessedMetres, false};
}

}  // namespace ocelli
