// The place that feeds watch, as a scene: its walls, and where one can walk in it.
#pragma once

#include <optional>
#include <string>

#include "oc_core/base/progress.h"
#include "oc_core/scene/walk_map.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {

/// In metres, in the world of the setup.
struct FeedPlaceScene {
  Mesh mesh;
  WalkMap map;               ///< empty where it was not asked for
  double metre = 1;          ///< units of the scene's file in a metre
  bool isMetreKnown = true;  ///< else it was guessed from the size of the scene
};

/// The scene's own axes and origin are those of the setup. `metre` is how many of its units are a metre; where it is
/// missing, metreOf() guesses. Throws InputError as loadGuidedScene() and, for the map, as surveyWalkable().
FeedPlaceScene loadFeedPlace(const std::string& source, const std::optional<double>& metre, bool hasMap,
                             const Progress& progress = {});

}  // namespace ocelli
