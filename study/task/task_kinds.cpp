#include "study/task/find_task.h"
#include "study/task/task.h"

namespace ocelli {

const std::vector<TaskKind>& taskKinds() {
  static const std::vector<TaskKind> kinds{
      {"find", "walk through a maze and click on an object", readFindTask},
  };
  return kinds;
}

}  // namespace ocelli
