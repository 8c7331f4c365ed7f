// Cases of any task as levels of a stimulus: each says its level, and so do the measures of its trials.
#pragma once

#include <memory>
#include <vector>

#include "study/task/task.h"

namespace ocelli {

/// The measure of a trial that tells its level.
inline constexpr const char* kLevelMeasure = "level";

/// `levels` by case.
std::shared_ptr<const TaskBlock> leveledBlock(std::shared_ptr<const TaskBlock> task, std::vector<double> levels);

}  // namespace ocelli
