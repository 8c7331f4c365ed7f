// The devices of a run besides screen, keyboard and mouse: what subjects answer with, and what tells where they look.
#pragma once

#include <memory>
#include <vector>

#include "study/gaze/gaze_input.h"
#include "study/live/live_status.h"
#include "study/markers/marker_output.h"
#include "study/responses/response_input.h"
#include "study/screen/study_run.h"
#include "study/session/session_flow.h"

namespace ocelli {

class RunDevices {
 public:
  /// Opens them, on the main thread. Throws InputError for options that are wrong or do not fit the protocol, WorkError
  /// where a device is not there. `options` must outlive it.
  RunDevices(const Protocol& protocol, const StudyRunOptions& options);

  ResponseInput& responses() { return *responses_; }
  /// From begin() on; null where there is none.
  GazeInput* gaze() { return gaze_.get(); }

  /// Records which devices there are, and begins to read where the subject looks.
  void begin(SessionFlow& flow, const TrialScreen& screen);
  /// Records what came of them, and tells the experimenter.
  void end(SessionFlow& flow);

  /// For the experimenter's page, with outputs of markers.
  std::vector<LiveDevice> liveDevices(const std::vector<std::string>& markers,
                                      const std::vector<MarkerCounts>& counts) const;

 private:
  void report(SessionFlow& flow, const std::string& what, const std::string& detail) const;

  const StudyRunOptions& options_;
  std::unique_ptr<ResponseInput> responses_;
  std::unique_ptr<GazeBytes> gazeBytes_{};  ///< until begin()
  std::unique_ptr<GazeInput> gaze_{};
};

}  // namespace ocelli
