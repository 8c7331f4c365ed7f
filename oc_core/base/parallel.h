// Parallel loops on oneTBB, behind two functions, so that no other header names it.
#pragma once

#include <cstddef>
#include <functional>

namespace ocelli {

/// Upper bound on the threads that parallelFor uses in this process; 0 or less means all cores.
void setThreadCount(int threads);
int threadCount();

/// Calls `body(begin, end)` on disjoint ranges that cover [0, count). `grain` is the least length of a range. Which
/// ranges there are and in which order they run is not determined: write results by index.
void parallelFor(size_t count, size_t grain, const std::function<void(size_t begin, size_t end)>& body);

/// Calls `body(chunk, begin, end)` once for each of `chunks` equal parts of [0, count). The parts depend on `count` and
/// `chunks` alone, so results gathered by chunk are the same with any number of threads.
void parallelChunks(size_t count, size_t chunks,
                    const std::function<void(size_t chunk, size_t begin, size_t end)>& body);

/// Calls `body()` such that the loops within it run on the calling thread alone: for loops over work that has loops of
/// its own.
void runAlone(const std::function<void()>& body);

}  // namespace ocelli
