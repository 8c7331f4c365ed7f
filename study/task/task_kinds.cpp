#include "study/task/count_task.h"
#include "study/task/find_task.h"
#include "study/task/path_task.h"
#include "study/task/task.h"

namespace ocelli {

const std::vector<TaskKind>& taskKinds() {
  static const std::vector<TaskKind> kinds{
      {"find", "walk through a maze and click on an object", readFindTask},
      {"count", "count the objects in a maze that is shown for a while", readCountTask},
      {"path", "watch a walk along a path, and choose its map", readPathTask},
  };
  return kinds;
}

}  // namespace ocelli
