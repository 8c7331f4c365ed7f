// What an analysis reads of a protocol's text, as a database holds it. The study has checked the text before it ran;
// fields that an analysis does not need are not looked at.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/dataset/form_item.h"
#include "study/outline/block_outline.h"
#include "study/outline/exclusion_rule.h"
#include "study/outline/screen_fields.h"
#include "study/outline/usual_values.h"

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
  FactorLevels levels{};  ///< of each factor of cases, where the block has these
};

struct ProtocolBlockFacts : BlockOutline {
  std::string maze{};  ///< name of one of ProtocolFacts::mazes; empty where it has none
  bool moving = false;
  double fovHorizontalDegrees = kUsualFovHorizontalDegrees;
  std::optional<double> limitSeconds{};  ///< of a search
  std::optional<int> maps{};             ///< among which a path is chosen
  std::vector<ProtocolCase> cases{};
};

struct ProtocolFacts {
  std::string name;
  std::string title;
  std::string description;
  int sessions = 1;
  bool asksConsent = false;
  std::vector<ProtocolBlockFacts> blocks{};
  std::vector<ProtocolMaze> mazes{};
  std::vector<ExclusionRule> exclusions{};
  std::vector<FormItem> items{};  ///< of "demographics", then of "survey"
  StatedScreen screen{};
  TimingLimits timing{};
  ViewConditions conditions = defaultConditions();

  const ProtocolMaze* findMaze(const std::string& maze) const;
};

/// Of its blocks, each once.
std::vector<std::string> tasksOf(const ProtocolFacts& facts);

/// Throws InputError that names `where` and the line.
ProtocolFacts protocolFacts(const std::string& text, const std::string& where);

}  // namespace ocelli
