// A stand-in for the pruning of the test model of MPEG immersive video (TMIV): its published rule, done slowly and
// obviously. It is not that program: there are no clusters that are split or merged, no packing into atlases, no
// coding, and what is left is drawn by this toolkit's meshes and not by TMIV's synthesis and inpainting.
//
// The rule: of views in their order, the first one keeps all pixels. A pixel of each other view goes where what earlier
// views have kept, drawn from this view, has there a depth within 10 % of its own and a luma within 4 % (of white) of
// one of the 3x3 pixels around it. What is left is eroded by 2 pixels and dilated by 5.
#pragma once

#include <vector>

#include "oc_core/depth_views/depth_view.h"

namespace ocelli {

struct PruningRule {
  float depthTolerance = 0.1f;
  float lumaTolerance = 0.04f;
  int erode = 2;
  int dilate = 5;
};

struct PrunedViews {
  ReferenceImages images;   ///< what is left of each view
  size_t samples = 0;       ///< in all
  size_t packedPixels = 0;  ///< of the rectangles around connected parts, widened to blocks of 16 pixels
};

/// Views of pinholes, all of one size.
PrunedViews pruneViews(const std::vector<DepthView>& views, const PruningRule& rule = {});

/// Luma of a linear colour, from 0 to 1: that of the sRGB-encoded values (BT.709).
float linearLuma(const glm::vec3& linear);

}  // namespace ocelli
