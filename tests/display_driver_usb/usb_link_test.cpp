// What links over USB report when something is in the way.
#include <gmock/gmock.h>

#include <atomic>
#include <thread>

#include "display_driver/usb/usb_port.h"
#include "display_driver/wire/wire_format.h"
#include "tests/display_driver_usb/usb_bench.h"

namespace ocelli {
namespace {

using wire::LinkError;
using wire::LinkStatus;

using UsbLinkTest = UsbTest;

std::vector<LinkStatus> statusesOf(const std::vector<Listener::Sent>& sent) {
  std::vector<LinkStatus> statuses;
  for (const Listener::Sent& one : sent) {
    statuses.push_back(one.status);
  }
  return statuses;
}

std::vector<size_t> tagsOf(const std::vector<Listener::Sent>& sent) {
  std::vector<size_t> tags;
  for (const Listener::Sent& one : sent) {
    tags.push_back(one.tag);
  }
  return tags;
}

std::vector<LinkStatus> all(size_t count, LinkStatus status) {
  return std::vector<LinkStatus>(count, status);
}

/// So slow that a transfer takes seconds.
EmulatedUsbDisplay crawlingDisplay() {
  EmulatedUsbDisplay made = UsbTest::display();
  made.device.bytesPerSecond = 50e3;
  return made;
}

EmulatedUsbDisplay faultyDisplay(const Fault& fault) {
  EmulatedUsbDisplay made = UsbTest::display();
  made.device.faults.faults = {fault};
  return made;
}

void arm(wire::Link& link) {
  link.controlOut(static_cast<uint8_t>(wire::Request::kArm), 1, toBytes(wire::Arm{.session = 7}));
}

/// An open link with eight transfers under way.
struct BusyLink {
  explicit BusyLink(UsbPort& port) : link(port.open()) {
    link->start(listener.functions());
    for (size_t tag = 0; tag < kSends; ++tag) {
      EXPECT_TRUE(link->send(tag, kNoise));
    }
  }

  static constexpr size_t kSends = 8;
  Listener listener;
  std::unique_ptr<wire::Link> link;
};

TEST_F(UsbLinkTest, cancelsWhatIsUnderWay) {
  UsbEmulator emulator({crawlingDisplay()});
  UsbPort port({});
  BusyLink busy(port);
  busy.link->cancelAll();
  const std::vector<Listener::Sent> sent = busy.listener.waitForSent(BusyLink::kSends);
  EXPECT_EQ(statusesOf(sent), all(BusyLink::kSends, LinkStatus::kCancelled));
  EXPECT_THAT(tagsOf(sent), testing::ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
  EXPECT_EQ(busy.link->controlIn(static_cast<uint8_t>(wire::Request::kIdentify), 0, wire::kIdentityBytes).size(),
            wire::kIdentityBytes);
  EXPECT_TRUE(busy.link->send(8, std::span(kNoise).first(512)));
  EXPECT_EQ(busy.listener.waitForSent(9).back(), (Listener::Sent{8, LinkStatus::kDone, 512}));
}

TEST_F(UsbLinkTest, closesWithTransfersUnderWay) {
  UsbEmulator emulator({crawlingDisplay()});
  UsbPort port({});
  BusyLink busy(port);
  busy.link->close();
  EXPECT_EQ(statusesOf(busy.listener.waitForSent(BusyLink::kSends)), all(BusyLink::kSends, LinkStatus::kCancelled));
  EXPECT_EQ(usbTransfersAlive(), 0u);
  EXPECT_FALSE(busy.link->send(9, kNoise));
  EXPECT_THROW(busy.link->controlIn(static_cast<uint8_t>(wire::Request::kIdentify), 0, 64), LinkError);
}

TEST_F(UsbLinkTest, aListenerMaySendWhileOthersCancel) {
  UsbEmulator emulator({crawlingDisplay()});
  UsbPort port({});
  const auto link = port.open();
  std::atomic<size_t> sent = 0;
  wire::LinkListener listener;
  listener.sent = [&](size_t tag, LinkStatus, size_t) {
    if (++sent <= 40) {
      link->send(tag + 8, kNoise);
    }
  };
  link->start(listener);
  for (size_t tag = 0; tag < 8; ++tag) {
    ASSERT_TRUE(link->send(tag, kNoise));
  }
  for (int i = 0; i < 4; ++i) {
    link->cancelAll();
  }
  link->close();
  EXPECT_GE(sent, 32u);
}

TEST_F(UsbLinkTest, closesWhileOthersAsk) {
  UsbEmulator emulator({display()});
  UsbPort port({});
  for (int i = 0; i < 10; ++i) {
    const auto link = port.open();
    std::atomic<int> answers = 0;
    std::vector<std::thread> askers;
    for (int asker = 0; asker < 3; ++asker) {
      askers.emplace_back([&] {
        try {
          for (;;) {
            link->controlIn(static_cast<uint8_t>(wire::Request::kIdentify), 0, wire::kIdentityBytes);
            ++answers;
          }
        } catch (const LinkError& error) {
          EXPECT_EQ(error.status(), LinkStatus::kCancelled) << error.what();
        }
      });
    }
    EXPECT_TRUE(becomesTrue([&] { return answers > i; }));
    link->close();
    for (std::thread& asker : askers) {
      asker.join();
    }
  }
}

TEST_F(UsbLinkTest, stallsUntilCleared) {
  UsbEmulator emulator({faultyDisplay({.kind = FaultKind::kStall, .afterBytes = 300000})});
  UsbPort port({});
  BusyLink busy(port);
  const std::vector<Listener::Sent> sent = busy.listener.waitForSent(BusyLink::kSends);
  EXPECT_EQ(sent[0], (Listener::Sent{0, LinkStatus::kDone, kNoise.size()}));
  EXPECT_EQ(sent[1], (Listener::Sent{1, LinkStatus::kStalled, 300000 - kNoise.size()}));
  for (size_t i = 2; i < sent.size(); ++i) {
    EXPECT_EQ(sent[i], (Listener::Sent{i, LinkStatus::kStalled, 0}));
  }
  ASSERT_TRUE(busy.link->send(8, kNoise));
  EXPECT_EQ(busy.listener.waitForSent(9).back().status, LinkStatus::kStalled);
  busy.link->clearStall();
  ASSERT_TRUE(busy.link->send(9, kNoise));
  EXPECT_EQ(busy.listener.waitForSent(10).back(), (Listener::Sent{9, LinkStatus::kDone, kNoise.size()}));
}

TEST_F(UsbLinkTest, tellsOfShortWrites) {
  UsbEmulator emulator({faultyDisplay({.kind = FaultKind::kShortWrite, .afterBytes = 300000})});
  UsbPort port({});
  BusyLink busy(port);
  const std::vector<Listener::Sent> sent = busy.listener.waitForSent(BusyLink::kSends);
  EXPECT_EQ(sent[1], (Listener::Sent{1, LinkStatus::kShort, 300000 - kNoise.size()}));
  EXPECT_EQ(sent[2], (Listener::Sent{2, LinkStatus::kDone, kNoise.size()}));
}

TEST_F(UsbLinkTest, givesUpWhatDoesNotMove) {
  UsbEmulator emulator(
      {faultyDisplay({.kind = FaultKind::kFullBuffers, .afterBytes = 300000, .duration = 60'000'000})});
  UsbPort port({.sendTimeout = 200ms});
  BusyLink busy(port);
  const std::vector<Listener::Sent> sent = busy.listener.waitForSent(BusyLink::kSends);
  EXPECT_EQ(sent[0].status, LinkStatus::kDone);
  EXPECT_EQ(sent[1], (Listener::Sent{1, LinkStatus::kTimedOut, 300000 - kNoise.size()}));
  for (size_t i = 2; i < sent.size(); ++i) {
    EXPECT_EQ(sent[i], (Listener::Sent{i, LinkStatus::kTimedOut, 0}));
  }
}

TEST_F(UsbLinkTest, aSlowDeviceIsNoTimeOut) {
  EmulatedUsbDisplay slow = display();
  slow.device.bytesPerSecond = 4e6;  // a transfer in 66 ms, all of them in 520 ms
  UsbEmulator emulator({slow});
  UsbPort port({.sendTimeout = 400ms});
  BusyLink busy(port);
  EXPECT_EQ(statusesOf(busy.listener.waitForSent(BusyLink::kSends)), all(BusyLink::kSends, LinkStatus::kDone));
}

TEST_F(UsbLinkTest, unpluggedWithTransfersUnderWay) {
  UsbEmulator emulator({crawlingDisplay()});
  UsbPort port({});
  BusyLink busy(port);
  emulator.unplug(0);
  EXPECT_EQ(statusesOf(busy.listener.waitForSent(BusyLink::kSends)), all(BusyLink::kSends, LinkStatus::kGone));
  EXPECT_EQ(busy.listener.waitForLost(), all(1, LinkStatus::kGone));
  EXPECT_FALSE(busy.link->send(9, kNoise));
  EXPECT_THROW(busy.link->controlIn(static_cast<uint8_t>(wire::Request::kIdentify), 0, 64), LinkError);
  EXPECT_TRUE(becomesTrue([&] { return listUsbDisplays().empty(); }));
}

TEST_F(UsbLinkTest, unpluggedAndPluggedInAgain) {
  UsbEmulator emulator({display()});
  UsbPort port({});
  for (int i = 0; i < 3; ++i) {
    {
      BusyLink busy(port);
      emulator.unplug(0);
      EXPECT_EQ(busy.listener.waitForLost(), all(1, LinkStatus::kGone));
    }
    try {
      port.open();
      ADD_FAILURE() << "there is none";
    } catch (const LinkError& error) {
      EXPECT_EQ(error.status(), LinkStatus::kGone);
    }
    std::thread plugger([&] {
      std::this_thread::sleep_for(20ms);
      emulator.plugIn(0);
    });
    const auto begin = std::chrono::steady_clock::now();
    port.waitForArrival(kLong);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, kLong) << "nobody told of the arrival";
    plugger.join();
    EXPECT_TRUE(becomesTrue([&] {
      try {
        port.open();
        return true;
      } catch (const LinkError&) {
        return false;
      }
    }));
  }
}

TEST_F(UsbLinkTest, wakeEndsTheWaitForAnArrival) {
  UsbEmulator emulator({display()});
  UsbPort port({.serial = "another one"});
  EXPECT_THROW(port.open(), LinkError);
  port.wake();
  const auto begin = std::chrono::steady_clock::now();
  port.waitForArrival(kLong);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, kLong);
}

TEST_F(UsbLinkTest, waitsWhereTheSystemTakesNoMore) {
  EmulatedUsbDisplay display = UsbTest::display();
  display.maxBytesUnderWay = 2 * kNoise.size() + 65536;
  display.device.bytesPerSecond = 40e6;
  UsbEmulator emulator({display});
  UsbPort port({});
  BusyLink busy(port);
  const std::vector<Listener::Sent> sent = busy.listener.waitForSent(BusyLink::kSends);
  EXPECT_EQ(statusesOf(sent), all(BusyLink::kSends, LinkStatus::kDone));
  EXPECT_THAT(tagsOf(sent), testing::ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
}

TEST_F(UsbLinkTest, aDisplayThatWasResetIsOpenedAnew) {
  UsbEmulator emulator({crawlingDisplay()});
  UsbPort port({});
  {
    BusyLink busy(port);
    busy.link->resetDevice();
    EXPECT_EQ(statusesOf(busy.listener.waitForSent(BusyLink::kSends)), all(BusyLink::kSends, LinkStatus::kCancelled));
    EXPECT_FALSE(busy.link->send(9, kNoise));
  }
  EXPECT_EQ(port.open()->description().serial, "EMULATED");
}

TEST_F(UsbLinkTest, resetsWhileTheDeviceWorks) {
  UsbEmulator emulator({display()});
  UsbPort port({});
  for (int i = 0; i < 30; ++i) {
    const auto link = port.open();
    Listener listener;
    link->start(listener.functions());
    std::thread asker([&] {
      try {
        for (;;) {
          link->controlIn(static_cast<uint8_t>(wire::Request::kIdentify), 0, wire::kIdentityBytes);
        }
      } catch (const LinkError&) {
      }
    });
    EXPECT_TRUE(link->send(0, kNoise));
    listener.waitForSent(1);
    link->resetDevice();
    EXPECT_EQ(listener.waitForLost().size(), 1u);
    asker.join();
    link->close();
    EXPECT_EQ(usbTransfersAlive(), 0u);
  }
}

// Sixteen events fill a packet; no short packet follows it.
TEST_F(UsbLinkTest, fullPacketsOfEventsArrive) {
  UsbEmulator emulator({display()});
  UsbPort port({});
  const auto link = port.open();
  arm(*link);
  emulator.use(0, [](EmulatedDevice& device, DeviceMicroseconds now) {
    for (uint32_t i = 0; i < 16; ++i) {
      const wire::MessageHeader unknown{.type = static_cast<wire::MessageType>(99), .session = 7, .sequence = i};
      device.takeBulk(toBytes(unknown), now);
    }
  });
  Listener listener;
  link->start(listener.functions());
  EXPECT_EQ(listener.waitForReceived(512).size(), 512u);
}

TEST_F(UsbLinkTest, aHaltOfTheEventsEndsWhenTheDisplayIsOpened) {
  UsbEmulator emulator({display()});
  UsbPort port({});
  const auto link = port.open();
  Listener listener;
  link->start(listener.functions());
  emulator.haltEvents(0);
  EXPECT_EQ(listener.waitForLost(), all(1, LinkStatus::kStalled));
  link->close();
  const auto next = port.open();
  Listener second;
  next->start(second.functions());
  arm(*next);
  ASSERT_TRUE(next->send(0, kNoise));
  EXPECT_GE(second.waitForReceived(wire::kEventBytes).size(), wire::kEventBytes);
}

}  // namespace
}  // namespace ocelli
