#include "oc_core/base/reading_budget.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <new>

#include "oc_core/base/sanitizer.h"

namespace ocelli {
namespace {

void setSoftLimit(__rlimit_resource resource, uint64_t wanted) {
  rlimit limit{};
  if (getrlimit(resource, &limit) == 0) {
    limit.rlim_cur = std::min<rlim_t>(wanted, limit.rlim_max);
    setrlimit(resource, &limit);
  }
}

[[noreturn]] void endForLackOfMemory() {
  _exit(kReaderOutOfMemory);
}

}  // namespace

ReadingBudget::ReadingBudget(const ReadingLimits& limits) : limits_(limits) {
  const rlimit none{};
  setrlimit(RLIMIT_CORE, &none);
  // Should the system run out of memory all the same, it ends this process first.
  std::ofstream("/proc/self/oom_score_adj") << 1000;
  std::set_new_handler(endForLackOfMemory);
  apply();
}

void ReadingBudget::addFile(uint64_t bytes) {
  fileBytes_ += bytes;
  apply();
}

void ReadingBudget::addMemory(uint64_t bytes) {
  memoryBytes_ += bytes;
  apply();
}

void ReadingBudget::addWriting(uint64_t bytes) {
  writtenBytes_ += bytes;
  apply();
}

void ReadingBudget::apply() const {
  const uint64_t memory = limits_.memoryBytes(fileBytes_) + memoryBytes_;
  const uint64_t most = std::min(memory, static_cast<uint64_t>(limits_.memoryMax));
  if (!kAddressSanitizer) {
    setSoftLimit(RLIMIT_AS, most);
  }
  // What is written counts as memory of nobody.
  setSoftLimit(RLIMIT_FSIZE, most + writtenBytes_);
  setSoftLimit(RLIMIT_CPU, static_cast<uint64_t>(limits_.processorSeconds(fileBytes_)));
}

}  // namespace ocelli
