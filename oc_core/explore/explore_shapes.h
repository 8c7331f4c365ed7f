// What a window draws over the picture and into the plan: where rays bend, and what each part of a camera covers.
#pragma once

#include <vector>

#include "oc_core/explore/explore_frame.h"
#include "oc_core/explore/explore_scene.h"

namespace ocelli {

/// The parts of the picture of `frame` whose rays bend.
std::vector<ExploreOutline> outlinesOf(const ExploreFrame& frame);
/// What each part covers within the bounds of the scene.
std::vector<ExploreFootprint> footprintsOf(const ExploreFrame& frame, const Box& bounds);

/// Where an image of one size lies in a picture of another: as large as fits, in the middle.
struct FittedImage {
  double left = 0;
  double top = 0;
  double scale = 1;  ///< pixels of the picture in one of the image
};
FittedImage fitted(int width, int height, int pictureWidth, int pictureHeight);
/// That of the camera ahead, beside the image behind where there is one.
FittedImage fittedAhead(const ExploreFrame& frame);

int widthOf(const MultiperspectiveCamera& camera);
int heightOf(const MultiperspectiveCamera& camera);

/// The camera whose image is seen at a pixel of the picture, and where in that; null outside of both.
struct PictureSpot {
  const MultiperspectiveCamera* camera = nullptr;
  glm::vec2 pixel{0};
};
PictureSpot spotOf(const ExploreFrame& frame, const glm::dvec2& pixel);

}  // namespace ocelli
