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
#include "study/outline/local_text.h"
#include "study/outline/question_kinds.h"
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

ProtocolBlockFacts readBlock(JsonFields& fields, const std::vector<StudyFactor>& factors, const std::string& language) {
  ProtocolBlockFacts block{readBlockOutline(fields, ProtocolReading::kByAnalysis, language)};
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

/// Of all questions, each row of a matrix for itself.
void addItems(ProtocolFacts& facts, const ProtocolForm& form) {
  for (const QuestionItem& each : itemsOf(form.fields)) {
    const FormField& field = form.fields[static_cast<size_t>(each.field)];
    FormItem item{form.name, each.name, each.label, storedOptions(field), field.ends};
    item.value = questionKind(field.kind).value;
    item.mayStayOpen = !field.required;
    if (item.value != QuestionValue::kOption) {
      std::swap(item.options, item.choices);
    }
    if (!field.favors.empty()) {
      item.lastFavors = field.favors.back();
      item.firstFavors = field.favors.front();
    } else if (const auto view = viewFavoredByLastEnd(item.ends, facts.conditions);
               view && item.value == QuestionValue::kOption) {
      item.lastFavors = view;
      item.firstFavors = otherThan(*view);
      item.favorsFromWords = true;
    }
    facts.items.push_back(item);
  }
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
    const std::string language = readLanguage(fields);
    facts.title = localText(fields, "title", kMaxStoredCharacters, language, facts.name);
    facts.description = localText(fields, "description", kMaxStoredCharacters, language, "");
    facts.sessions = fields.integer("sessions", 1, 1000, 1);
    facts.asksConsent = fields.has("consent");
    fields.forEachNamed("mazes", kMaxListed, [&](const std::string& name, JsonFields& each) {
      facts.mazes.push_back(readMazePlan(name, each));
    });
    facts.conditions = readConditionNames(fields, [](JsonFields&, TrialView) {});
    const std::vector<StudyFactor>& factors = facts.conditions.factors;
    fields.forEach("blocks", 0, kMaxListed,
                   [&](JsonFields& each) { facts.blocks.push_back(readBlock(each, factors, language)); });
    fields.forEach("exclusions", 0, kMaxListed, [&](JsonFields& each) { facts.exclusions.push_back(readRule(each)); });
    for (const ProtocolForm& form : readAllForms(fields, {facts.conditions, ProtocolReading::kByAnalysis, language})) {
      if (form.name == "demographics" || form.name == "survey") {
        addItems(facts, form);
      } else {
        facts.otherForms.push_back(form);
      }
    }
    for (const ProtocolForm& form : facts.otherForms) {
      addItems(facts, form);
    }
    facts.screen = readStatedScreen(fields, ProtocolReading::kByAnalysis);
    facts.timing = readTimingLimits(fields, ProtocolReading::kByAnalysis);
    return facts;
  });
}

}  // namespace ocelli
