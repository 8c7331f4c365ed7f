// Scene files of other programs are read by `ocelli-read-scene` (import/), a process of its own: where Assimp crashes,
// hangs or asks for too much memory, that is an error message here. For scene_file.cpp, and for import/, which shares
// the limits.
#pragma once

#include <cstdint>
#include <filesystem>

#include "oc_core/base/progress.h"
#include "oc_core/scene/scene_record.h"

namespace ocelli {

/// What reading a scene may take. It grows with the bytes of the files that are opened for it.
struct ReadingLimits {
  double memoryBase = 0;     ///< bytes
  double memoryPerByte = 0;  ///< bytes a byte of files
  double memoryMax = 0;      ///< bytes
  double secondsBase = 0;    ///< of one processor
  double secondsPerByte = 0;

  uint64_t memoryBytes(uint64_t fileBytes) const;
  double processorSeconds(uint64_t fileBytes) const;
  /// More than the seconds of a CPU, which may be busy with other things, or wait for a disk.
  double wallSeconds(uint64_t fileBytes) const;
};

/// 1 GiB and 64 bytes a byte, up to three quarters of the memory of this machine; 30 s and 1 s a MiB. The environment
/// variables OCELLI_SCENE_MEMORY_GIB and OCELLI_SCENE_SECONDS set other limits, which do not grow. Throws InputError
/// where one of them is no positive number.
ReadingLimits readingLimits();

/// Exit codes of `ocelli-read-scene`. What is wrong with a file stands in the record of a good end.
inline constexpr int kReaderDone = 0;
inline constexpr int kReaderFailed = 1;
inline constexpr int kReaderOutOfMemory = 3;

/// The program: what OCELLI_SCENE_READER names; else libexec/ocelli/ocelli-read-scene in the folder of the running
/// program or one above it; else where this library was configured to be installed. Throws WorkError where there is
/// none.
///
/// Programs that someone else may have put there are passed over: its owner must be root, this user, or the owner of
/// the running program.
std::filesystem::path sceneReaderProgram();

/// Runs it on a file. Throws InputError where the file cannot be read for whatever reason, WorkError where the program
/// is missing or gives back what is no record, and what `progress` throws.
SceneRecord readInOtherProcess(const std::filesystem::path& path, bool withTextures, const Progress& progress);

}  // namespace ocelli
