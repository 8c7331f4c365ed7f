#include "study/tasks/task_registry.h"

#include <fmt/format.h>

#include <algorithm>

#include "oc_core/base/error.h"

namespace ocelli {

// Each in its NAME_task.cpp.
TaskKind findTask();
TaskKind countTask();
TaskKind pathTask();
TaskKind nearerTask();

const std::vector<TaskKind>& taskKinds() {
  static const std::vector<TaskKind> kinds{findTask(), countTask(), pathTask(), nearerTask()};
  return kinds;
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
  const auto& kinds = taskKinds();
  const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const TaskKind& kind) { return kind.name == name; });
  if (found == kinds.end()) {
    throw InputError(fmt::format("there is no task \"{}\"", name), where, fmt::format("the tasks are {}", taskNames()));
  }
  return *found;
}

}  // namespace ocelli
