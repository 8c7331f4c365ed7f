#include "tests/ranks/thread_ranks.h"

#include <algorithm>
#include <barrier>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

namespace ocelli::test {
namespace {

struct Job {
  explicit Job(int ranks) : size(static_cast<size_t>(ranks)), together(ranks), slots(size * size) {}

  size_t size;
  std::barrier<> together;
  std::vector<Bytes> slots;  ///< from each rank to each
  std::mutex mutex;          ///< of what follows
  std::condition_variable arrived;
  std::map<std::pair<int, int>, std::vector<Bytes>> letters;  ///< from one rank to one other, the oldest first
};

class ThreadRanks final : public Ranks {
 public:
  ThreadRanks(Job& job, int rank) : job_(job), rank_(rank) {}

  int rank() const override { return rank_; }
  int size() const override { return static_cast<int>(job_.size); }

  Bytes broadcast(Bytes bytes) override {
    std::vector<Bytes> pieces(job_.size);
    if (isFirst()) {
      std::fill(pieces.begin(), pieces.end(), bytes);
    }
    return exchangeAll(pieces).front();
  }
  std::vector<Bytes> gather(std::span<const std::byte> mine) override {
    std::vector<Bytes> all = gatherToAll(mine);
    return isFirst() ? all : std::vector<Bytes>{};
  }
  std::vector<Bytes> gatherToAll(std::span<const std::byte> mine) override {
    return exchangeAll(std::vector<Bytes>(job_.size, Bytes(mine.begin(), mine.end())));
  }
  std::vector<Bytes> exchangeAll(const std::vector<Bytes>& pieces) override {
    const auto own = static_cast<size_t>(rank_);
    for (size_t to = 0; to < job_.size; ++to) {
      job_.slots[own * job_.size + to] = pieces[to];
      bytesSent_ += to == own ? 0 : pieces[to].size();
    }
    job_.together.arrive_and_wait();
    std::vector<Bytes> received;
    for (size_t from = 0; from < job_.size; ++from) {
      received.push_back(job_.slots[from * job_.size + own]);
    }
    job_.together.arrive_and_wait();
    return received;
  }
  Bytes exchange(int partner, std::span<const std::byte> bytes) override {
    std::unique_lock lock(job_.mutex);
    job_.letters[{rank_, partner}].emplace_back(bytes.begin(), bytes.end());
    bytesSent_ += bytes.size();
    job_.arrived.notify_all();
    std::vector<Bytes>& waiting = job_.letters[{partner, rank_}];
    job_.arrived.wait(lock, [&] { return !waiting.empty(); });
    Bytes letter = std::move(waiting.front());
    waiting.erase(waiting.begin());
    return letter;
  }
  uint64_t largest(uint64_t mine) override {
    BytesOf number(mine);
    uint64_t found = 0;
    for (const Bytes& each : gatherToAll(number.bytes)) {
      found = std::max(found, BytesOf::numberIn(each));
    }
    return found;
  }
  void abort(int /*exitCode*/) override { std::terminate(); }

 private:
  struct BytesOf {
    explicit BytesOf(uint64_t number) : bytes(sizeof(number)) {
      for (size_t i = 0; i < sizeof(number); ++i) {
        bytes[i] = static_cast<std::byte>(number >> 8 * i);
      }
    }
    static uint64_t numberIn(const Bytes& bytes) {
      uint64_t number = 0;
      for (size_t i = 0; i < sizeof(number); ++i) {
        number |= static_cast<uint64_t>(bytes[i]) << 8 * i;
      }
      return number;
    }
    Bytes bytes;
  };

  Job& job_;
  int rank_;
};

}  // namespace

void runInRanks(int size, const std::function<void(Ranks&)>& work) {
  Job job(size);
  std::vector<std::exception_ptr> failures(static_cast<size_t>(size));
  std::vector<std::thread> threads;
  for (int rank = 0; rank < size; ++rank) {
    threads.emplace_back([&, rank] {
      ThreadRanks ranks(job, rank);
      try {
        work(ranks);
      } catch (...) {
        failures[static_cast<size_t>(rank)] = std::current_exception();
        job.together.arrive_and_drop();
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  for (const std::exception_ptr& failure : failures) {
    if (failure) {
      std::rethrow_exception(failure);
    }
  }
}

}  // namespace ocelli::test
