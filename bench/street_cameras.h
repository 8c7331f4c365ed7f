// Cameras of the graph camera family to measure with, laid out along a way that runs straight ahead from the eye and is
// crossed twice, as streets are: all lengths are in units of the way to the first crossing.
#pragma once

#include "oc_core/camera/curved_ray_camera.h"
#include "oc_core/camera/graph_camera.h"

namespace ocelli {

struct Street {
  View view;
  double toCrossing = 1;  ///< in world units
};

/// Seven frusta: the root, three behind each crossing, to the left, ahead and to the right. The second crossing is seen
/// by what goes ahead at the first.
GraphCamera streetGraph(const Street& street, int width, int height);

/// So many frusta: columns of the image, each of which sees what lies farther ahead from its own viewpoint, to the
/// right and to the left in turn; once, or twice where that gives the number.
GraphCamera columnsGraph(const Street& street, int width, int height, int frusta);
/// One of those by the number of frusta; 1 is the pinhole itself.
GraphCamera graphOf(const Street& street, int width, int height, int frusta);

/// Rays swerve to the right and back, so many times; the first turn is at the crossing.
CurvedRayCamera streetCurves(const Street& street, int width, int height, int turns);

}  // namespace ocelli
