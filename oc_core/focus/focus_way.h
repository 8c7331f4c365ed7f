// Ways to show foci in their context, one row each. Whatever compares them goes through the rows and asks nothing of
// them but what stands here.
//
// Recipe for a new way, two places:
//   1. oc_core/focus/NAME_focus.h and .cpp: its map.
//   2. oc_core/focus/focus_ways.cpp: its row.
// tests/focus/focus_ways_test.cpp runs over all rows; docs/focus_and_context.md lists them.
#pragma once

#include <functional>
#include <span>

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/focus/focus_map.h"
#include "oc_core/render/fragment_image.h"

namespace ocelli {

struct FocusWay {
  const char* name;
  const char* title;
  const char* description;
  /// Of a layout that is valid (gpc_layout.h) and has foci (requireFoci()).
  std::function<std::unique_ptr<FocusMap>(const GpcLayout& layout, const glm::ivec2& size)> map;
  /// Draws by rasterisation what takes as long as the picture of this way does, for times alone; empty where none does.
  std::function<FragmentImage(const GpcLayout& layout, const PinholeCamera& plain, const Mesh& mesh)> raster = {};
};

/// gpc, fisheye, inset, plain.
std::span<const FocusWay> focusWays();

}  // namespace ocelli
