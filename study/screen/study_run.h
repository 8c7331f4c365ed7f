// A session of a subject at this computer, from the checks before to the last screen.
//
// What can go wrong is looked for before the subject sits down, cheap things first: the protocol, the database and its
// disk, the subject, the monitor, the graphics, the timing.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "study/live/live_board.h"
#include "study/protocol/protocol.h"
#include "study/responses/response_input.h"
#include "study/session/records.h"

namespace ocelli {

struct StudyRunOptions {
  std::filesystem::path database;
  std::string subject;
  std::optional<int> session{};  ///< from 1; nothing for the first of a new subject, or the one to be resumed
  int monitor = 0;               ///< of listMonitors()
  std::optional<glm::ivec2> windowed{};
  bool force = false;              ///< runs although the timing check refuses, and marks every trial
  int hashEvery = 0;               ///< every so many frames of a trial the hash of its image is stored; 0 for none
  std::optional<uint64_t> seed{};  ///< instead of the protocol's, for a session that begins
  bool anyTime = false;            ///< although the time between sessions has not passed
  std::filesystem::path screenshots{};
  std::vector<std::string> markers{};    ///< where markers go (study/markers/marker_output.h)
  std::vector<std::string> responses{};  ///< what subjects answer with (study/responses/response_device.h)
  double debounceMilliseconds = kUsualDebounceMilliseconds;
  std::string gaze{};                 ///< where samples of gaze come from (study/gaze/gaze_input.h); empty for none
  std::shared_ptr<LiveBoard> live{};  ///< gets the status of the session
  bool liveShowsConditions = false;   ///< LiveOptions::showsConditions
  std::function<bool()> interrupted{};
  std::function<void(const std::string& line)> tell{};  ///< what the experimenter reads before the session
};

/// A new session. Throws InputError where an option is wrong or does not fit what is stored, WorkError where the
/// database, the graphics or the timing are not fit for a session.
SessionEnding runStudy(const Protocol& protocol, const StudyRunOptions& options);

/// The session that was broken off, or else the next one, with the protocol that the database holds.
SessionEnding resumeStudy(const StudyRunOptions& options);

/// "0: DELL U2412M, 1920x1200, 60 Hz, 518 x 324 mm", a line a monitor.
std::string monitorList();

}  // namespace ocelli
