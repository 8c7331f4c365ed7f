// What the views of a block show of its maze before anyone moves: whether the pinholes of a counting task cover all
// places, and how often an object is seen twice; whether what is to be found is in sight at the start.
#pragma once

#include <string>
#include <vector>

#include "oc_core/base/progress.h"
#include "study/protocol/protocol.h"

namespace ocelli {

/// An object of so many pixels in one image counts as seen.
inline constexpr size_t kMinSeenPixels = 40;

struct ViewCoverage {
  TrialView view = TrialView::kReference;
  int images = 0;  ///< on the screen
  int places = 0;  ///< where an object was put, one at a time
  int seen = 0;    ///< of these, in one image or more
  int twice = 0;   ///< in two images or more, or twice in one
  int sightings = 0;
  size_t fewestPixels = 0;            ///< of the largest sighting of an object that was seen
  std::vector<std::string> unseen{};  ///< where the object was not
};

struct BlockCoverage {
  std::string block;
  bool ofCases = false;  ///< places are those of the cases at the start of a trial; else all over the maze
  std::vector<ViewCoverage> views;
};

/// Of the blocks that begin with an image of a scene: those with an exposure (an object in the middle of every cell
/// but the entrance, and of every passage) and those with something to be found.
std::vector<BlockCoverage> coverageOf(const Protocol& protocol, const TrialScreen& screen,
                                      const Progress& progress = {});

}  // namespace ocelli
