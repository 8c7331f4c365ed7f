// What stands around and over the panes: the choice of cameras above, the line of states below, options, help, the
// hint of the first run, progress and messages.
#pragma once

#include <string>
#include <vector>

#include "oc_core/explore_window/explore_keys.h"
#include "oc_core/explore_window/explore_layout.h"
#include "oc_core/explore_window/explore_pane.h"

namespace ocelli {

struct ExploreOverlayFrame {
  const ExploreWindowLayout& layout;
  ExploreKeyTarget& target;
  const ExploreWindowStatus& status;
  float scale = 1;                               ///< as of ExplorePaneFrame
  float width = 1;                               ///< of the window
  bool showTimes = true;                         ///< figures that differ from run to run
  double framesPerSecond = 0;                    ///< 0: not known
  const std::vector<ExplorePaneHelp>& paneHelp;  ///< of the pane that has the keyboard
};

/// In this order, each in windows of Dear ImGui of its own.
void drawExploreChoices(const ExploreOverlayFrame& frame);
void drawExploreTitles(const ExploreOverlayFrame& frame);
void drawExploreStatus(const ExploreOverlayFrame& frame);
void drawExploreForm(const ExploreOverlayFrame& frame);
void drawExploreHint(const ExploreOverlayFrame& frame);
void drawExploreProgress(const ExploreOverlayFrame& frame);
void drawExploreMessage(const ExploreOverlayFrame& frame);
void drawExploreHelp(const ExploreOverlayFrame& frame);

/// How opaque the hint of the first run is after `seconds`: 1 at first, 0 once it has gone.
float exploreHintOpacity(double seconds);

}  // namespace ocelli
