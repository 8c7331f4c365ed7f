// Blocks of tasks for tests, read from JSON as from a protocol.
#pragma once

#include <string>
#include <vector>

#include "oc_core/base/random.h"
#include "study/task/task.h"

namespace ocelli::test {

/// Of 5 by 6 cells of 3 m, with turns, crossings of all kinds and dead ends; one enters in the south.
Maze studyMaze();
/// The maze "small", and controls as protocols have them that say nothing.
TaskSetting studySetting();

std::shared_ptr<const TaskBlock> readBlock(const std::string& task, const std::string& json,
                                           const TaskSetting& setting = studySetting());
/// What reading it throws; empty where it throws nothing.
std::string readError(const std::string& task, const std::string& json, const TaskSetting& setting = studySetting());

/// A block of each kind, with objects that stand and that move, that ends soon.
struct TaskExample {
  std::string name;
  std::string task;
  std::string json;
  bool walks = true;  ///< the pose changes in a trial
};
const std::vector<TaskExample>& taskExamples();
const TaskExample& taskExample(const std::string& name);

TrialPlan planOf(const std::string& task, int caseIndex, TrialView view, uint64_t seed = 7);

KeyEvent press(Key key, bool shift = false);
KeyEvent release(Key key);
PointerMoveEvent moveTo(const glm::dvec2& place);
PointerButtonEvent button(PointerButton button, bool pressed);
/// Where a click on the scale or dial of a layout says so: the truth, or something far from it.
glm::dvec2 placeOfAnswer(const TrialLayout& layout, double truth, bool isRight);
/// Any input at all, also such as makes no sense.
InputEvent randomInput(Random& random, const TrialScreen& screen);

}  // namespace ocelli::test
