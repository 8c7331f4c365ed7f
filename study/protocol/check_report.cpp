#include "study/protocol/check_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "oc_core/base/json_fields.h"
#include "study/outline/study_factors.h"
#include "study/protocol/balance.h"
#include "study/protocol/coverage.h"
#include "study/protocol/protocol_warnings.h"
#include "study/protocol/schedule.h"
#include "study/protocol/session_length.h"

namespace ocelli {
namespace {

using Json = nlohmann::ordered_json;

const ProtocolBlock& blockOf(const Protocol& protocol, const TrialPlan& trial) {
  return protocol.blocks[static_cast<size_t>(trial.block)];
}

std::pair<int, int> rangeOf(const BalanceTable& table) {
  const auto [least, most] =
      std::minmax_element(table.cells.begin(), table.cells.end(),
                          [](const BalanceCell& a, const BalanceCell& b) { return a.subjects < b.subjects; });
  return {least->subjects, most->subjects};
}

double minutes(double seconds) {
  return seconds / 60;
}

/// "10 s, 5 objects, duplicate colours".
std::string conditionText(const CaseInfo& info) {
  std::string text;
  const auto add = [&](const std::string& what) { text += text.empty() ? what : std::string(", ").append(what); };
  if (info.moving) {
    add("moving");
  }
  if (info.exposureSeconds) {
    add(fmt::format("{:g} s", *info.exposureSeconds));
    if (info.objects) {
      add(fmt::format("{} objects", *info.objects));
    }
  }
  if (info.duplicateColors) {
    add(*info.duplicateColors ? "duplicate colours" : "unique colours");
  }
  return text;
}

std::string lengthText(const Protocol& protocol, const SessionSchedule& schedule) {
  const std::vector<PartLength> parts = partsOf(protocol, schedule);
  std::string text =
      fmt::format("\nSession {} of the subject in slot {}: {} first\n\n  {:<28}{:>7}{:>14}{:>14}\n", schedule.session,
                  schedule.slot, protocol.nameOf(schedule.firstView), "part", "trials", "typical min", "longest min");
  int trials = 0;
  for (const PartLength& part : parts) {
    trials += part.trials;
    text +=
        fmt::format("  {:<28}{:>7}{:>14.1f}{:>14.1f}\n", part.name, part.trials > 0 ? std::to_string(part.trials) : "",
                    minutes(part.duration.typicalSeconds), minutes(part.duration.longestSeconds));
  }
  const Duration all = durationOf(parts);
  return text + fmt::format("  {:<28}{:>7}{:>14.1f}{:>14.1f}\n", "all", trials, minutes(all.typicalSeconds),
                            minutes(all.longestSeconds));
}

/// Of the column of views: as it has always been for a pair.
size_t viewWidth(const Protocol& protocol, size_t ofPair) {
  size_t width = ofPair;
  for (const ViewCondition& condition : protocol.conditions.names.list) {
    width = protocol.conditions.names.isPair() ? width : std::max(width, condition.name.size() + 2);
  }
  return width;
}

std::string scheduleText(const Protocol& protocol, const SessionSchedule& schedule, bool answers) {
  const size_t width = viewWidth(protocol, 5);
  size_t blockWidth = 20;
  size_t caseWidth = 22;
  for (const TrialPlan& trial : schedule.trials) {
    const ProtocolBlock& block = blockOf(protocol, trial);
    blockWidth = std::max(blockWidth, block.name.size() + 2);
    caseWidth = std::max(caseWidth, block.task->caseInfo(trial.caseIndex).label.size() + 2);
  }
  std::string text = fmt::format("\nSchedule\n\n  {:>5}  {:<{}}{:<{}}{:<{}}{}{}\n", "trial", "block", blockWidth,
                                 "case", caseWidth, "view", width, "conditions", answers ? "; answer" : "");
  for (size_t i = 0; i < schedule.trials.size(); ++i) {
    const TrialPlan& trial = schedule.trials[i];
    const ProtocolBlock& block = blockOf(protocol, trial);
    const CaseInfo info = block.task->caseInfo(trial.caseIndex);
    std::string line = fmt::format("  {:>5}  {:<{}}{:<{}}{:<{}}{}", trial.index + 1, block.name, blockWidth,
                                   block.staircase ? "(staircase)" : info.label, caseWidth, protocol.nameOf(trial.view),
                                   width, conditionText(info));
    if (answers && !block.staircase) {
      line += fmt::format("; {}", block.task->answerOf(trial));
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    if (hasBreakAfter(protocol, schedule, i)) {
      text += "         (break)\n";
    }
  }
  return text;
}

std::string staircaseText(const Protocol& protocol) {
  std::string text;
  for (const ProtocolBlock& block : protocol.blocks) {
    if (block.staircase) {
      const BlockStaircase& of = *block.staircase;
      text += fmt::format("\nStaircases of block \"{}\": one in each condition, {} trials each\n\n  {}\n  levels:",
                          block.name, of.trials, of.rule->summary());
      for (const double level : of.levels) {
        text += fmt::format(" {:g}", level);
      }
      text += "\n";
    }
  }
  return text;
}

Json staircasesJson(const Protocol& protocol) {
  Json json = Json::array();
  for (const ProtocolBlock& block : protocol.blocks) {
    if (block.staircase) {
      json.push_back({{"block", block.name},
                      {"method", block.staircase->method},
                      {"trials_of_each_condition", block.staircase->trials},
                      {"levels", block.staircase->levels}});
    }
  }
  return json;
}

std::string balanceText(const std::vector<BalanceTable>& tables, int subjects, int session) {
  if (tables.empty()) {
    return fmt::format("\nBalance of session {}: all subjects have the same schedule\n", session);
  }
  const bool hasTrials = std::any_of(tables.begin(), tables.end(), [](const auto& table) { return table.ofTrials; });
  std::string text = fmt::format("\nBalance of session {} over {} subjects{}\n\n  {:<66}{:>6}{:>10}{:>12}\n", session,
                                 subjects, hasTrials ? "; cells of views one after the other count trials" : "",
                                 "cells of", "cells", "subjects", "difference");
  for (const BalanceTable& table : tables) {
    const auto [least, most] = rangeOf(table);
    text += fmt::format("  {:<66}{:>6}{:>10}{:>12}\n", table.factors, table.cells.size(),
                        least == most ? std::to_string(most) : fmt::format("{}-{}", least, most), table.difference);
  }
  return text;
}

std::string coverageText(const Protocol& protocol, const std::vector<BlockCoverage>& blocks) {
  const size_t width = viewWidth(protocol, 6);
  std::string text = fmt::format(
      "\nCoverage: places where an object shows with {} pixels or more\n\n  {:<28}{:<{}}{:>7}"
      "{:>8}{:>6}{:>7}{:>11}{:>8}{:>8}{:>8}{:>6}{:>9}\n",
      kMinSeenPixels, "block", "view", width, "images", "places", "seen", "twice", "sightings", "median", "least",
      "most", "down", "stretch");
  for (const BlockCoverage& block : blocks) {
    for (const ViewCoverage& view : block.views) {
      text +=
          fmt::format("  {:<28}{:<{}}{:>7}{:>8}{:>6}{:>7}{:>11.2f}{:>8.0f}{:>8}{:>8}{:>6.0f}{:>9.1f}\n", block.block,
                      protocol.nameOf(view.view), width, view.images, view.places, view.seen, view.twice,
                      static_cast<double>(view.sightings) / std::max(1, view.places), medianOf(view.pixels),
                      view.pixels.empty() ? 0 : view.pixels.front(), view.pixels.empty() ? 0 : view.pixels.back(),
                      medianOf(view.degreesDown), medianOf(view.stretches));
      for (const std::string& place : view.unseen) {
        text += block.ofCases ? "" : fmt::format("    not seen: {}\n", place);
      }
    }
  }
  return text +
         "\n  median, least, most: pixels of an object, where it shows largest. down: degrees by which rays to it run "
         "down, stretch: its longer side by its shorter one, medians.\n  Of blocks where an object is to be found: the "
         "cases in sight at the start.\n";
}

Json jsonOf(const Duration& duration) {
  return {{"typical_minutes", minutes(duration.typicalSeconds)}, {"longest_minutes", minutes(duration.longestSeconds)}};
}

Json jsonOf(const Protocol& protocol, const SessionSchedule& schedule, bool answers) {
  Json json{{"slot", schedule.slot},
            {"session", schedule.session},
            {"first_view", protocol.nameOf(schedule.firstView)},
            {"length", jsonOf(durationOf(partsOf(protocol, schedule)))},
            {"parts", Json::array()},
            {"trials", Json::array()}};
  for (const PartLength& part : partsOf(protocol, schedule)) {
    Json entry = jsonOf(part.duration);
    entry["name"] = part.name;
    entry["trials"] = part.trials;
    json["parts"].push_back(entry);
  }
  for (size_t i = 0; i < schedule.trials.size(); ++i) {
    const TrialPlan& trial = schedule.trials[i];
    const ProtocolBlock& block = blockOf(protocol, trial);
    const CaseInfo info = block.task->caseInfo(trial.caseIndex);
    Json entry{{"trial", trial.index + 1},
               {"block", block.name},
               {"task", trial.task},
               {"case", block.staircase ? Json() : Json(info.label)},
               {"view", protocol.nameOf(trial.view)},
               {"moving", info.moving},
               {"seed", trial.seed}};
    if (info.exposureSeconds) {
      entry["exposure_seconds"] = *info.exposureSeconds;
    }
    if (info.objects) {
      entry["objects"] = *info.objects;
    }
    if (info.duplicateColors) {
      entry["duplicate_colors"] = *info.duplicateColors;
    }
    if (answers && !block.staircase) {
      entry["answer"] = block.task->answerOf(trial);
    }
    entry["break_after"] = hasBreakAfter(protocol, schedule, i);
    json["trials"].push_back(entry);
  }
  return json;
}

Json jsonOf(const std::vector<BalanceTable>& tables) {
  Json json = Json::array();
  for (const BalanceTable& table : tables) {
    Json cells = Json::object();
    for (const BalanceCell& cell : table.cells) {
      cells[cell.levels] = cell.subjects;
    }
    json.push_back({{"factors", table.factors}, {"difference", table.difference}, {"cells", cells}});
  }
  return json;
}

Json jsonOf(const Protocol& protocol, const std::vector<BlockCoverage>& blocks) {
  Json json = Json::array();
  for (const BlockCoverage& block : blocks) {
    for (const ViewCoverage& view : block.views) {
      json.push_back({{"block", block.block},
                      {"of", block.ofCases ? "cases at the start" : "places of the maze"},
                      {"view", protocol.nameOf(view.view)},
                      {"images", view.images},
                      {"places", view.places},
                      {"seen", view.seen},
                      {"seen_twice", view.twice},
                      {"sightings", view.sightings},
                      {"fewest_pixels", view.pixels.empty() ? 0 : view.pixels.front()},
                      {"median_pixels", medianOf(view.pixels)},
                      {"most_pixels", view.pixels.empty() ? 0 : view.pixels.back()},
                      {"median_degrees_down", medianOf(view.degreesDown)},
                      {"median_stretch", medianOf(view.stretches)},
                      {"unseen", view.unseen}});
    }
  }
  return json;
}

/// The conditions with their labels and levels; nothing for a pair without factors.
std::string conditionsText(const Protocol& protocol) {
  const ViewConditions& conditions = protocol.conditions.names;
  if (conditions.isPair() && conditions.factors.empty()) {
    return "";
  }
  std::string text = "\nConditions\n\n";
  size_t labelWidth = 28;
  for (const ViewCondition& condition : conditions.list) {
    labelWidth = std::max(labelWidth, condition.label.size());
  }
  for (const ViewCondition& condition : conditions.list) {
    std::string levels;
    for (const StudyFactor& factor : factorsOf(conditions, FactorsOf::kConditions)) {
      levels += fmt::format("{}{} {}", levels.empty() ? "" : ", ", factor.name, condition.levels.at(factor.name));
    }
    const std::string line =
        fmt::format("  {:<{}}{:<{}}  {}", condition.name, viewWidth(protocol, 12), condition.label, labelWidth, levels);
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  const FactorCrossing crossing = crossingOf(conditions);
  for (const std::string& cell : crossing.missing) {
    text += fmt::format("  missing: {}\n", cell);
  }
  for (const std::string& cell : crossing.doubled) {
    text += fmt::format("  doubled: {}\n", cell);
  }
  return text;
}

Json conditionsJson(const Protocol& protocol) {
  Json json = Json::array();
  for (const ViewCondition& condition : protocol.conditions.names.list) {
    Json entry{{"name", condition.name}, {"label", condition.label}};
    if (!condition.levels.empty()) {
      entry["factors"] = condition.levels;
    }
    json.push_back(entry);
  }
  return json;
}

std::string headText(const Protocol& protocol) {
  return fmt::format("{}: {}\n  sha256    {}\n  sessions  {}\n  blocks    {}{}\n  seed      {}\n{}", protocol.name,
                     protocol.title, protocol.sha256, protocol.sessions, protocol.blocks.size(),
                     protocol.shuffleBlocks ? ", their order counterbalanced" : "", protocol.seed,
                     protocol.gaze ? "  gaze      may be recorded: the consent must say so\n" : "");
}

}  // namespace

std::string checkReport(const Protocol& protocol, const CheckOptions& options, const Progress& progress) {
  const SessionSchedule schedule = scheduleOf(protocol, options.slot, options.session, protocol.seed);
  const std::vector<BalanceTable> tables = balanceOf(protocol, options.subjects, options.session, protocol.seed);
  const std::vector<std::string> warnings = warningsOf(protocol, protocol.seed);
  const std::vector<BlockCoverage> coverage =
      options.coverage ? coverageOf(protocol, {}, progress) : std::vector<BlockCoverage>{};
  if (options.asJson) {
    Json json{{"name", protocol.name},         {"title", protocol.title},
              {"sha256", protocol.sha256},     {"seed", protocol.seed},
              {"sessions", protocol.sessions}, {"subjects", options.subjects},
              {"balance", jsonOf(tables)},     {"schedule", jsonOf(protocol, schedule, options.answers)}};
    if (!conditionsText(protocol).empty()) {
      const FactorCrossing crossing = crossingOf(protocol.conditions.names);
      json["conditions"] = conditionsJson(protocol);
      json["missing_cells"] = crossing.missing;
      json["doubled_cells"] = crossing.doubled;
    }
    if (const Json staircases = staircasesJson(protocol); !staircases.empty()) {
      json["staircases"] = staircases;
    }
    if (options.coverage) {
      json["coverage"] = jsonOf(protocol, coverage);
    }
    json["warnings"] = warnings;
    return textOfJson(json, 2) + "\n";
  }
  std::string text = headText(protocol) + conditionsText(protocol) + staircaseText(protocol) +
                     lengthText(protocol, schedule) + scheduleText(protocol, schedule, options.answers) +
                     balanceText(tables, options.subjects, options.session);
  if (options.coverage) {
    text += coverageText(protocol, coverage);
  }
  text += warnings.empty() ? "\nNo warnings\n" : "\nWarnings\n\n";
  for (const std::string& warning : warnings) {
    text += fmt::format("  - {}\n", warning);
  }
  return text;
}

}  // namespace ocelli
