// The task "react": after a delay an answer appears on the screen, and one presses its key, Enter, as fast as one can.
// The oldest of all tasks (Donders, 1868), and a check of the whole way from a key to the database.
//
// In a protocol: {"task": "react", "answer_limit_seconds": 3, "cases": [{"label": "short", "delay_seconds": 0.8}, ...]}
#pragma once

#include "study/tasks/task_registry.h"

ocelli::TaskKind reactTask();
