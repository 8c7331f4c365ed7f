#include "oc_core/base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace ocelli {
namespace {

class Parallel : public testing::Test {
 protected:
  void TearDown() override { setThreadCount(0); }
};

TEST_F(Parallel, ForCoversEachIndexOnce) {
  for (const size_t count : {size_t{1}, size_t{2}, size_t{1000}, size_t{65537}}) {
    std::vector<std::atomic<int>> visits(count);
    parallelFor(count, 16, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        ++visits[i];
      }
    });
    for (const auto& visit : visits) {
      ASSERT_EQ(visit, 1);
    }
  }
}

TEST_F(Parallel, ForOfNothingDoesNothing) {
  parallelFor(0, 1, [](size_t, size_t) { FAIL() << "there is nothing to do"; });
}

TEST_F(Parallel, ForTakesAnyGrain) {
  std::atomic<size_t> sum = 0;
  parallelFor(100, 0, [&](size_t begin, size_t end) { sum += end - begin; });
  parallelFor(100, 1000, [&](size_t begin, size_t end) { sum += end - begin; });
  EXPECT_EQ(sum, 200u);
}

TEST_F(Parallel, ChunksAreTheSameWithAnyThreadCount) {
  using Part = std::tuple<size_t, size_t, size_t>;
  const auto parts = [](int threads) {
    setThreadCount(threads);
    std::mutex mutex;
    std::set<Part> found;
    parallelChunks(1003, 7, [&](size_t chunk, size_t begin, size_t end) {
      const std::scoped_lock lock(mutex);
      found.insert({chunk, begin, end});
    });
    return found;
  };
  const std::set<Part> alone = parts(1);
  EXPECT_EQ(alone.size(), 7u);
  EXPECT_EQ(parts(2), alone);
  EXPECT_EQ(parts(8), alone);
  size_t next = 0;
  for (const auto& [chunk, begin, end] : alone) {
    EXPECT_EQ(begin, next);
    next = end;
  }
  EXPECT_EQ(next, 1003u);
}

TEST_F(Parallel, ChunksMayOutnumberTheItems) {
  std::atomic<size_t> items = 0;
  std::atomic<int> calls = 0;
  parallelChunks(3, 8, [&](size_t, size_t begin, size_t end) {
    items += end - begin;
    ++calls;
  });
  EXPECT_EQ(items, 3u);
  EXPECT_EQ(calls, 8);
}

// The way results stay the same: sums of floats gathered by chunk, added in the order of the chunks.
TEST_F(Parallel, SumsGatheredByChunkHaveTheSameBits) {
  const auto sum = [](int threads) {
    setThreadCount(threads);
    std::vector<float> sums(64);
    parallelChunks(100000, sums.size(), [&](size_t chunk, size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        sums[chunk] += std::sin(static_cast<float>(i));
      }
    });
    float total = 0;
    for (const float part : sums) {
      total += part;
    }
    return total;
  };
  const float alone = sum(1);
  for (const int threads : {2, 3, 8}) {
    EXPECT_EQ(sum(threads), alone) << threads << " threads";
  }
}

TEST_F(Parallel, ThreadCountIsAnUpperBound) {
  setThreadCount(1);
  EXPECT_EQ(threadCount(), 1);
  std::mutex mutex;
  std::set<std::thread::id> threads;
  parallelFor(1000, 1, [&](size_t, size_t) {
    const std::scoped_lock lock(mutex);
    threads.insert(std::this_thread::get_id());
  });
  EXPECT_EQ(threads.size(), 1u);
}

TEST_F(Parallel, NoLimitMeansEveryCore) {
  setThreadCount(3);
  setThreadCount(-1);
  EXPECT_GE(threadCount(), 1);
  EXPECT_NE(threadCount(), 0);
}

TEST_F(Parallel, AnExceptionReachesTheCaller) {
  EXPECT_THROW(parallelFor(100, 1, [](size_t, size_t) { throw std::runtime_error("work failed"); }),
               std::runtime_error);
}

}  // namespace
}  // namespace ocelli
