// What `ocelli feeds` is asked to do, once its command line is read, and who does it.
//
// OpenCV and FFmpeg bring a hundred libraries, which would make each start of `ocelli` a tenth of a second longer. So
// `ocelli` has the command line alone, and becomes the program `ocelli-feeds` where it comes to the work; that one has
// the same command line, and does the work.
//
// Recipe for another command of `ocelli feeds`:
//   1. here: its choice, and its row in FeedsWork;
//   2. cli/feeds_NAME_command.cpp: its options, declared in feeds_command.h;
//   3. cli/feeds_NAME_work.cpp: the work, declared in feeds_program.h; in ocelli-feeds alone.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/feeds_calibration/calibrate_feeds.h"
#include "oc_core/feeds_calibration/calibration_sheet.h"
#include "oc_core/feeds_live/feeds_run.h"
#include "oc_core/feeds_measure/evaluate_feeds.h"
#include "oc_core/feeds_measure/simulate_feeds.h"

namespace ocelli {

class CommandContext;

struct FeedsRunChoice {
  std::string setup;
  std::string output;       ///< empty where the page or the window shows it alone
  std::optional<int> page;  ///< a port of 127.0.0.1; 0: any that is free
  bool hasWindow = false;
  std::string erased = "background";
  bool hasNoLabels = false;
  std::string checkPoses = "warn";
  FeedsRunOptions options;
  std::string json;
};

struct FeedsSimulateChoice {
  FeedSimulationOptions options;
  std::string output;
  std::string freeze;  ///< "FEED@SECONDS"
  std::string size;    ///< "WIDTHxHEIGHT"; empty: as the rig has it
};

struct FeedsEvaluateChoice {
  std::string folder;
  std::string setup;  ///< empty: that of the folder
  std::string page;   ///< a folder; empty: none
  FeedsEvaluationOptions options;
  std::string json;
};

struct FeedsPanesChoice {
  std::string setup;
  std::string output;
  double seconds = 0;
};

struct FeedsSheetChoice {
  std::string output;
  std::string board;  ///< empty: the usual one where there are no tags, none beside tags
  std::string paper = "a4";
  std::vector<int> tags;
  double tagMillimetres = SheetContents().tagMillimetres;
};

struct FeedsLensChoice {
  std::string views;
  std::string board = kUsualBoard;
  std::string setup;  ///< empty: the lens alone is written
  std::string feed;
  std::string output;
};

struct FeedsPoseChoice {
  std::string setup;
  std::string places;
  std::string output;
  PoseCalibrationOptions options;
};

struct FeedsCheckChoice {
  std::string setup;
  std::string places;  ///< empty: those in the setup
  double movedPixels = kMovedPixels;
};

struct FeedsFacesChoice {
  std::string setup;
  std::string place;
  std::optional<double> metre;
  double maxTurnDegrees = 45;
  std::string output;
};

struct FeedsEditChoice {
  std::string setup;
  std::string place;  ///< empty: walls are unknown
  std::optional<double> metre;
  std::string output;
};

template <typename Choice>
using FeedsWorkOf = std::function<void(const Choice&, const CommandContext&)>;

struct FeedsWork {
  FeedsWorkOf<FeedsRunChoice> run;
  FeedsWorkOf<FeedsSimulateChoice> simulate;
  FeedsWorkOf<FeedsEvaluateChoice> evaluate;
  FeedsWorkOf<FeedsPanesChoice> panes;
  FeedsWorkOf<FeedsSheetChoice> sheet;
  FeedsWorkOf<FeedsLensChoice> lens;
  FeedsWorkOf<FeedsPoseChoice> pose;
  FeedsWorkOf<FeedsCheckChoice> check;
  FeedsWorkOf<FeedsFacesChoice> faces;
  FeedsWorkOf<FeedsEditChoice> edit;
};

}  // namespace ocelli
