// Draws a plan of a camera (camera_plan.h): SVG, and PNG of the same.
#pragma once

#include <filesystem>
#include <string>

#include "oc_core/drawing/figure.h"
#include "oc_core/multiperspective/camera_plan.h"

namespace ocelli {

struct ImageOptions {
  std::string title{};      ///< above the plan; none where empty
  int planPixels = 1200;    ///< longer side of the plan, in points of an SVG; the legend comes beside it
  int maxLegendLines = 24;  ///< of the legend; how many more parts there are is said below
};

Figure planFigure(const CameraPlan& plan, const ImageOptions& options = {});

/// SVG or PNG, as `path` ends. Throws as writeFigure() does (figure_file.h).
void writePlan(const std::filesystem::path& path, const CameraPlan& plan, const ImageOptions& options = {});

}  // namespace ocelli
