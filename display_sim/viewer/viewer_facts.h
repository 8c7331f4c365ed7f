// What the panels tell beside the state: what has been made, what was drawn, and what went wrong.
#pragma once

#include <array>

#include "display_sim/viewer/effect_work.h"
#include "display_sim/viewer/lens_work.h"
#include "display_sim/viewer/reconstruction_pane.h"
#include "display_sim/viewer/reference_pane.h"
#include "display_sim/viewer/scene_lines.h"
#include "display_sim/viewer/viewer_keys.h"
#include "display_sim/viewer/viewer_layout.h"
#include "display_sim/viewer/volume_work.h"

namespace ocelli {

struct ViewerFacts {
  WorkStatus work;
  double frameMilliseconds = 0;  ///< 0: not measured
  bool showTimes = true;         ///< those that differ from run to run
  std::string renderer;
  const ViewerData* data = nullptr;
  std::optional<MissingSamples> missing;  ///< nothing while the eye moves
  size_t straightRays = 0;
  size_t bentRays = 0;
  ReferenceScale scale;
  std::optional<PickedPixel> picked;
  std::string displayProblem;
  EffectStatus effect;
  LensStatus lenses;
  VolumeStatus volume;
  std::array<std::string, kPaneCount> failures;  ///< why OpenGL could not draw a pane; empty where it could
  std::string message;
  bool messageIsError = false;
};

/// What a person asked for through the panels, other than what they changed in the state themselves.
struct PanelWishes {
  std::vector<ViewerAction> actions;
  std::string open;      ///< a scene; empty for none
  std::string camera;    ///< the file of one; empty for none
  std::string transfer;  ///< a preset of a transfer function, or a file; empty for none
  bool changesIso = false;
  std::optional<double> iso;  ///< of a volume's surface, where that changes
  bool dismissMessage = false;
};

/// What the panels draw with: the state is theirs to change.
struct PanelDrawing {
  ViewerState& state;
  const ViewerFacts& facts;
  const ViewerLayout& layout;
  float scale;  ///< screen coordinates for a length of 1
  PanelWishes& wishes;
};

/// "189,082".
std::string grouped(size_t number);
/// "1/64" or "2": how fast the display turns.
std::string speedText(double speed);

}  // namespace ocelli
