// A script that is played to the window without a display: what a person would do and see, panes and texts with it.
#pragma once

#include <filesystem>
#include <functional>

#include "oc_core/explore_window/explore_recorder.h"
#include "oc_core/explore_window/explorer_window_model.h"
#include "oc_core/gl/gl_context.h"

namespace ocelli {

struct ExploreWindowSessionOptions {
  ExplorerWindowOptions model;
  std::filesystem::path folder = ".";  ///< for what the script saves
  double contentScale = 1;             ///< as of ResizeEvent
  OpenExploreVideo record{};
  std::function<void(const std::filesystem::path& path)> wrote{};
};

/// Of the frames of the script, milliseconds of the clock.
struct ExploreWindowTimes {
  std::vector<double> walk;    ///< the explorer: camera and image
  std::vector<double> window;  ///< panes, panels and texts
  double windowCpu = 0;        ///< of these, the time of all cores together, milliseconds for each frame
};

/// Plays it in a window of the script's size. Throws as the script and its steps do, and GlError.
ExploreWindowTimes playInExploreWindow(GlContext& context, const ExploreScript& script,
                                       ExploreWindowSessionOptions options);

}  // namespace ocelli
