// Views with depth of small scenes.
#pragma once

#include "oc_core/depth_views/depth_view.h"
#include "oc_core/ocri/corner_depth_images.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli::test {

/// From the reference view, and the corners of its cell of 1.6 radii: 4 or 8.
inline std::vector<DepthView> cornerViews(const Mesh& scene, int corners,
                                          const PinholeCamera& reference = smallCamera()) {
  std::vector<DepthView> views;
  for (ReferenceImage& image : buildCornerDepthImages(reference, scene, ViewCell{}, corners)) {
    views.push_back({"v" + std::to_string(views.size()), std::move(image)});
  }
  return views;
}

}  // namespace ocelli::test
