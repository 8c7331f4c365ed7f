// A study that was made up for tests: a protocol without tasks, and records as sessions leave them.
#pragma once

#include "study/protocol/schedule.h"
#include "study/session/session_sink.h"

namespace ocelli::test {

/// Two blocks, two sessions, a consent, demographics of two fields and a survey of one; no tasks.
Protocol madeProtocol(const std::string& comment = "");

/// `trials` trials of the first block and as many of the second, views in turn.
SessionSchedule madeSchedule(int slot, int session, int trials);

RunRecord madeRun(const std::string& subject, int session, SubjectKind kind = SubjectKind::kPerson);

/// A completed trial with an outcome that its plan and `salt` decide.
TrialRecord madeTrial(const TrialPlan& plan, int attempt, int salt);
/// Frames `first` to `first` + `count` of a walk that `salt` decides, at 60 Hz.
std::vector<FrameRecord> madeFrames(int first, int count, int salt);
/// One of each kind of event.
std::vector<InputRecord> madeInputs();

/// One that is valid with a pupil, one without, and one where nothing was seen.
std::vector<GazeRecord> madeGaze();

/// Hands a whole trial to the sink, frames in pieces of 30.
void storeTrial(SessionSink& sink, int number, const TrialRecord& record, int frames, int salt,
                std::function<void()> acknowledged = {});

}  // namespace ocelli::test
