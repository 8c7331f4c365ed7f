#include "study/tasks/task_registry.h"

#include <fmt/format.h>

#include <algorithm>

#include "oc_core/base/error.h"
#include "oc_core/base/registry.h"

namespace ocelli {

// Each in its NAME_task.cpp.
TaskKind findTask();
TaskKind countTask();
TaskKind pathTask();
TaskKind nearerTask();
TaskKind distanceTask();
TaskKind directionTask();
TaskKind frontmostTask();

namespace {

Registry<TaskKind>& taskRegistry() {
  static Registry<TaskKind> registry(
      "task", {findTask(), countTask(), pathTask(), nearerTask(), distanceTask(), directionTask(), frontmostTask()});
  return registry;
}

}  // namespace

Rows<TaskKind> taskKinds() {
  return taskRegistry().rows();
}

void registerTask(TaskKind kind) {
  const auto isSmallLetter = [](char c) { return c >= 'a' && c <= 'z'; };
  if (kind.name.empty() || !std::all_of(kind.name.begin(), kind.name.end(), isSmallLetter)) {
    throw InputError("a task cannot have this name", fmt::format("\"{}\"", kind.name), "use small letters from a to z");
  }
  if (kind.read == nullptr || kind.policy == nullptr) {
    throw InputError("this task has no reader or no policy", kind.name, "set `read` and `policy` of its row");
  }
  for (const char* effect : {kGraphEffect, kSubjectSd, kItemSd, kItemViewSd}) {
    if (!kind.generator.indexOf(effect)) {
      throw InputError(fmt::format("the model of this task lacks the effect \"{}\"", effect), kind.name,
                       "add it to `generator` of its row");
    }
  }
  if (kind.outcome == OutcomeKind::kEstimate && kind.generator.unit == nullptr) {
    throw InputError("the model of this task lacks the unit of its estimates", kind.name,
                     "set `generator.unit` of its row");
  }
  taskRegistry().add(std::move(kind));
}

std::string taskNames() {
  std::string names;
  for (const TaskKind& kind : taskKinds()) {
    names += fmt::format("{}{}", names.empty() ? "" : ", ", kind.name);
  }
  return names;
}

const InstructionImage* instructionImage(std::string_view name) {
  for (const TaskKind& kind : taskKinds()) {
    for (const InstructionImage& image : kind.images) {
      if (image.name == name) {
        return &image;
      }
    }
  }
  return nullptr;
}

const TaskKind& taskKind(std::string_view name, const std::string& where) {
  const Rows<TaskKind> kinds = taskKinds();
  const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const TaskKind& kind) { return kind.name == name; });
  if (found == kinds.end()) {
    throw InputError(fmt::format("there is no task \"{}\"", name), where, fmt::format("the tasks are {}", taskNames()));
  }
  return *found;
}

}  // namespace ocelli
