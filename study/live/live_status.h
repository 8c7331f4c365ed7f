// What the experimenter's page shows of a session that runs. Nothing in it identifies the subject: no id, no answers to
// forms, no text that somebody typed. Which condition a trial has is left out where the experimenter is to stay blind.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace ocelli {

/// A trial that has ended.
struct LiveTrial {
  int number = 0;              ///< in the schedule, from 1; 0 for practice
  std::string outcome;         ///< "right", "wrong", "time over" or "broken off"
  double responseSeconds = 0;  ///< 0 where it was broken off
  std::string condition{};     ///< empty where it is hidden
};

struct LiveDevice {
  std::string name;   ///< "markers udp"
  std::string state;  ///< "120 sent, 0 lost"
  bool hasTrouble = false;
};

struct LiveWarning {
  double seconds = 0;  ///< since the run began
  std::string text;
};

struct LiveStatus {
  std::string step;         ///< "trial 12 of 24, find stationary"
  std::string state;        ///< "running", "paused", "calls you" or "ended"
  std::string condition{};  ///< of the trial that runs; empty where it is hidden, and between trials
  bool hidesCondition = true;
  int trialsDone = 0;
  int trials = 0;
  int block = 0;  ///< of the session, from 1
  int blocks = 0;
  double elapsedSeconds = 0;  ///< of this run
  double secondsLeft = 0;     ///< of trials and breaks, about
  bool leftByPace = false;    ///< as fast as so far; else as the protocol says

  // Timing of the frames of this run's trials.
  long long frames = 0;
  long long dropped = 0;
  double lastMedianMilliseconds = 0;
  double lastLongestMilliseconds = 0;
  long long lastDropped = 0;
  std::map<std::string, int> verdicts{};  ///< trials of each

  std::vector<LiveTrial> lastTrials{};  ///< the newest first
  std::vector<LiveDevice> devices{};
  std::vector<LiveWarning> warnings{};  ///< the newest first
  int warningCount = 0;                 ///< of all
};

/// JSON; `ageSeconds` is how old the status is.
std::string jsonText(const LiveStatus& status, double ageSeconds);

}  // namespace ocelli
