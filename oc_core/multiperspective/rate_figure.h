// Draws where a general pinhole camera samples more densely and where less: its sampling rate as a heat map over what
// it sees, with its regions outlined, and a legend.
#pragma once

#include <string>

#include "oc_core/camera/gpc_camera.h"
#include "oc_core/drawing/figure.h"
#include "oc_core/image/image.h"

namespace ocelli {

struct RateSummary {
  double leastAlongAxes = 1;    ///< exact: the text's least rate, along u or v on a line through a region's centre
  double leastAnywhere = 1;     ///< in any direction, at the centre of any pixel
  double greatest = 1;          ///< along the axes
  double highestLeastRate = 1;  ///< what the linear sampling would reach along the axes, with the same regions
  double pixelsInRegions = 0;   ///< share of the image
  double pixelsInTransitions = 0;
};

RateSummary summarizeRates(const GpcCamera& camera);

struct RateFigureOptions {
  std::string title{};    ///< above the image; none where empty
  int imagePixels = 900;  ///< longer side of the image, in points of an SVG; the legend comes beside it
};

/// `seen` is the camera's image, linear colours; it may be empty.
Figure rateFigure(const GpcCamera& camera, const Image<glm::vec3>& seen, const RateFigureOptions& options = {});

}  // namespace ocelli
