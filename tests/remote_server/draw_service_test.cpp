// Who is drawn for when, with drawings that take as long as the test says.
#include "oc_core/remote/server/draw_service.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <map>
#include <memory>

#include "oc_core/base/error.h"
#include "tests/remote_server/fake_images.h"

namespace ocelli::test {
namespace {

/// Drawings wait at it until the test opens it, one after the other.
class Gate {
 public:
  void pass() {
    std::unique_lock lock(mutex_);
    ++waiting_;
    changed_.notify_all();
    changed_.wait(lock, [&] { return open_ > 0; });
    --open_;
    --waiting_;
  }
  void open(int count) {
    {
      const std::lock_guard lock(mutex_);
      open_ += count;
    }
    changed_.notify_all();
  }
  /// Waits until so many wait at it.
  bool await(int count) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, kPatience, [&] { return waiting_ == count; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int open_ = 0;
  int waiting_ = 0;
};

struct DrawLog {
  std::mutex mutex;
  std::vector<std::pair<uint64_t, uint32_t>> drawn;
  std::vector<std::string> problems;

  size_t size() {
    const std::lock_guard lock(mutex);
    return drawn.size();
  }
  DrawEvents events() {
    return {.drawing = [](uint64_t, uint32_t) {},
            .drawn =
                [this](uint64_t client, const RemoteImage& image, double) {
                  const std::lock_guard lock(mutex);
                  drawn.emplace_back(client, image.sequence);
                },
            .failed =
                [this](uint64_t, uint32_t, const std::string& problem) {
                  const std::lock_guard lock(mutex);
                  problems.push_back(problem);
                }};
  }
};

RemoteRequest lookOf(uint32_t sequence) {
  RemoteRequest request;
  request.sequence = sequence;
  return request;
}

TEST(DrawService, drawsTheNewestRequestThatWaits) {
  Gate gate;
  DrawLog log;
  DrawService service(
      1,
      [&](const RemoteRequest& request, uint32_t id, const std::function<bool()>&) {
        gate.pass();
        return fakeImage(request, id, 1, 1);
      },
      log.events());
  service.ask(1, lookOf(1));
  ASSERT_TRUE(gate.await(1));
  EXPECT_EQ(service.ask(1, lookOf(2)), 0u);
  EXPECT_EQ(service.ask(2, lookOf(9)), 1u) << "the one that is drawn: its client waits for its link after that";
  service.ask(1, lookOf(3));
  gate.open(1);
  ASSERT_TRUE(eventually([&] { return log.size() == 1; }));
  gate.open(1);
  ASSERT_TRUE(eventually([&] { return log.size() == 2; }));
  EXPECT_EQ(log.drawn[1], std::pair(uint64_t{2}, 9u)) << "the first client cannot take another image yet";
  service.setReady(1, true);
  gate.open(1);
  ASSERT_TRUE(eventually([&] { return log.size() == 3; }));
  EXPECT_EQ(log.drawn[2], std::pair(uint64_t{1}, 3u)) << "request 2 was replaced";
}

TEST(DrawService, dropsWhatNobodyWantsAnyMore) {
  Gate gate;
  DrawLog log;
  std::atomic<int> encoded = 0;
  DrawService service(
      1,
      [&](const RemoteRequest& request, uint32_t id,
          const std::function<bool()>& isWanted) -> std::optional<RemoteImage> {
        gate.pass();
        if (!isWanted()) {
          return std::nullopt;
        }
        ++encoded;
        return fakeImage(request, id, 1, 1);
      },
      log.events());
  service.ask(1, lookOf(1));
  ASSERT_TRUE(gate.await(1));
  service.ask(2, lookOf(2));
  service.ask(3, lookOf(3));
  service.leave(1);  // is being drawn
  service.leave(2);  // waits
  gate.open(2);
  ASSERT_TRUE(eventually([&] { return log.size() == 1; }));
  EXPECT_EQ(log.drawn[0].first, 3u);
  EXPECT_EQ(encoded, 1);
}

TEST(DrawService, tellsWhatFailsAndGoesOn) {
  DrawLog log;
  DrawService service(
      1,
      [&](const RemoteRequest& request, uint32_t id, const std::function<bool()>&) {
        if (request.sequence == 1) {
          throw InputError("nothing to draw", "here", "wait");
        }
        return fakeImage(request, id, 1, 1);
      },
      log.events());
  service.ask(1, lookOf(1));
  ASSERT_TRUE(eventually([&] {
    const std::lock_guard lock(log.mutex);
    return log.problems.size() == 1;
  }));
  service.ask(1, lookOf(2));
  ASSERT_TRUE(eventually([&] { return log.size() == 1; }));
}

/// Whoever hears of a drawing may fail, too, and by what is no std::exception: that client's next turn comes all the
/// same.
TEST(DrawService, goesOnWhereThoseFailWhoHearOfIt) {
  DrawLog log;
  DrawEvents events = log.events();
  events.drawing = [](uint64_t, uint32_t sequence) {
    if (sequence == 1) {
      throw 1;
    }
  };
  events.drawn = [drawn = events.drawn](uint64_t client, const RemoteImage& image, double seconds) {
    if (image.sequence == 2) {
      throw WorkError("no memory", "here", "wait");
    }
    drawn(client, image, seconds);
  };
  events.failed = [failed = events.failed](uint64_t client, uint32_t sequence, const std::string& problem) {
    failed(client, sequence, problem);
    throw WorkError("no memory for this either", "here", "wait");
  };
  DrawService service(
      1,
      [&](const RemoteRequest& request, uint32_t id, const std::function<bool()>&) {
        return fakeImage(request, id, 1, 1);
      },
      std::move(events));
  for (uint32_t sequence = 1; sequence <= 2; ++sequence) {
    service.ask(1, lookOf(sequence));
    ASSERT_TRUE(eventually([&] {
      const std::lock_guard lock(log.mutex);
      return log.problems.size() == sequence;
    }));
  }
  service.ask(1, lookOf(3));
  ASSERT_TRUE(eventually([&] { return log.size() == 1; }));
  EXPECT_EQ(log.drawn[0].second, 3u);
}

TEST(DrawService, endsWhileItDraws) {
  Gate gate;
  DrawLog log;
  auto service = std::make_unique<DrawService>(
      2,
      [&](const RemoteRequest& request, uint32_t id, const std::function<bool()>&) {
        gate.pass();
        return fakeImage(request, id, 1, 1);
      },
      log.events());
  for (uint64_t client = 1; client <= 4; ++client) {
    service->ask(client, lookOf(1));
  }
  ASSERT_TRUE(gate.await(2)) << "two at the same time";
  gate.open(4);
  service.reset();  // waits for those under way: the gate must let them pass
  EXPECT_LE(log.size(), 4u);
}

/// Four clients ask again whenever their image was drawn, which takes longer for some than for others.
TEST(DrawService, fourClientsGetEqualShares) {
  std::mutex mutex;
  std::map<uint64_t, double> had;
  double longest = 0;
  const std::vector<std::chrono::milliseconds> costs{std::chrono::milliseconds(2), std::chrono::milliseconds(6),
                                                     std::chrono::milliseconds(4), std::chrono::milliseconds(8)};
  DrawService* running = nullptr;
  std::atomic<int> left = 60;
  DrawEvents events;
  events.drawing = [](uint64_t, uint32_t) {};
  events.failed = [](uint64_t, uint32_t, const std::string&) {};
  events.drawn = [&](uint64_t client, const RemoteImage&, double seconds) {
    {
      const std::lock_guard lock(mutex);
      had[client] += seconds;
      longest = std::max(longest, seconds);
    }
    if (--left > 0) {
      running->ask(client, lookOf(static_cast<uint32_t>(client)));
      running->setReady(client, true);
    }
  };
  DrawService service(
      1,
      [&](const RemoteRequest& request, uint32_t id, const std::function<bool()>&) {
        const auto begin = std::chrono::steady_clock::now();
        while (std::chrono::steady_clock::now() - begin < costs[request.sequence - 1]) {
        }
        return fakeImage(request, id, 1, 1);
      },
      std::move(events));
  running = &service;
  for (uint64_t client = 1; client <= 4; ++client) {
    service.ask(client, lookOf(static_cast<uint32_t>(client)));
  }
  ASSERT_TRUE(eventually([&] { return left <= 0; }));
  const std::lock_guard lock(mutex);
  ASSERT_EQ(had.size(), 4u);
  for (const auto& [a, secondsOfA] : had) {
    for (const auto& [b, secondsOfB] : had) {
      // One drawing of each: the bound of turn_queue.h. Where the computer is busy, a drawing just takes longer.
      EXPECT_LE(std::abs(secondsOfA - secondsOfB), 2 * longest) << a << " and " << b;
    }
  }
}

}  // namespace
}  // namespace ocelli::test
