#include "display_driver/firmware/memory_bus.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <mutex>

#include "tests/display_driver_firmware/twin_displays.h"

namespace ocelli::test {
namespace {

using namespace std::chrono_literals;
using wire::LinkError;
using wire::LinkStatus;

constexpr auto kLong = 10s;

/// What a link's thread tells.
class Listener {
 public:
  struct Sent {
    size_t tag = 0;
    LinkStatus status = LinkStatus::kDone;
    size_t bytes = 0;
  };

  wire::LinkListener functions() {
    return {.sent =
                [this](size_t tag, LinkStatus status, size_t bytes) {
                  const std::lock_guard lock(mutex_);
                  sent_.push_back({tag, status, bytes});
                  news_.notify_all();
                },
            .received =
                [this](std::span<const uint8_t> bytes) {
                  const std::lock_guard lock(mutex_);
                  received_.insert(received_.end(), bytes.begin(), bytes.end());
                  news_.notify_all();
                },
            .lost =
                [this](LinkStatus status) {
                  const std::lock_guard lock(mutex_);
                  lost_.push_back(status);
                  news_.notify_all();
                }};
  }
  std::vector<Sent> sent(size_t count) {
    std::unique_lock lock(mutex_);
    news_.wait_for(lock, kLong, [&] { return sent_.size() >= count; });
    return sent_;
  }
  Bytes received(size_t bytes) {
    std::unique_lock lock(mutex_);
    news_.wait_for(lock, kLong, [&] { return received_.size() >= bytes; });
    return received_;
  }
  std::vector<LinkStatus> lost() {
    std::unique_lock lock(mutex_);
    news_.wait_for(lock, kLong, [&] { return !lost_.empty(); });
    return lost_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable news_;
  std::vector<Sent> sent_;
  Bytes received_;
  std::vector<LinkStatus> lost_;
};

EmulatedDeviceOptions display(FaultScript faults = {}) {
  return {.firmware = {.profile = tinyProfile(6)}, .faults = std::move(faults)};
}

Bytes emptyFrame(uint32_t frame, uint32_t sequence) {
  Bytes bytes = messageBytes({kFrameBegin, 0, 0, 7, sequence, frame}, frameBeginPayload(0, std::vector<bool>(6)));
  append(bytes, messageBytes({kFrameEnd, 0, 0, 7, sequence + 1, frame}, frameEndPayload(0, {})));
  return bytes;
}

TEST(MemoryBus, whatIsSentArrivesInItsOrder) {
  Listener listener;  // outlives the link
  MemoryBus bus(display());
  const auto link = bus.port()->open();
  link->controlOut(3, 1, armRecord(7));
  link->start(listener.functions());
  std::vector<Bytes> transfers;
  for (uint32_t i = 0; i < 40; ++i) {
    transfers.push_back(emptyFrame(i + 1, 2 * i));
  }
  for (size_t i = 0; i < transfers.size(); ++i) {
    EXPECT_TRUE(link->send(i, transfers[i]));
  }
  const auto sent = listener.sent(transfers.size());
  ASSERT_EQ(sent.size(), transfers.size());
  for (size_t i = 0; i < sent.size(); ++i) {
    EXPECT_EQ(sent[i].tag, i);
    EXPECT_EQ(sent[i].status, LinkStatus::kDone);
    EXPECT_EQ(sent[i].bytes, transfers[i].size());
  }
  std::vector<uint32_t> arrived;
  for (size_t events = transfers.size(); arrived.size() < transfers.size() && events < 200; ++events) {
    const Bytes bytes = listener.received(32 * events);
    arrived.clear();
    for (size_t at = 0; at + 32 <= bytes.size(); at += 32) {
      const auto event = eventOf(ByteSpan(bytes).subspan(at, 32));
      ASSERT_TRUE(event);
      if (event->type == kArrived) {
        arrived.push_back(event->frame);
      }
    }
    if (arrived.size() == transfers.size()) {
      break;
    }
  }
  ASSERT_EQ(arrived.size(), transfers.size());
  EXPECT_TRUE(std::ranges::is_sorted(arrived));
  link->close();
}

TEST(MemoryBus, requestsThatTheDisplayStallsFail) {
  MemoryBus bus(display());
  const auto link = bus.port()->open();
  EXPECT_EQ(link->controlIn(1, 0, 64).size(), 64u);
  EXPECT_THROW(link->controlIn(9, 0, 64), LinkError);
  EXPECT_THROW(link->controlOut(3, 1, {}), LinkError);
  EXPECT_EQ(link->controlIn(1, 0, 64).size(), 64u);
}

TEST(MemoryBus, oneLinkAtATime) {
  MemoryBus bus(display());
  const auto port = bus.port();
  auto link = port->open();
  EXPECT_THROW(port->open(), LinkError);
  link->close();
  link = port->open();
  EXPECT_EQ(link->controlIn(1, 0, 64).size(), 64u);
}

TEST(MemoryBus, cancelledTransfersEndBeforeCancelReturns) {
  Listener listener;  // outlives the link
  MemoryBus bus(display({{{.kind = FaultKind::kFullBuffers, .duration = 3'600'000'000}}}));
  bus.withDevice([](EmulatedDevice& device, DeviceMicroseconds now) { device.advance(now); });
  const auto link = bus.port()->open();
  link->start(listener.functions());
  const Bytes bytes(1000);
  for (size_t i = 0; i < 5; ++i) {
    EXPECT_TRUE(link->send(i, bytes));
  }
  link->cancelAll();
  const auto sent = listener.sent(5);
  ASSERT_EQ(sent.size(), 5u);
  for (size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(sent[i].tag, i);
    EXPECT_EQ(sent[i].status, LinkStatus::kCancelled);
  }
  link->close();
  EXPECT_FALSE(link->send(9, bytes));
  EXPECT_EQ(listener.sent(5).size(), 5u);
}

TEST(MemoryBus, aStallEndsTransfersUntilItIsCleared) {
  Listener listener;  // outlives the link
  MemoryBus bus(display({{{.kind = FaultKind::kStall, .afterBytes = 10}}}));
  const auto link = bus.port()->open();
  link->controlOut(3, 1, armRecord(7));
  link->start(listener.functions());
  const Bytes bytes = emptyFrame(1, 0);
  EXPECT_TRUE(link->send(0, bytes));
  EXPECT_EQ(listener.sent(1).at(0).status, LinkStatus::kStalled);
  link->clearStall();
  link->controlOut(3, 1, armRecord(7));
  EXPECT_TRUE(link->send(1, bytes));
  const auto sent = listener.sent(2);
  ASSERT_EQ(sent.size(), 2u);
  EXPECT_EQ(sent[1].status, LinkStatus::kDone);
  EXPECT_EQ(sent[1].bytes, bytes.size());
}

TEST(MemoryBus, anUnpluggedDisplayIsGoneAndItsReturnEndsTheWait) {
  Listener listener;  // outlives the link
  MemoryBus bus(display({{{.kind = FaultKind::kUnplug, .at = 50'000, .duration = 100'000}}}));
  const auto port = bus.port();
  std::unique_ptr<wire::Link> link = port->open();
  link->start(listener.functions());
  EXPECT_EQ(listener.lost(), std::vector{LinkStatus::kGone});
  EXPECT_THROW(link->controlIn(1, 0, 64), LinkError);
  link.reset();
  const auto until = std::chrono::steady_clock::now() + kLong;
  while (link == nullptr && std::chrono::steady_clock::now() < until) {
    port->waitForArrival(1000ms);
    try {
      link = port->open();
    } catch (const LinkError& error) {
      EXPECT_EQ(error.status(), LinkStatus::kGone);
    }
  }
  ASSERT_NE(link, nullptr);
  EXPECT_EQ(link->controlIn(1, 0, 64).size(), 64u);
}

TEST(MemoryBus, wakeEndsAWait) {
  MemoryBus bus(display());
  const auto port = bus.port();
  port->wake();
  const auto begin = std::chrono::steady_clock::now();
  port->waitForArrival(60s);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 30s);  // not the whole wait
}

}  // namespace
}  // namespace ocelli::test
