// The ways to show foci (focus_way.h) beside each other: pictures of one view of one scene, maps of their sampling
// rates, figures and times.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/focus/focus_figures.h"
#include "oc_core/focus/focus_way.h"
#include "oc_core/focus/rate_heat.h"
#include "oc_core/render/raycast.h"

namespace ocelli {

struct FocusResult {
  const FocusWay* way = nullptr;
  FocusFigures figures{};
  double raysMilliseconds = 0;                 ///< along rays, against a standing structure: all ways alike
  std::optional<double> rasterMilliseconds{};  ///< nothing where no rasteriser draws it
  Image<Rgb8> picture{};
  Image<Rgb8> rates{};  ///< over the picture, on the scale of the comparison
  Image<Rgb8> kept{};  ///< over the plain view: the rate at which the picture shows each place of it; kHiddenColor: not
};

/// Of the palette of Okabe and Ito, vermillion: not on the scale of rates.
inline constexpr Rgb8 kHiddenColor{213, 94, 0};

struct FocusComparison {
  glm::ivec2 size{0};
  RateRange range;  ///< of all pictures
  std::vector<FocusResult> results;
};

struct FocusComparisonOptions {
  int runs = 3;  ///< of each drawing, in turn; the fastest counts
};

/// Fragments along the rays of the map's picture.
FragmentImage drawFocus(const FocusMap& map, const PinholeCamera& plain, const RayScene& rays);

/// Throws InputError as validate() of gpc_layout.h and requireFoci() do.
FocusComparison compareFocusWays(std::span<const FocusWay> ways, const GpcLayout& layout, const PinholeCamera& plain,
                                 const Mesh& mesh, const FocusComparisonOptions& options = {},
                                 const Progress& progress = {});

/// One figure of a way: described once, for the page, the table and JSON.
struct FocusColumn {
  const char* key;      ///< in JSON
  const char* heading;  ///< with its unit
  const char* meaning;
  std::function<std::optional<double>(const FocusResult&)> value;
  std::function<std::string(double)> text;
};
const std::vector<FocusColumn>& focusColumns();

}  // namespace ocelli
