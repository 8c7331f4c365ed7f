#include "oc_core/base/parallel.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <memory>
#include <mutex>

namespace ocelli {
namespace {

// oneTBB's limit is process-wide by nature: the one piece of state that a parallel loop cannot be handed.
struct ThreadLimit {
  std::mutex mutex;
  std::unique_ptr<tbb::global_control> control;
  int threads = 0;
};

ThreadLimit& threadLimit() {
  static ThreadLimit limit;
  return limit;
}

}  // namespace

void setThreadCount(int threads) {
  ThreadLimit& limit = threadLimit();
  const std::scoped_lock lock(limit.mutex);
  limit.control.reset();
  limit.threads = std::max(threads, 0);
  if (threads > 0) {
    limit.control = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                          static_cast<size_t>(threads));
  }
}

int threadCount() {
  ThreadLimit& limit = threadLimit();
  const std::scoped_lock lock(limit.mutex);
  return limit.threads > 0 ? limit.threads : tbb::info::default_concurrency();
}

void parallelFor(size_t count, size_t grain, const std::function<void(size_t, size_t)>& body) {
  if (count == 0) {
    return;
  }
  tbb::parallel_for(tbb::blocked_range<size_t>(0, count, std::max<size_t>(grain, 1)),
                    [&](const tbb::blocked_range<size_t>& range) { body(range.begin(), range.end()); });
}

void parallelChunks(size_t count, size_t chunks, const std::function<void(size_t, size_t, size_t)>& body) {
  chunks = std::max<size_t>(chunks, 1);
  parallelFor(chunks, 1, [&](size_t first, size_t last) {
    for (size_t chunk = first; chunk < last; ++chunk) {
      body(chunk, count * chunk / chunks, count * (chunk + 1) / chunks);
    }
  });
}

void runAlone(const std::function<void()>& body) {
  tbb::task_arena(1).execute(body);
}

}  // namespace ocelli
