#include "analysis/dataset/protocol_facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "analysis/dataset/exclusions.h"
#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

// What a study may allow is for its program to say, and databases may be older or newer: these limits are wide.
constexpr size_t kMaxCharacters = 1'000'000;
constexpr size_t kMaxListed = 1'000'000;
constexpr size_t kMaxOptions = 1000;
constexpr size_t kMaxConditionName = 100;
constexpr int kMaxSide = 64;  ///< cells of a maze

/// What a study does where its protocol does not say it; 0: nothing is done so.
struct UsualFields {
  std::string_view task{};
  double limitSeconds = 0;
  int maps = 0;
};
constexpr UsualFields kUsualFields[] = {{"find", 60, 0}, {"path", 0, 3}};

ProtocolMaze readMazePlan(const std::string& name, JsonFields& fields) {
  ProtocolMaze maze;
  maze.name = name;
  maze.plan = fields.texts("plan", 0, 2 * kMaxSide + 1, 2 * kMaxSide + 1);
  maze.cellSize = fields.number("cell_size", 0.01, 1000, maze.cellSize);
  maze.wallThickness = fields.number("wall_thickness", 0.001, 500, maze.wallThickness);
  return maze;
}

ProtocolCase readCase(JsonFields& fields, size_t index) {
  ProtocolCase result;
  result.label = fields.shortText("label", kMaxCharacters, fmt::format("case {}", index + 1));
  if (fields.has("row") && fields.has("column")) {
    result.row = fields.integer("row", 0, kMaxSide - 1, 0);
    result.column = fields.integer("column", 0, kMaxSide - 1, 0);
  }
  result.east = fields.number("east", -0.5, 0.5, 0);
  result.south = fields.number("south", -0.5, 0.5, 0);
  return result;
}

ProtocolBlockFacts readBlock(JsonFields& fields) {
  ProtocolBlockFacts block;
  block.name = fields.shortText("name", kMaxCharacters);
  block.title = fields.shortText("title", kMaxCharacters, block.name);
  block.task = fields.shortText("task", kMaxCharacters);
  block.maze = fields.shortText("maze", kMaxCharacters, "");
  block.bothViews = fields.shortText("views", kMaxCharacters, "both") == "both";
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
  if (fields.has("practice")) {
    block.practiceLeastCorrect = fields.inner("practice").integer("least_correct", 1, 1000, 1);
  }
  fields.forEach("cases", 0, kMaxListed,
                 [&](JsonFields& each) { block.cases.push_back(readCase(each, block.cases.size())); });
  return block;
}

PlannedExclusion readRule(JsonFields& fields) {
  PlannedExclusion rule;
  rule.what = fields.shortText("what", kMaxCharacters);
  const std::string test = fields.shortText("test", kMaxCharacters);
  const nlohmann::json& value = fields.value("value");
  if (value.is_string()) {
    rule.text = value.get<std::string>();
  } else {
    rule.number = fields.number("value", 0, 1e9);
  }
  rule.reason = fields.shortText("reason", kMaxCharacters);
  rule.ofProtocol = true;
  const std::string problem = problemOfRule(rule, test, true, value.is_string());
  if (!problem.empty()) {
    fields.fail("what", problem);
  }
  rule.test = *exclusionTestOf(test);
  return rule;
}

ViewConditions readConditions(JsonFields& fields) {
  const nlohmann::json& list = fields.value("conditions");
  if (!list.is_array() || list.size() != kViews.size()) {
    fields.fail("conditions", "must be a list of two conditions, of which the first is the reference");
  }
  ViewConditions conditions;
  std::vector<JsonFields> all;
  fields.forEach("conditions", kViews.size(), kViews.size(), [&](JsonFields& each) {
    ViewCondition& condition = conditions.list[all.size()];
    condition.name = each.shortText("name", kMaxConditionName);
    condition.label = each.shortText("label", kMaxConditionName, condition.name);
    all.push_back(each);
  });
  if (const std::optional<ViewConditions::Problem> problem = conditions.problem()) {
    all[problem->index].fail(problem->field, problem->what);
  }
  return conditions;
}

/// Fields without options take any text.
FormItem readItem(JsonFields& fields, const std::string& form, const ViewConditions& conditions) {
  FormItem item;
  item.form = form;
  item.name = fields.shortText("name", kMaxCharacters);
  item.question = fields.shortText("question", kMaxCharacters, item.name);
  item.options = fields.texts("options", 0, kMaxOptions, kMaxCharacters);
  item.ends = fields.texts("ends", 0, 2, kMaxCharacters);
  if (fields.has("favors")) {
    const std::vector<std::string> favors = fields.texts("favors", 0, 2, kMaxCharacters);
    const std::optional<TrialView> first = favors.size() == 2 ? conditions.viewNamed(favors[0]) : std::nullopt;
    const std::optional<TrialView> last = favors.size() == 2 ? conditions.viewNamed(favors[1]) : std::nullopt;
    if (!first || !last || first == last) {
      const auto& [reference, other] = conditions.list;
      fields.fail("favors", fmt::format(R"(must be ["{0}", "{1}"] or ["{1}", "{0}"])", reference.name, other.name));
    }
    item.lastFavors = last;
  } else if (const std::optional<TrialView> view = viewFavoredByLastEnd(item.ends, conditions)) {
    item.lastFavors = view;
    item.favorsFromWords = true;
  }
  return item;
}

ProtocolScreen readScreen(JsonFields& fields) {
  ProtocolScreen screen;
  if (fields.has("timing")) {
    screen.lateFactor = fields.inner("timing").number("late_factor", 1, 1000, screen.lateFactor);
  }
  if (fields.has("screen")) {
    JsonFields inner = fields.inner("screen");
    const auto length = [&](const char* name) {
      return inner.has(name) ? std::optional<double>(inner.number(name, 0, 1e6)) : std::nullopt;
    };
    screen.widthMillimeters = length("width_millimeters");
    screen.heightMillimeters = length("height_millimeters");
    screen.distanceMillimeters = length("distance_millimeters");
    screen.refreshHertz = length("refresh_hertz");
  }
  return screen;
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
    facts.name = fields.shortText("name", kMaxCharacters);
    facts.title = fields.shortText("title", kMaxCharacters, facts.name);
    facts.description = fields.shortText("description", kMaxCharacters, "");
    facts.sessions = fields.integer("sessions", 1, 1000, 1);
    facts.asksConsent = fields.has("consent");
    fields.forEachNamed("mazes", kMaxListed, [&](const std::string& name, JsonFields& each) {
      facts.mazes.push_back(readMazePlan(name, each));
    });
    fields.forEach("blocks", 0, kMaxListed, [&](JsonFields& each) { facts.blocks.push_back(readBlock(each)); });
    fields.forEach("exclusions", 0, kMaxListed, [&](JsonFields& each) { facts.exclusions.push_back(readRule(each)); });
    if (fields.has("conditions")) {
      facts.conditions = readConditions(fields);
    }
    for (const char* form : {"demographics", "survey"}) {
      if (fields.has(form)) {
        fields.inner(form).forEach("fields", 0, kMaxListed, [&](JsonFields& each) {
          facts.items.push_back(readItem(each, form, facts.conditions));
        });
      }
    }
    facts.screen = readScreen(fields);
    return facts;
  });
}

}  // namespace ocelli
