// Match a path (section 7.3.3): one is walked along a random path, then chooses its map from several.
#pragma once

#include "study/task/task.h"

namespace ocelli {

/// As TaskKind::read.
std::shared_ptr<const TaskBlock> readPathTask(JsonFields& fields, const std::string& caseField,
                                              const TaskSetting& setting);

}  // namespace ocelli
