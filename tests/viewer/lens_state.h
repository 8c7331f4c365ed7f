// A state of the viewer with two lenses and the lens pane active.
#pragma once

#include "display_sim/viewer/lens_choice.h"

namespace ocelli::test {

inline ViewerState lensState() {
  ViewerState state = viewerState("builtin:teapot", {}, cameraChoice("gpc"), View{}, 640, 360, "test");
  // With their transitions they take up [0.1, 0.3] and [0.6, 0.8] of the width, [0.4, 0.6] of the height.
  state.work.camera.gpc.regions = {{{0.2f, 0.5f}, {0.1f, 0.1f}, 3, 1}, {{0.7f, 0.5f}, {0.1f, 0.1f}, 4, 1}};
  state.active = Pane::kLenses;
  return state;
}

}  // namespace ocelli::test
