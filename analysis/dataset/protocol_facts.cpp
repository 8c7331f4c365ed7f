#include "analysis/dataset/protocol_facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include "analysis/dataset/exclusions.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/maze/maze_plan.h"
#include "study/outline/condition_names.h"
#include "study/outline/form_field.h"
#include "study/outline/study_factors.h"

namespace ocelli {
namespace {

constexpr size_t kMaxListed = 1'000'000;

/// What a study does where its protocol does not say it; 0: nothing is done so.
struct UsualFields {
  std::string_view task{};
  double limitSeconds = 0;
  int maps = 0;
};
constexpr UsualFields kUsualFields[] = {{"find", kUsualFindLimitSeconds, 0}, {"path", 0, kUsualPathMaps}};

ProtocolMaze readMazePlan(const std::string& name, JsonFields& fields) {
  ProtocolMaze maze;
  maze.name = name;
  maze.plan = fields.texts("plan", 0, 2 * kMaxMazeSide + 1, 2 * kMaxMazeSide + 1);
  maze.cellSize = fields.number("cell_size", 0.01, 1000, maze.cellSize);
  maze.wallThickness = fields.number("wall_thickness", 0.001, 500, maze.wallThickness);
  return maze;
}

ProtocolCase readCase(JsonFields& fields, size_t index, const std::vector<StudyFactor>& factors) {
  ProtocolCase result;
  result.label = fields.shortText("label", kMaxStoredCharacters, fmt::format("case {}", index + 1));
  if (fields.has("row") && fields.has("column")) {
    result.row = fields.integer("row", 0, kMaxMazeSide - 1, 0);
    result.column = fields.integer("column", 0, kMaxMazeSide - 1, 0);
  }
  result.east = fields.number("east", -0.5, 0.5, 0);
  result.south = fields.number("south", -0.5, 0.5, 0);
  if (fields.has("factors")) {
    result.levels = readLevels(fields, factors, FactorsOf::kCases);
  }
  return result;
}

ProtocolBlockFacts readBlock(JsonFields& fields, const std::vector<StudyFactor>& factors) {
  ProtocolBlockFacts block{readBlockOutline(fields, ProtocolReading::kByAnalysis)};
  block.maze = fields.shortText("maze", kMaxStoredCharacters, "");
  block.moving = fields.has("moving");
  block.fovHorizontalDegrees = fields.number("fov_horizontal_degrees", 1, 179, block.fovHorizontalDegrees);
  const UsualFields* usual = std::find_if(std::begin(kUsualFields), std::end(kUsualFields),
                                          [&](const UsualFields& each) { return each.task == block.task; });
  const UsualFields known = usual == std::end(kUsualFields) ? UsualFields{} : *usual;
  if (fields.has("limit_seconds") || known.limitSeconds > 0) {
    block.limitSeconds = fields.number("limit_seconds", 0, 1e6, known.limitSeconds);
  }
  if (fields.has("maps") || known.maps > 0) {
    block.maps = fields.integer("maps", 2, 100, known.maps);
  }
  fields.forEach("cases", 0, kMaxListed,
                 [&](JsonFields& each) { block.cases.push_back(readCase(each, block.cases.size(), factors)); });
  return block;
}

ExclusionRule readRule(JsonFields& fields) {
  const ExclusionRule rule = readExclusionRule(fields, kMaxStoredCharacters);
  const bool isText = !rule.text.empty() || std::isnan(rule.number);
  const std::string problem = problemOfRule(rule, nameOf(rule.test), true, isText);
  if (!problem.empty()) {
    fields.fail("what", problem);
  }
  return rule;
}

FormItem readItem(JsonFields& fields, const std::string& form, const ViewConditions& conditions) {
  const FormField field = readFormField(fields, conditions, ProtocolReading::kByAnalysis);
  FormItem item{form, field.name, field.question, field.options, field.ends};
  if (!field.favors.empty()) {
    item.lastFavors = field.favors.back();
    item.firstFavors = field.favors.front();
  } else if (const std::optional<TrialView> view = viewFavoredByLastEnd(item.ends, conditions)) {
    item.lastFavors = view;
    item.firstFavors = otherThan(*view);
    item.favorsFromWords = true;
  }
  return item;
}

}  // namespace

const ProtocolMaze* ProtocolFacts::findMaze(const std::string& maze) const {
  const auto found = std::find_if(mazes.begin(), mazes.end(), [&](const ProtocolMaze& m) { return m.name == maze; });
  return found == mazes.end() ? nullptr : &*found;
}

std::vector<std::string> tasksOf(const ProtocolFacts& facts) {
  std::vector<std::string> tasks;
  for (const ProtocolBlockFacts& block : facts.blocks) {
    if (std::find(tasks.begin(), tasks.end(), block.task) == tasks.end()) {
      tasks.push_back(block.task);
    }
  }
  return tasks;
}

ProtocolFacts protocolFacts(const std::string& text, const std::string& where) {
  return readAs("protocols/protocol.schema.json", [&] {
    const JsonDocument document(text, where);
    JsonFields fields(document, UnknownFields::kIgnored);
    ProtocolFacts facts;
    facts.name = fields.shortText("name", kMaxStoredCharacters);
    facts.title = fields.shortText("title", kMaxStoredCharacters, facts.name);
    facts.description = fields.shortText("description", kMaxStoredCharacters, "");
    facts.sessions = fields.integer("sessions", 1, 1000, 1);
    facts.asksConsent = fields.has("consent");
    fields.forEachNamed("mazes", kMaxListed, [&](const std::string& name, JsonFields& each) {
      facts.mazes.push_back(readMazePlan(name, each));
    });
    facts.conditions = readConditionNames(fields, [](JsonFields&, TrialView) {});
    const std::vector<StudyFactor>& factors = facts.conditions.factors;
    fields.forEach("blocks", 0, kMaxListed,
                   [&](JsonFields& each) { facts.blocks.push_back(readBlock(each, factors)); });
    fields.forEach("exclusions", 0, kMaxListed, [&](JsonFields& each) { facts.exclusions.push_back(readRule(each)); });
    for (const char* form : {"demographics", "survey"}) {
      if (fields.has(form)) {
        fields.inner(form).forEach("fields", 0, kMaxListed, [&](JsonFields& each) {
          facts.items.push_back(readItem(each, form, facts.conditions));
        });
      }
    }
    facts.screen = readStatedScreen(fields, ProtocolReading::kByAnalysis);
    facts.timing = readTimingLimits(fields, ProtocolReading::kByAnalysis);
    return facts;
  });
}

}  // namespace ocelli
