// Runs a session in a window. The main thread waits for events and gives each the time when it came; a thread of its
// own draws and shows frames; the console has a third; the store has a fourth. None waits for another.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "oc_core/window/gl_window.h"
#include "study/gaze/gaze_input.h"
#include "study/responses/response_input.h"
#include "study/screen/experimenter_console.h"
#include "study/screen/timing_check.h"
#include "study/session/session_flow.h"

namespace ocelli {

struct SessionLoopOptions {
  std::string subject;
  /// Frames are held back to this rate, where they do not wait for the screen; 0 where they do.
  double pacedHertz = 0;
  int hashEvery = 0;                    ///< every so many frames of a trial the hash of its image is stored; 0: none
  std::filesystem::path screenshots{};  ///< folder for an image of each screen that comes; empty for none
  ResponseInput* responses = nullptr;   ///< debounces the keys of the window, and brings those of other devices
  GazeInput* gaze = nullptr;            ///< where the subject looks; none where null
  /// Right after each frame was shown, with its time as records have it, on the thread that draws; must not wait.
  std::function<void(int64_t nanoseconds)> frameShown{};
  std::function<bool()> interrupted{};  ///< whether the program shall end; asked ten times a second
};

/// Until the session is over. On the main thread, which must not hold the window's context. Throws what went wrong in
/// any of the threads; the session has been ended as aborted then.
SessionEnding runSessionLoop(GlWindow& window, const Protocol& protocol, SessionFlow& flow,
                             ExperimenterConsole& console, const SessionLoopOptions& options);

}  // namespace ocelli
