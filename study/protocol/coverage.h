// What the views of a block show of its maze before anyone moves: whether the pinholes of a counting task cover all
// places, and how often an object is seen twice; whether what is to be found is in sight at the start.
#pragma once

#include <string>
#include <vector>

#include "oc_core/base/progress.h"
#include "study/protocol/protocol.h"

namespace ocelli {

/// An object of so many pixels in one image counts as seen, on a screen of 1920 x 1200 pixels.
inline constexpr size_t kMinSeenPixels = 40;
/// The same for another screen: as many as its share of the pixels; one at the least.
size_t minSeenPixels(const TrialScreen& screen);

struct ViewCoverage {
  TrialView view = TrialView::kReference;
  int images = 0;  ///< on the screen
  int places = 0;  ///< where an object was put, one at a time
  int seen = 0;    ///< of these, in one image or more
  int twice = 0;   ///< in two images or more, or twice in one
  int sightings = 0;
  std::vector<size_t> pixels{};       ///< of the largest sighting of each object that was seen, fewest first
  std::vector<double> degreesDown{};  ///< of the ray in the middle of that sighting, where it meets the object
  std::vector<double> stretches{};    ///< of that sighting: its longer side by its shorter one, along the image's sides
  std::vector<std::string> unseen{};  ///< where the object was not
};

/// The middle of a list in ascending order; the mean of two; 0 of an empty one.
template <class Number>
double medianOf(const std::vector<Number>& ascending) {
  const size_t n = ascending.size();
  return n == 0 ? 0 : (static_cast<double>(ascending[(n - 1) / 2]) + static_cast<double>(ascending[n / 2])) / 2;
}

struct BlockCoverage {
  std::string block;
  bool ofCases = false;  ///< places are those of the cases at the start of a trial; else all over the maze
  std::vector<ViewCoverage> views;
};

/// Of the blocks that begin with an image of a scene: those with an exposure (an object in the middle of every cell
/// but the entrance, and of every passage) and those with something to be found. Pixels are
/// those of the screen: one of the same shape with fewer of them shows the same places, from 640 rows on
/// (promptHeight()).
std::vector<BlockCoverage> coverageOf(const Protocol& protocol, const TrialScreen& screen,
                                      const Progress& progress = {});

}  // namespace ocelli
