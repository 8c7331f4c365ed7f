// `ocelli-read-scene PARENT textures|plain FILE`: reads a scene file for readSceneFile(), which starts it and takes the
// record that it writes to descriptor kChildResultDescriptor. What goes wrong with the file is a record too.
#include <unistd.h>

#include <assimp/DefaultLogger.hpp>
#include <assimp/LogStream.hpp>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <span>
#include <string>

#include "oc_core/base/child_process.h"
#include "oc_core/base/error.h"
#include "oc_core/scene/import/assimp_scene.h"
#include "oc_core/scene/scene_reader.h"

namespace ocelli {
namespace {

/// The last line is shown where Assimp crashes.
class LogToStandardError : public Assimp::LogStream {
 public:
  void write(const char* message) override { std::fputs(message, stderr); }
};

void readScene(const std::string& path, bool withTextures) {
  ReadingBudget budget(readingLimits(sceneReader()));
  Assimp::DefaultLogger::create("", Assimp::Logger::NORMAL, 0);
  // The logger owns it.
  Assimp::DefaultLogger::get()->attachStream(new LogToStandardError, Assimp::Logger::Err | Assimp::Logger::Warn);
  ReaderOutput result;
  const ByteSink sink = [&](std::span<const std::byte> bytes) { result.write(bytes); };
  SceneRecord record;
  std::string failure;
  try {
    record = readWithAssimp(path, withTextures, &budget);
  } catch (const InputError& error) {
    failure = error.what();
  } catch (const std::exception& error) {
    failure = InputError(std::string("cannot read this scene file (") + error.what() + ")", path,
                         "check that it is complete, or convert it to binary PLY")
                  .what();
  }
  if (failure.empty()) {
    writeSceneRecord(record, sink);
  } else {
    writeFailureRecord(failure, sink);
  }
  result.flush();
}

int run(std::span<char*> arguments) {
  if (arguments.size() != 4) {
    std::fputs("ocelli-read-scene reads scene files for Ocelli, which starts it\n", stderr);
    return kReaderFailed;
  }
  endWithParent(std::atoi(arguments[1]));
  try {
    readScene(arguments[3], std::strcmp(arguments[2], "textures") == 0);
    return kReaderDone;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return kReaderFailed;
  }
}

}  // namespace
}  // namespace ocelli

/// Called by AddressSanitizer alone, where the build has it. What it finds in Assimp ends this process as a crash does,
/// and it limits the memory in its own way.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() {
  return "abort_on_error=1:detect_leaks=0:hard_rss_limit_mb=2048:max_allocation_size_mb=2048";
}

int main(int count, char** arguments) {
  // Without the destructors of what Assimp has read: they may trip over it, and the system does that faster.
  std::fflush(stderr);
  _exit(ocelli::run({arguments, static_cast<size_t>(count)}));
}
