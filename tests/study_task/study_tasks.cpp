#include "tests/study_task/study_tasks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/worlds/maze_file.h"
#include "study/tasks/task_registry.h"
#include "tests/study_task/study_maze_plan.h"

namespace ocelli::test {

Maze studyMaze() {
  return mazeFromJsonText(std::string(R"({"plan": )") + kStudyMazePlan + "}", "test maze");
}

TaskSetting studySetting() {
  TaskSetting setting;
  setting.mazes.emplace("small", studyMaze());
  return setting;
}

std::shared_ptr<const TaskBlock> readBlock(const std::string& task, const std::string& json,
                                           const TaskSetting& setting) {
  const nlohmann::json value = parseJson(json, "block");
  JsonFields fields(value, "block");
  auto block = taskKind(task, "test").read(fields, "cases", setting);
  fields.rejectUnknown();
  return block;
}

std::string readError(const std::string& task, const std::string& json, const TaskSetting& setting) {
  try {
    readBlock(task, json, setting);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

const std::vector<TaskExample>& taskExamples() {
  static const std::string pinholes = R"("pinholes": {"rows": 1, "columns": 2, "views": [
      {"row": 2, "column": 0, "heading": "east"}, {"row": 0, "column": 5, "heading": 180, "pitch_degrees": -5}]})";
  static const std::vector<TaskExample> examples{
      {"find", "find",
       R"({"maze": "small", "limit_seconds": 6, "cases": [{"label": "near", "row": 2, "column": 3},
           {"label": "far", "row": 0, "column": 0, "east": 0.1, "south": -0.2}]})"},
      {"findMoving", "find",
       R"({"maze": "small", "limit_seconds": 6, "moving": {"meters_per_second": 1.3},
           "object": {"shape": "cube", "color": "blue"},
           "cases": [{"row": 2, "column": 3, "east": 0.3}, {"row": 0, "column": 0}]})"},
      {"count", "count", R"({"maze": "small", "answer_limit_seconds": 3, )" + pinholes + R"(,
           "cases": [{"objects": 4, "exposure_seconds": 0.5}, {"objects": 7, "exposure_seconds": 1,
           "duplicate_colors": true}]})",
       false},
      {"countMoving", "count",
       R"({"maze": "small", "answer_limit_seconds": 3, "moving": {"meters_per_second": 2}, )" + pinholes + R"(,
           "cases": [{"objects": 5, "exposure_seconds": 2}, {"objects": 7, "exposure_seconds": 1}]})",
       false},
      {"path", "path",
       R"({"maze": "small", "meters_per_second": 6, "turns": 3, "least_seconds": 4, "most_seconds": 7,
           "answer_limit_seconds": 6, "cases": [{"label": "first"}, {"label": "second"}]})"},
      {"nearer", "nearer", R"({"maze": "small", "answer_limit_seconds": 8,
           "start": {"row": 2, "column": 0, "heading": "east"}, "cases": [
           {"label": "near", "left": {"row": 2, "column": 2, "south": -0.25},
                             "right": {"row": 2, "column": 4, "south": 0.25}},
           {"label": "far", "left": {"row": 2, "column": 5, "south": -0.25},
                            "right": {"row": 2, "column": 3, "south": 0.25}}]})",
       false},
      {"distance", "distance", R"({"maze": "small", "answer_limit_seconds": 12,
           "start": {"row": 2, "column": 0, "heading": "east"}, "cases": [
           {"label": "near", "row": 2, "column": 2, "south": -0.25},
           {"label": "far", "row": 2, "column": 5, "south": 0.25}]})",
       false},
      {"direction", "direction", R"({"maze": "small", "answer_limit_seconds": 12,
           "start": {"row": 2, "column": 0, "heading": "east"}, "cases": [
           {"label": "left", "row": 2, "column": 2, "south": -0.25},
           {"label": "right", "row": 2, "column": 3, "south": 0.25}]})",
       false},
      {"directionFromMemory", "direction", R"({"maze": "small", "answer_limit_seconds": 12, "exposure_seconds": 2,
           "start": {"row": 2, "column": 0, "heading": "east"}, "cases": [
           {"label": "left", "row": 2, "column": 2, "south": -0.25}]})",
       false},
      {"frontmost", "frontmost", R"({"maze": "small", "answer_limit_seconds": 8, "object": {"shape": "cube"},
           "start": {"row": 2, "column": 0, "heading": "east"}, "cases": [
           {"label": "left", "left": {"ahead_meters": 5, "right_meters": -0.25},
                             "right": {"ahead_meters": 6.2, "right_meters": 0.25}},
           {"label": "right", "left": {"ahead_meters": 6.2, "right_meters": -0.25},
                              "right": {"ahead_meters": 5, "right_meters": 0.25, "shape": "sphere"}}]})",
       false},
  };
  return examples;
}

const TaskExample& taskExample(const std::string& name) {
  for (const TaskExample& example : taskExamples()) {
    if (example.name == name) {
      return example;
    }
  }
  throw std::logic_error("no example of this name");
}

TrialPlan planOf(const std::string& task, int caseIndex, TrialView view, uint64_t seed) {
  TrialPlan plan;
  plan.task = task;
  plan.caseIndex = caseIndex;
  plan.view = view;
  plan.seed = seed;
  return plan;
}

KeyEvent press(Key key, bool shift) {
  return {key, true, {shift, false, false}};
}

KeyEvent release(Key key) {
  return {key, false, {}};
}

PointerMoveEvent moveTo(const glm::dvec2& place) {
  return {place.x, place.y};
}

PointerButtonEvent button(PointerButton button, bool pressed) {
  return {button, pressed, {}};
}

glm::dvec2 placeOfAnswer(const TrialLayout& layout, double truth, bool isRight) {
  if (layout.scale) {
    const TrialLayout::Scale& scale = *layout.scale;
    const double answer = isRight ? truth : truth > scale.most / 2 ? scale.most / 10 : scale.most;
    const double share = (answer - scale.least) / (scale.most - scale.least);
    return {std::min(scale.place.left + share * scale.place.width, scale.place.right() - 1), scale.place.center().y};
  }
  const TrialLayout::Dial& dial = layout.dial.value();
  const double angle = radiansFromDegrees(isRight ? truth : truth + 180);
  return dial.place.center() + dial.place.width * 0.4 * glm::dvec2(std::sin(angle), -std::cos(angle));
}

InputEvent randomInput(Random& random, const TrialScreen& screen) {
  const Modifiers modifiers{random.below(4) == 0, random.below(9) == 0, random.below(9) == 0};
  switch (random.below(16)) {
    case 0:
      return PointerButtonEvent{static_cast<PointerButton>(random.below(3)), random.below(2) == 0, modifiers};
    case 1:
      return PointerMoveEvent{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()};
    case 2:
      return PointerMoveEvent{1e300, -1e300};
    case 3:
    case 4:
    case 5:
      return PointerMoveEvent{static_cast<double>(random.inRange(-50, static_cast<float>(screen.width + 50))),
                              static_cast<double>(random.inRange(-50, static_cast<float>(screen.height + 50)))};
    case 6:
      return ScrollEvent{1, -3};
    case 7:
      return ResizeEvent{static_cast<int>(random.below(3000)), 0, 1, 1};
    case 8:
      return TextEvent{static_cast<char32_t>(random.below(70000))};
    case 9:
      return CloseEvent{};
    default:
      return KeyEvent{static_cast<Key>(random.below(kKeyCount)), random.below(3) != 0, modifiers};
  }
}

}  // namespace ocelli::test
