// The split lines of a maze camera (section 4.3.1.4): the parts of them where the image jumps, as what is seen on both
// sides lies apart. Which parts these are can change abruptly from frame to frame; so they are averaged.
#pragma once

#include <vector>

#include "oc_core/constructor/maze_display.h"
#include "oc_core/constructor/split_depths.h"
#include "oc_core/explore/explore_scene.h"

namespace ocelli {

/// The state of one image.
class SplitVisibility {
 public:
  /// Takes the camera of the next frame. Lines that hardly show are left out.
  std::vector<SplitLine> next(const GraphCamera& camera, const ExploreScene& scene);

 private:
  SplitDepths means_;
};

}  // namespace ocelli
