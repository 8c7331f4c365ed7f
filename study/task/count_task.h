// Count the objects in a maze (section 7.3.2): it is shown for a while, whole, by one comprehensive graph camera or by
// a matrix of pinholes that were laid by hand; then one says how many objects there were.
#pragma once

#include "study/task/task.h"

namespace ocelli {

/// As TaskKind::read.
std::shared_ptr<const TaskBlock> readCountTask(JsonFields& fields, const std::string& caseField,
                                               const TaskSetting& setting);

}  // namespace ocelli
