#include "analysis/dataset/protocol_facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "analysis/dataset/exclusions.h"
#include "analysis/dataset/json_text.h"

namespace ocelli {
namespace {

constexpr size_t kMaxBytes = 1'000'000;
constexpr size_t kMaxOptions = 1000;
constexpr size_t kMaxConditionBytes = 100;
constexpr int kMaxSide = 64;  ///< cells of a maze

/// What a study does where its protocol does not say it; 0: nothing is done so.
struct UsualFields {
  std::string_view task{};
  double limitSeconds = 0;
  int maps = 0;
};
constexpr UsualFields kUsualFields[] = {{"find", 60, 0}, {"path", 0, 3}};

/// Calls `read` for the objects of a list; the study knows more fields than are read here.
void forEachElement(const JsonText& text, const nlohmann::json& owner, const std::string& pointer, const char* name,
                    const auto& read) {
  const auto list = owner.find(name);
  if (list == owner.end()) {
    return;
  }
  for (size_t i = 0; list->is_array() && i < list->size(); ++i) {
    JsonObject element(text, (*list)[i], fmt::format("{}/{}/{}", pointer, name, i));
    read(element, (*list)[i], fmt::format("{}/{}/{}", pointer, name, i));
  }
}

ProtocolCase readCase(JsonObject& fields, size_t index) {
  ProtocolCase result;
  result.label = fields.textOr("label", kMaxBytes, fmt::format("case {}", index + 1));
  if (fields.has("row") && fields.has("column")) {
    result.row = static_cast<int>(fields.integerOr("row", 0, kMaxSide - 1, 0));
    result.column = static_cast<int>(fields.integerOr("column", 0, kMaxSide - 1, 0));
  }
  result.east = fields.numberOr("east", -0.5, 0.5, 0);
  result.south = fields.numberOr("south", -0.5, 0.5, 0);
  return result;
}

ProtocolBlockFacts readBlock(const JsonText& text, JsonObject& fields, const nlohmann::json& json,
                             const std::string& pointer) {
  ProtocolBlockFacts block;
  block.name = fields.text("name", kMaxBytes);
  block.title = fields.textOr("title", kMaxBytes, block.name);
  block.task = fields.text("task", kMaxBytes);
  block.maze = fields.textOr("maze", kMaxBytes, "");
  block.bothViews = fields.textOr("views", kMaxBytes, "both") == "both";
  block.moving = fields.has("moving");
  block.fovHorizontalDegrees = fields.numberOr("fov_horizontal_degrees", 1, 179, block.fovHorizontalDegrees);
  const UsualFields* usual = std::find_if(std::begin(kUsualFields), std::end(kUsualFields),
                                          [&](const UsualFields& each) { return each.task == block.task; });
  const UsualFields known = usual == std::end(kUsualFields) ? UsualFields{} : *usual;
  if (fields.has("limit_seconds") || known.limitSeconds > 0) {
    block.limitSeconds = fields.numberOr("limit_seconds", 0, 1e6, known.limitSeconds);
  }
  if (fields.has("maps") || known.maps > 0) {
    block.maps = static_cast<int>(fields.integerOr("maps", 2, 100, known.maps));
  }
  if (fields.has("practice")) {
    JsonObject practice(text, fields.value("practice"), fmt::format("{}/practice", pointer));
    block.practiceLeastCorrect = static_cast<int>(practice.integerOr("least_correct", 1, 1000, 1));
  }
  forEachElement(text, json, pointer, "cases", [&](JsonObject& each, const auto&, const std::string&) {
    block.cases.push_back(readCase(each, block.cases.size()));
  });
  return block;
}

PlannedExclusion readRule(JsonObject& fields) {
  PlannedExclusion rule;
  rule.what = fields.text("what", kMaxBytes);
  const std::string test = fields.text("test", kMaxBytes);
  const nlohmann::json& value = fields.value("value");
  if (value.is_string()) {
    rule.text = value.get<std::string>();
  } else {
    rule.number = fields.number("value", 0, 1e9);
  }
  rule.reason = fields.text("reason", kMaxBytes);
  rule.ofProtocol = true;
  const std::string problem = problemOfRule(rule, test, true, value.is_string());
  if (!problem.empty()) {
    fields.fail("what", problem);
  }
  rule.test = *exclusionTestOf(test);
  return rule;
}

ViewConditions readConditions(const JsonText& text, JsonObject& fields) {
  const nlohmann::json& list = fields.value("conditions");
  if (!list.is_array() || list.size() != kViews.size()) {
    fields.fail("conditions", "must be a list of two conditions, of which the first is the reference");
  }
  ViewConditions conditions;
  std::vector<JsonObject> fieldsOf;
  for (size_t i = 0; i < kViews.size(); ++i) {
    JsonObject& each = fieldsOf.emplace_back(text, list[i], fmt::format("/conditions/{}", i));
    conditions.list[i].name = each.text("name", kMaxConditionBytes);
    conditions.list[i].label = each.textOr("label", kMaxConditionBytes, conditions.list[i].name);
  }
  if (const std::optional<ViewConditions::Problem> problem = conditions.problem()) {
    fieldsOf[problem->index].fail(problem->field, problem->what);
  }
  return conditions;
}

/// Fields without options take any text.
FormItem readItem(JsonObject& fields, const std::string& form, const ViewConditions& conditions) {
  FormItem item;
  item.form = form;
  item.name = fields.text("name", kMaxBytes);
  item.question = fields.textOr("question", kMaxBytes, item.name);
  if (fields.has("options")) {
    item.options = fields.texts("options", kMaxOptions, kMaxBytes);
  }
  if (fields.has("ends")) {
    item.ends = fields.texts("ends", 2, kMaxBytes);
  }
  if (fields.has("favors")) {
    const std::vector<std::string> favors = fields.texts("favors", 2, kMaxBytes);
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

ProtocolScreen readScreen(const JsonText& text, JsonObject& fields) {
  ProtocolScreen screen;
  if (fields.has("timing")) {
    screen.lateFactor =
        JsonObject(text, fields.value("timing"), "/timing").numberOr("late_factor", 1, 1000, screen.lateFactor);
  }
  if (fields.has("screen")) {
    JsonObject inner(text, fields.value("screen"), "/screen");
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
  const JsonText json(text, where, "protocols/protocol.schema.json");
  JsonObject fields(json, json.root(), "");
  ProtocolFacts facts;
  facts.name = fields.text("name", kMaxBytes);
  facts.title = fields.textOr("title", kMaxBytes, facts.name);
  facts.description = fields.textOr("description", kMaxBytes, "");
  facts.sessions = static_cast<int>(fields.integerOr("sessions", 1, 1000, 1));
  facts.asksConsent = fields.has("consent");
  if (fields.has("mazes")) {
    for (const auto& [name, maze] : fields.value("mazes").items()) {
      JsonObject object(json, maze, fmt::format("/mazes/{}", name));
      ProtocolMaze read;
      read.name = name;
      read.plan = object.texts("plan", 2 * kMaxSide + 1, 2 * kMaxSide + 1);
      read.cellSize = object.numberOr("cell_size", 0.01, 1000, read.cellSize);
      read.wallThickness = object.numberOr("wall_thickness", 0.001, 500, read.wallThickness);
      facts.mazes.push_back(std::move(read));
    }
  }
  forEachElement(json, json.root(), "", "blocks",
                 [&](JsonObject& each, const nlohmann::json& block, const std::string& pointer) {
                   facts.blocks.push_back(readBlock(json, each, block, pointer));
                 });
  forEachElement(json, json.root(), "", "exclusions", [&](JsonObject& each, const auto&, const std::string&) {
    facts.exclusions.push_back(readRule(each));
  });
  if (fields.has("conditions")) {
    facts.conditions = readConditions(json, fields);
  }
  for (const char* form : {"demographics", "survey"}) {
    if (fields.has(form)) {
      forEachElement(json, fields.value(form), fmt::format("/{}", form), "fields",
                     [&](JsonObject& each, const auto&, const std::string&) {
                       facts.items.push_back(readItem(each, form, facts.conditions));
                     });
    }
  }
  facts.screen = readScreen(json, fields);
  return facts;
}

}  // namespace ocelli
