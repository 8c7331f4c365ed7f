#include "study/task/task.h"

namespace ocelli {

const std::vector<TaskKind>& taskKinds() {
  static const std::vector<TaskKind> kinds{};
  return kinds;
}

}  // namespace ocelli
