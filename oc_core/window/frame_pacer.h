// Keeps a window from drawing more frames than its screen shows, where waiting for the screen does nothing: on virtual
// screens, behind other windows, and with drivers that are set so.
#pragma once

namespace ocelli {

class FramePacer {
 public:
  /// `refreshRate` in frames a second, 0 where the screen does not say: then 60.
  explicit FramePacer(double refreshRate);

  /// Seconds to wait at `now` (in seconds, of any clock) before the frame that has just been shown is over. None where
  /// it has taken as long as one of the screen's: a screen is not outrun, and never held up.
  double wait(double now);

 private:
  double period_;
  double due_ = 0;
  bool started_ = false;
};

}  // namespace ocelli
