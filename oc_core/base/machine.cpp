#include "oc_core/base/machine.h"

#include <unistd.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <sstream>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

/// The value of the first line "FIELD : VALUE" of a file of the system.
std::string fieldOf(const char* file, const std::string& field) {
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    const size_t colon = line.find(':');
    if (line.starts_with(field) && colon != std::string::npos) {
      const size_t start = line.find_first_not_of(" \t", colon + 1);
      return start != std::string::npos ? line.substr(start) : "";
    }
  }
  return {};
}

uint64_t memoryField(const std::string& field) {
  uint64_t kibibytes = 0;
  std::istringstream(fieldOf("/proc/meminfo", field)) >> kibibytes;
  return kibibytes << 10U;
}

bool hasAvx2() {
#if defined(__x86_64__) || defined(__i386__)
  return __builtin_cpu_supports("avx2") != 0;
#else
  return false;
#endif
}

}  // namespace

MachineInfo machineInfo() {
  return {fieldOf("/proc/cpuinfo", "model name"), threadCount(), hasAvx2(), memoryField("MemTotal:"),
          memoryField("MemAvailable:")};
}

std::string computerName() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? std::string(name.data()) : "";
}

std::optional<fs::path> findProgram(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path file = fs::path(folder.empty() ? "." : folder) / name;
    std::error_code ignored;
    if (fs::is_regular_file(file, ignored) && access(file.c_str(), X_OK) == 0) {
      return file;
    }
  }
  return std::nullopt;
}

void keepFreedMemory() {
#ifdef __GLIBC__
  constexpr int kMax = 1 << 30;
  mallopt(M_MMAP_THRESHOLD, kMax);
  mallopt(M_TRIM_THRESHOLD, kMax);
#endif
}

}  // namespace ocelli
