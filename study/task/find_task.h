// Find an object (section 7.3.1): one walks through a maze and clicks on it, as soon as possible. It stands in a place,
// or walks about from there.
#pragma once

#include "study/task/task.h"

namespace ocelli {

/// As TaskKind::read.
std::shared_ptr<const TaskBlock> readFindTask(JsonFields& fields, const std::string& caseField,
                                              const TaskSetting& setting);

}  // namespace ocelli
