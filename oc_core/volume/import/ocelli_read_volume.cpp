// `ocelli-read-volume PARENT SCRATCH FOLDER SERIES FILE`: reads a file or a folder of volumes for readVolumeFile(),
// which starts it and takes the record that it writes to descriptor kChildResultDescriptor. Voxels that must be
// unpacked go to the file SCRATCH, which lies in FOLDER. What goes wrong with the file is a record too.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <span>
#include <string>

#include "oc_core/base/child_process.h"
#include "oc_core/base/error.h"
#include "oc_core/base/reading_budget.h"
#include "oc_core/volume/import/reading_note.h"
#include "oc_core/volume/import/volume_file_readers.h"
#include "oc_core/volume/volume_reader.h"

namespace ocelli {
namespace {

void readVolume(const VolumeReadingTask& task, const std::string& scratchPath, const std::string& folder) {
  ReadingBudget budget(readingLimits(volumeReader()));
  ReaderOutput result;
  const ByteSink sink = [&](std::span<const std::byte> bytes) { result.write(bytes); };
  try {
    ScratchOutput scratch(scratchPath, folder, &budget);
    const VolumeRecord record = readVolumeRecord(task, scratch, &budget);
    writeVolumeRecord(record, sink);
  } catch (const InputError& error) {
    writeVolumeFailure(error.what(), true, sink);
  } catch (const WorkError& error) {
    writeVolumeFailure(error.what(), false, sink);
  } catch (const std::exception& error) {
    writeVolumeFailure(InputError(std::string("cannot read this volume (") + error.what() + ")", task.path.string(),
                                  "check that it is complete, or convert it to NRRD")
                           .what(),
                       true, sink);
  }
  result.flush();
}

int runVolumeReader(std::span<char*> arguments) {
  if (arguments.size() != 6) {
    std::fputs("ocelli-read-volume reads volume files for Ocelli, which starts it\n", stderr);
    return kReaderFailed;
  }
  endWithParent(std::atoi(arguments[1]));
  noteCrashes();
  noteFileRead(arguments[5]);
  try {
    readVolume({arguments[5], arguments[4]}, arguments[2], arguments[3]);
    return kReaderDone;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return kReaderFailed;
  }
}

}  // namespace
}  // namespace ocelli

/// Called by AddressSanitizer alone, where the build has it. What it finds in a library ends this process as a crash
/// does, and it limits the memory in its own way.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() {
  return "abort_on_error=1:detect_leaks=0:hard_rss_limit_mb=2048:max_allocation_size_mb=2048";
}

int main(int count, char** arguments) {
  // Without the destructors of the libraries: they may trip over what they have read, and the system does that faster.
  std::fflush(stderr);
  _exit(ocelli::runVolumeReader({arguments, static_cast<size_t>(count)}));
}
