// What an analysis reads of a protocol's text, as a database holds it. The study has checked the text before it ran;
// fields that an analysis does not need are not looked at.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/dataset/analysis_plan.h"
#include "analysis/dataset/form_item.h"

namespace ocelli {

/// A maze as it is drawn: "+-|" and spaces, north at the top.
struct ProtocolMaze {
  std::string name;
  std::vector<std::string> plan;
  double cellSize = 3;  ///< metres, from the middle of a wall to that of the next
  double wallThickness = 0.3;
};

struct ProtocolCase {
  std::string label;
  // Of the object that is sought.
  std::optional<int> row{};
  std::optional<int> column{};
  double east = 0;  ///< from the middle of the cell, in cell sizes
  double south = 0;
};

struct ProtocolBlockFacts {
  std::string name;
  std::string title;
  std::string task;
  std::string maze;                           ///< name of one of ProtocolFacts::mazes; empty where it has none
  std::optional<int> practiceLeastCorrect{};  ///< in a row; nothing where there is no practice
  bool bothViews = true;                      ///< a subject sees each case in both
  bool moving = false;
  double fovHorizontalDegrees = 70;
  std::optional<double> limitSeconds{};  ///< of a search
  std::optional<int> maps{};             ///< among which a path is chosen
  std::vector<ProtocolCase> cases{};
};

/// Of the screen and its timing, as the study wants them.
struct ProtocolScreen {
  std::optional<double> widthMillimeters{};
  std::optional<double> heightMillimeters{};
  std::optional<double> distanceMillimeters{};  ///< from the eye
  std::optional<double> refreshHertz{};
  double lateFactor = 1.2;  ///< a frame of more intervals than that is a dropped one
};

struct ProtocolFacts {
  std::string name;
  std::string title;
  std::string description;
  int sessions = 1;
  bool asksConsent = false;
  std::vector<ProtocolBlockFacts> blocks{};
  std::vector<ProtocolMaze> mazes{};
  std::vector<PlannedExclusion> exclusions{};
  std::vector<FormItem> items{};  ///< of "demographics", then of "survey"
  ProtocolScreen screen{};
  ViewConditions conditions = defaultConditions();

  const ProtocolMaze* findMaze(const std::string& maze) const;
};

/// Of its blocks, each once.
std::vector<std::string> tasksOf(const ProtocolFacts& facts);

/// Throws InputError that names `where` and the line.
ProtocolFacts protocolFacts(const std::string& text, const std::string& where);

}  // namespace ocelli
