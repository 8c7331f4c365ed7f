#include "oc_core/scene/scene_reader.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

#include "oc_core/base/child_process.h"
#include "oc_core/base/error.h"
#include "oc_core/base/machine.h"
#include "oc_core/base/number_text.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMemoryVariable = "OCELLI_SCENE_MEMORY_GIB";
constexpr const char* kSecondsVariable = "OCELLI_SCENE_SECONDS";
constexpr const char* kProgramVariable = "OCELLI_SCENE_READER";
constexpr const char* kProgramName = "ocelli-read-scene";
constexpr double kMebibyte = 1 << 20;
constexpr double kGibibyte = 1 << 30;

std::optional<double> positiveVariable(const char* name) {
  const char* text = std::getenv(name);
  if (text == nullptr || *text == '\0') {
    return std::nullopt;
  }
  const std::optional<double> value = numberFromText<double>(text);
  if (!value || *value <= 0 || *value > 1e9) {
    throw InputError(fmt::format("\"{}\" is not a number above 0, and at most 1e9", text), name,
                     fmt::format("{}=16", name));
  }
  return value;
}

/// Whether only those who could change the running program anyway can have put this one there.
bool isTrusted(const fs::path& program) {
  struct stat own {};
  struct stat other {};
  if (stat(program.c_str(), &other) != 0 || !S_ISREG(other.st_mode) || access(program.c_str(), X_OK) != 0) {
    return false;
  }
  const bool isOwnersOfThis = stat("/proc/self/exe", &own) == 0 && own.st_uid == other.st_uid;
  return other.st_uid == 0 || other.st_uid == geteuid() || isOwnersOfThis;
}

/// The last line that Assimp wrote before it ended, for those who look into it.
std::string lastLine(std::string_view messages) {
  constexpr size_t kMaxShown = 200;
  while (!messages.empty() && (messages.back() == '\n' || messages.back() == ' ')) {
    messages.remove_suffix(1);
  }
  const size_t start = messages.rfind('\n');
  messages.remove_prefix(start == std::string_view::npos ? 0 : start + 1);
  return std::string(messages.substr(0, kMaxShown));
}

[[noreturn]] void failSignal(const ChildEnd& end, const std::string& where, double seconds) {
  if (end.code == SIGXCPU) {
    throw InputError(fmt::format("reading this file took longer than {:.0f} s", seconds), where,
                     fmt::format("convert it to binary PLY, or set {} to more seconds", kSecondsVariable));
  }
  if (end.code == SIGKILL) {
    throw InputError("the system ended the reading of this file, probably for lack of memory", where,
                     "close other programs, or reduce the mesh");
  }
  const std::string last = lastLine(end.messages);
  throw InputError(fmt::format("Assimp crashed while it read this file ({}{}{})", strsignal(end.code),
                               last.empty() ? "" : "; it last wrote: ", last),
                   where, "the file may be damaged: export it again, if need be in another format such as glTF or PLY");
}

}  // namespace

uint64_t ReadingLimits::memoryBytes(uint64_t fileBytes) const {
  return static_cast<uint64_t>(std::min(memoryBase + memoryPerByte * static_cast<double>(fileBytes), memoryMax));
}

double ReadingLimits::processorSeconds(uint64_t fileBytes) const {
  return std::ceil(secondsBase + secondsPerByte * static_cast<double>(fileBytes));
}

double ReadingLimits::wallSeconds(uint64_t fileBytes) const {
  constexpr double kBusy = 4;
  return kBusy * processorSeconds(fileBytes);
}

ReadingLimits readingLimits() {
  ReadingLimits limits{kGibibyte, 64, 1e18, 30, 1 / kMebibyte};
  if (const auto memory = static_cast<double>(machineInfo().memoryBytes); memory > 0) {
    limits.memoryMax = std::max(kGibibyte, 0.75 * memory);
  }
  if (const std::optional<double> gibibytes = positiveVariable(kMemoryVariable)) {
    limits.memoryBase = limits.memoryMax = *gibibytes * kGibibyte;
    limits.memoryPerByte = 0;
  }
  if (const std::optional<double> seconds = positiveVariable(kSecondsVariable)) {
    limits.secondsBase = *seconds;
    limits.secondsPerByte = 0;
  }
  return limits;
}

fs::path sceneReaderProgram() {
  if (const char* given = std::getenv(kProgramVariable); given != nullptr && *given != '\0') {
    if (access(given, X_OK) != 0) {
      throw WorkError("there is no program that reads scene files", given,
                      fmt::format("let {} name the program {}, or unset it", kProgramVariable, kProgramName));
    }
    return given;
  }
  std::error_code ignored;
  fs::path folder = fs::read_symlink("/proc/self/exe", ignored);
  while (folder.has_relative_path()) {
    folder = folder.parent_path();
    const fs::path program = folder / "libexec" / "ocelli" / kProgramName;
    if (isTrusted(program)) {
      return program;
    }
  }
  if (const fs::path installed = OCELLI_SCENE_READER_INSTALLED; isTrusted(installed)) {
    return installed;
  }
  throw WorkError(
      fmt::format("the program {} is missing, which reads scene files other than PLY", kProgramName),
      OCELLI_SCENE_READER_INSTALLED,
      fmt::format("install Ocelli whole, or let the environment variable {} name the program", kProgramVariable));
}

SceneRecord readInOtherProcess(const fs::path& path, bool withTextures, const Progress& progress) {
  const std::string where = path.string();
  const ReadingLimits limits = readingLimits();
  std::error_code ignored;
  const uintmax_t bytes = fs::file_size(path, ignored);
  const ChildCommand command{sceneReaderProgram(),
                             {std::to_string(getpid()), withTextures ? "textures" : "plain", where},
                             limits.wallSeconds(bytes)};
  const ChildEnd end = runChild(command, [&] { report(progress, "loading the scene", 0); });
  switch (end.how) {
    case ChildEnd::How::kOutOfTime:
      throw InputError(fmt::format("reading this file took longer than {:.0f} s", command.seconds), where,
                       fmt::format("convert it to binary PLY, or set {} to more seconds", kSecondsVariable));
    case ChildEnd::How::kKilledBySignal:
      failSignal(end, where, limits.processorSeconds(bytes));
    case ChildEnd::How::kExited:
      break;
  }
  if (end.code == kReaderOutOfMemory) {
    throw InputError(
        fmt::format("reading this file takes more than {:.1f} GiB of memory, far more than its size explains",
                    static_cast<double>(limits.memoryBytes(bytes)) / kGibibyte),
        where, fmt::format("the file may be damaged; if not, set {} to more GiB", kMemoryVariable));
  }
  if (end.code != kReaderDone) {
    throw WorkError(
        fmt::format("the program that reads scene files failed (exit code {}): {}", end.code, lastLine(end.messages)),
        command.program.string(), "install Ocelli whole, so that both are of one version");
  }
  return sceneFromRecord(end.result.bytes(), command.program.string());
}

}  // namespace ocelli
