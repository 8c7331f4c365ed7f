// Scene files through Assimp, in this process: for `ocelli-read-scene`, which readSceneFile() runs.
#pragma once

#include <filesystem>

#include "oc_core/base/reading_budget.h"
#include "oc_core/scene/scene_record.h"

namespace ocelli {

/// What readSceneFile() says of files that are not PLY. Throws InputError; Assimp may also crash, run for ever or out
/// of memory, all of which is for another process to notice. `budget` grows with what is opened, and may be null.
SceneRecord readWithAssimp(const std::filesystem::path& path, bool withTextures, ReadingBudget* budget);

}  // namespace ocelli
