// How long a scene is shown for. By the clock, the first frame without it is the one that comes at the end of the time:
// a screen that is slow shows fewer frames, and ends by at most one of its own frames too early or too late, once three
// frames have told how slow it is.
#pragma once

#include <cstdint>
#include <optional>

#include "study/task/task.h"

namespace ocelli {

class Exposure {
 public:
  /// `refreshHertz` of the screen.
  Exposure(ExposureRule rule, double seconds, double refreshHertz);

  /// A frame came to the screen at that tick of the trial, with the scene where the exposure was not over. At least one
  /// frame has it.
  void frameShown(int64_t tick);

  /// The next frame is without the scene.
  bool isOver() const { return over_; }
  /// With the scene, so far.
  int64_t frames() const { return frames_; }
  /// From the first frame with the scene to the first without it. Nothing before that has come, nor where frames are
  /// counted: when they were shown was not told then.
  std::optional<int64_t> shownTicks() const { return shownTicks_; }

 private:
  ExposureRule rule_;
  double endTick_;        ///< by the clock
  double intervalTicks_;  ///< of the screen
  int64_t maxFrames_;     ///< where frames are counted
  int64_t frames_ = 0;
  int64_t lastTick_ = 0;  ///< of the last frame
  int64_t before_ = 0;    ///< between that and the one before, ticks
  bool over_ = false;
  std::optional<int64_t> shownTicks_{};
};

}  // namespace ocelli
