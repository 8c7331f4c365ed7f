// Scene files of other programs are read by `ocelli-read-scene` (import/), a process of its own
// (base/reader_process.h): where Assimp crashes, hangs or asks for too much memory, that is an error message here. For
// scene_file.cpp, and for import/, which shares the limits.
#pragma once

#include <filesystem>

#include "oc_core/base/progress.h"
#include "oc_core/base/reader_process.h"
#include "oc_core/scene/scene_record.h"

namespace ocelli {

/// `ocelli-read-scene`. Its limits are set by OCELLI_SCENE_MEMORY_GIB and OCELLI_SCENE_SECONDS, its place by
/// OCELLI_SCENE_READER.
const ReaderProgram& sceneReader();

/// Runs it on a file. Throws InputError where the file cannot be read for whatever reason, WorkError where the program
/// is missing or gives back what is no record, and what `progress` throws.
SceneRecord readInOtherProcess(const std::filesystem::path& path, bool withTextures, const Progress& progress);

}  // namespace ocelli
