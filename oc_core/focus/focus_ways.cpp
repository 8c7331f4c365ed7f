#include <array>

#include "oc_core/focus/fisheye_focus.h"
#include "oc_core/focus/focus_way.h"
#include "oc_core/focus/gpc_focus.h"
#include "oc_core/focus/inset_focus.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/render/rasterize_gpc.h"

namespace ocelli {
namespace {

class PlainFocusMap final : public FocusMap {
 public:
  glm::dvec2 plainFromPicture(const glm::dvec2& picture) const override { return picture; }
  std::optional<glm::dvec2> pictureFromPlain(const glm::dvec2& plain) const override { return plain; }
};

/// As a general pinhole whose transitions are as narrow as they can be, which are then hardly drawn.
FragmentImage rasterOfInsets(const GpcLayout& layout, const PinholeCamera& plain, const Mesh& mesh) {
  GpcLayout narrow = layout;
  for (GpcRegion& region : narrow.regions) {
    region.transitionWidth = static_cast<float>(GpcRegion::kMinTransition);
  }
  return rasterizeGpc(GpcCamera(plain, narrow), mesh);
}

}  // namespace

std::span<const FocusWay> focusWays() {
  static const std::array<FocusWay, 4> ways{
      {{"gpc", "General pinhole",
        "undistorted foci, each in a transition that shows what lies around it with fewer samples", gpcFocusMap,
        [](const GpcLayout& layout, const PinholeCamera& plain, const Mesh& mesh) {
          return rasterizeGpc(GpcCamera(plain, layout), mesh);
        }},
       {"fisheye", "Fisheye",
        "the graphical fisheye of Sarkar and Brown at each focus, in the ellipse that the general "
        "pinhole's lens encloses",
        fisheyeFocusMap},
       {"inset", "Inset magnifier", "a zoomed picture laid over each focus", insetFocusMap, rasterOfInsets},
       {"plain", "Plain view", "the pinhole's image: nothing is larger",
        [](const GpcLayout&, const glm::ivec2&) { return std::make_unique<PlainFocusMap>(); },
        [](const GpcLayout&, const PinholeCamera& plain, const Mesh& mesh) { return rasterize(plain, mesh); }}}};
  return ways;
}

}  // namespace ocelli
