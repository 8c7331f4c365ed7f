// The display surface of the maze camera (section 4.3.1.4, Figures 4.1 and 4.19): the images of the forward and of the
// backward camera as one image: "in front (right panel) and behind (left panel)", both upright. Grey lines part the
// perspectives, where the image jumps.
//
// DEVIATION: the text's surface splits the image along these lines; here they are drawn.
#pragma once

#include <vector>

#include "oc_core/camera/graph_camera.h"
#include "oc_core/image/image.h"

namespace ocelli {

/// A vertical line of the image between two ways, pixels.
struct SplitLine {
  double u = 0;
  double top = 0;
  double bottom = 0;
};

/// Those between the children of the root that share a border, from left to right.
std::vector<SplitLine> splitLines(const GraphCamera& camera);

/// The image, as tall as the images and as wide as both. They must be of one height, and of the cameras' sizes.
Image<glm::vec3> layOut(const GraphCamera& forward, const Image<glm::vec3>& ahead, const GraphCamera& backward,
                        const Image<glm::vec3>& behind);

}  // namespace ocelli
