// Paths for the tests of remote measurements, whose views tell their frames.
#pragma once

#include "oc_core/remote_measure/playback.h"

namespace ocelli {

/// So many frames; the view of each looks a little farther to the right.
inline RemotePath turningPath(size_t frames, double framesPerSecond, double step = 0.01) {
  RemotePath path{"turning", framesPerSecond, {}};
  for (size_t i = 0; i < frames; ++i) {
    View view;
    view.fovVerticalDegrees = 12;
    view.target = {static_cast<float>(step * static_cast<double>(i)), 0, 0};
    path.views.push_back(view);
  }
  return path;
}

/// What is shown, by frames of the path; -1 is nothing.
inline std::vector<ShownView> shownViews(const std::vector<int>& frames) {
  std::vector<ShownView> shown;
  for (const int frame : frames) {
    shown.push_back(frame < 0 ? ShownView{} : ShownView{static_cast<size_t>(frame)});
  }
  return shown;
}

inline std::vector<int> framesShown(const Playback& playback) {
  std::vector<int> frames;
  for (const ShownView& each : playback.shown) {
    frames.push_back(each.frame ? static_cast<int>(*each.frame) : -1);
  }
  return frames;
}

}  // namespace ocelli
