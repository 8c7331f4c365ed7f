// Clients that go without a word, or read nothing: they cost nothing, and are in nobody's way.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <condition_variable>
#include <mutex>

#include "tests/remote_server/fake_images.h"

namespace ocelli::test {
namespace {

constexpr size_t kLargeBytes = 4'000'000;  // more than sockets of loopback hold

/// Draws nothing until it is opened.
struct Floodgate {
  std::mutex mutex;
  std::condition_variable changed;
  bool isOpen = false;
  std::atomic<int> begun = 0;
  std::atomic<int> encoded = 0;

  RemoteDraw draw() {
    return [this](const RemoteRequest& request, uint32_t id,
                  const std::function<bool()>& isWanted) -> std::optional<RemoteImage> {
      ++begun;
      std::unique_lock lock(mutex);
      changed.wait(lock, [&] { return isOpen; });
      if (!isWanted()) {
        return std::nullopt;
      }
      ++encoded;
      return fakeImage(request, id, kLargeBytes, 0);
    };
  }
  void open() {
    {
      const std::lock_guard lock(mutex);
      isOpen = true;
    }
    changed.notify_all();
  }
};

TEST(VanishingClients, WhatIsDrawnForThemIsDropped) {
  Floodgate gate;
  RemoteServerSetup setup = fakeSetup();
  setup.draw = gate.draw();
  const RemoteServer server(std::move(setup));
  TestWebSocket crashing(server.port());
  TestWebSocket waiting(server.port());
  ASSERT_TRUE(crashing.sendText(lookText(1)));
  ASSERT_TRUE(eventually([&] { return gate.begun == 1; }));
  ASSERT_TRUE(waiting.sendText(lookText(2)));
  ASSERT_TRUE(eventually([&] { return server.counts().looks == 2; }));
  crashing.socket().reset();
  waiting.socket().close();
  EXPECT_TRUE(eventually([&] { return server.counts().connectionsNow == 0; }));
  gate.open();
  TestWebSocket honest(server.port());
  ASSERT_TRUE(honest.sendText(lookText(3)));
  const auto image = awaitImage(honest);
  ASSERT_TRUE(image);
  EXPECT_EQ(image->header.sequence, 3u);
  EXPECT_EQ(gate.encoded, 1) << "neither the drawing under way nor the one that waited was encoded";
  EXPECT_EQ(gate.begun, 2);
}

TEST(VanishingClients, TheMemoryOfTheirImagesIsFreed) {
  RemoteServerSetup setup = fakeSetup();
  setup.limits.clients = 100;
  setup.limits.connectionsPerAddress = 100;
  setup.draw = [](const RemoteRequest& request, uint32_t id, const std::function<bool()>&) {
    return fakeImage(request, id, kLargeBytes, 0);
  };
  const RemoteServer server(std::move(setup));
  std::vector<TestWebSocket> clients;
  for (int i = 0; i < 10; ++i) {
    clients.emplace_back(server.port());
    // Many looks, of which the client reads no answer: still one image each.
    for (uint32_t k = 0; k < 20; ++k) {
      ASSERT_TRUE(clients.back().sendText(lookText(k)));
    }
  }
  ASSERT_TRUE(eventually([&] { return server.counts().looks == 200; }));
  EXPECT_TRUE(eventually([&] { return server.counts().imageBytesNow > 0; }));
  EXPECT_LE(server.counts().imageBytesNow, 10 * kLargeBytes);
  for (size_t i = 0; i < clients.size(); ++i) {
    i % 2 == 0 ? clients[i].socket().reset() : clients[i].socket().close();
  }
  EXPECT_TRUE(eventually([&] { return server.counts().connectionsNow == 0; }));
  EXPECT_EQ(server.counts().imageBytesNow, 0u);
}

/// One that reads nothing holds one image, and the next is drawn for the view that was asked for last.
TEST(VanishingClients, ASlowOneGetsTheNewestViewNext) {
  std::atomic<int> drawn = 0;
  RemoteServerSetup setup = fakeSetup();
  setup.draw = [&](const RemoteRequest& request, uint32_t id, const std::function<bool()>&) {
    ++drawn;
    return fakeImage(request, id, kLargeBytes, 0);
  };
  const RemoteServer server(std::move(setup));
  TestWebSocket slow(server.port());
  ASSERT_TRUE(slow.sendText(lookText(1)));
  ASSERT_TRUE(eventually([&] { return drawn == 1; }));
  for (uint32_t k = 2; k <= 20; ++k) {
    ASSERT_TRUE(slow.sendText(lookText(k)));
  }
  ASSERT_TRUE(eventually([&] { return server.counts().looks == 20; }));
  EXPECT_EQ(drawn, 1) << "nothing is drawn ahead of what it can take";
  const auto first = awaitImage(slow);
  const auto second = awaitImage(slow);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->header.sequence, 1u);
  EXPECT_EQ(second->header.sequence, 20u);
  EXPECT_EQ(drawn, 2);
}

/// Half-open: the other end is there for the kernel, and says nothing any more.
TEST(VanishingClients, OneThatAnswersNoPingIsGone) {
  RemoteServerSetup setup = fakeSetup();
  setup.limits.pingSeconds = 1;
  const RemoteServer server(std::move(setup));
  TestWebSocket dead(server.port());
  TestWebSocket alive(server.port());
  ASSERT_TRUE(dead.isOpen() && alive.isOpen());
  dead.stopAnsweringPings();
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (server.counts().clientsNow == 2 && std::chrono::steady_clock::now() < end) {
    alive.receive(std::chrono::milliseconds(100));  // which answers pings
    dead.receive(std::chrono::milliseconds(1));
  }
  EXPECT_EQ(server.counts().clientsNow, 1u);
  ASSERT_TRUE(alive.sendText(lookText(1)));
  EXPECT_TRUE(awaitImage(alive));
}

TEST(VanishingClients, ASlowLinkIsSimulated) {
  RemoteServerSetup setup = fakeSetup();
  setup.link = {.bytesPerSecond = 400'000, .delayMilliseconds = 50};
  const RemoteServer server(std::move(setup));
  TestWebSocket client(server.port());
  ASSERT_TRUE(client.sendText(lookText(1)));
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_TRUE(awaitImage(client));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  EXPECT_GE(seconds, 120'000 / 400'000.0 + 0.05) << "120 KB at 400 KB/s, and the delay";
}

/// Four at once, each asking again and again, whose images take as long as each other's.
TEST(VanishingClients, FourClientsAreServedAlike) {
  RemoteServerSetup setup = fakeSetup();
  setup.draw = [](const RemoteRequest& request, uint32_t id, const std::function<bool()>&) {
    const auto begin = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - begin < std::chrono::milliseconds(3)) {
    }
    return fakeImage(request, id, 50'000, 1000);
  };
  setup.limits.looksPerSecond = 1000;
  const RemoteServer server(std::move(setup));
  std::vector<std::atomic<int>> images(4);
  std::vector<std::thread> clients;
  std::atomic<bool> isOver = false;
  for (auto& count : images) {
    clients.emplace_back([&] {
      TestWebSocket client(server.port());
      for (uint32_t sequence = 1; !isOver; ++sequence) {
        client.sendText(lookText(sequence));
        if (!awaitImage(client)) {
          return;
        }
        ++count;
      }
    });
  }
  EXPECT_TRUE(eventually([&] { return std::ranges::all_of(images, [](const auto& count) { return count >= 20; }); }));
  isOver = true;
  for (std::thread& client : clients) {
    client.join();
  }
  const auto [least, most] = std::ranges::minmax_element(images, {}, [](const auto& count) { return count.load(); });
  // Each waits for its own thread between images, so shares are equal only roughly: drawings, not threads, are shared.
  EXPECT_LE(most->load(), 2 * least->load());
}

}  // namespace
}  // namespace ocelli::test
