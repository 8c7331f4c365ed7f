#include "display_driver/usb/usb_port.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <thread>

#include "display_driver/wire/wire_format.h"
#include "tests/display_driver_usb/usb_bench.h"

namespace ocelli {
namespace {

using wire::LinkError;
using wire::LinkStatus;

const size_t kTransfer = kNoise.size();

LinkStatus statusOfOpen(UsbPort& port, std::string* message = nullptr) {
  try {
    port.open();
    return LinkStatus::kDone;
  } catch (const LinkError& error) {
    if (message != nullptr) {
      *message = error.what();
    }
    return error.status();
  }
}

std::vector<uint8_t> identify(wire::Link& link) {
  return link.controlIn(static_cast<uint8_t>(wire::Request::kIdentify), 0, wire::kIdentityBytes);
}

using UsbPortTest = UsbTest;

TEST_F(UsbPortTest, listsDisplays) {
  EmulatedUsbDisplay second = display("B");
  second.speed = EmulatedSpeed::kUsb3;
  const UsbEmulator emulator({display("A"), second});
  const std::vector<UsbDisplay> displays = listUsbDisplays();
  ASSERT_EQ(displays.size(), 2u);
  EXPECT_EQ(displays[0].problem, "");
  EXPECT_EQ(displays[0].serial, "A");
  EXPECT_EQ(displays[0].name, "Ocelli emulated display");
  EXPECT_EQ(displays[0].vendor, 0x1209);
  EXPECT_EQ(displays[0].link, "USB 2, 480 Mbit/s, bus 1 port 1");
  EXPECT_EQ(displays[1].serial, "B");
  EXPECT_EQ(displays[1].link, "USB 3, 5 Gbit/s, bus 1 port 2");
}

TEST_F(UsbPortTest, answersRequests) {
  const UsbEmulator emulator({display("A")});
  UsbPort port({});
  const auto link = port.open();
  EXPECT_EQ(link->description().serial, "A");
  EXPECT_EQ(link->description().bytesPerSecond, 40e6);
  const auto identity = wire::identityFrom(identify(*link));
  ASSERT_TRUE(identity);
  EXPECT_EQ(identity->name, "Ocelli emulated display");
  const std::vector<uint8_t> profile =
      link->controlIn(static_cast<uint8_t>(wire::Request::kProfile), 0, wire::kMaxProfileBytes);
  EXPECT_EQ(profile.size(), identity->profileBytes);
  link->controlOut(static_cast<uint8_t>(wire::Request::kArm), 1, toBytes(wire::Arm{.session = 7}));
  const auto telemetry =
      wire::telemetryFrom(link->controlIn(static_cast<uint8_t>(wire::Request::kTelemetry), 0, wire::kTelemetryBytes));
  ASSERT_TRUE(telemetry);
  EXPECT_EQ(telemetry->session, 7u);
}

TEST_F(UsbPortTest, tellsOfRequestsThatTheDeviceRefuses) {
  const UsbEmulator emulator({display()});
  UsbPort port({});
  const auto link = port.open();
  try {
    link->controlIn(200, 0, 8);
    FAIL() << "there is no such request";
  } catch (const LinkError& error) {
    EXPECT_EQ(error.status(), LinkStatus::kStalled);
  }
  EXPECT_EQ(identify(*link).size(), wire::kIdentityBytes);
}

TEST_F(UsbPortTest, sendsInOrderAndHearsEvents) {
  const UsbEmulator emulator({display()});
  UsbPort port({});
  const auto link = port.open();
  Listener listener;
  link->start(listener.functions());
  link->controlOut(static_cast<uint8_t>(wire::Request::kArm), 1, toBytes(wire::Arm{.session = 7}));
  for (size_t tag = 0; tag < 8; ++tag) {
    ASSERT_TRUE(link->send(tag, kNoise));
  }
  const std::vector<Listener::Sent> sent = listener.waitForSent(8);
  ASSERT_EQ(sent.size(), 8u);
  for (size_t tag = 0; tag < 8; ++tag) {
    EXPECT_EQ(sent[tag], (Listener::Sent{tag, LinkStatus::kDone, kTransfer}));
  }
  const std::vector<uint8_t> events = listener.waitForReceived(wire::kEventBytes);
  ASSERT_GE(events.size(), wire::kEventBytes);
  const auto event = wire::eventFrom(std::span(events).first(wire::kEventBytes));
  ASSERT_TRUE(event);
  EXPECT_EQ(event->type, wire::EventType::kError);
}

TEST_F(UsbPortTest, findsADisplayByItsSerial) {
  const UsbEmulator emulator({display("A"), display("B")});
  UsbPort port({.serial = "B"});
  EXPECT_EQ(port.open()->description().serial, "B");
  UsbPort other({.serial = "C"});
  std::string message;
  EXPECT_EQ(statusOfOpen(other, &message), LinkStatus::kGone);
  EXPECT_EQ(message, "not plugged in, or not switched on");
}

TEST_F(UsbPortTest, twoAtOnce) {
  const UsbEmulator emulator({display("A"), display("B")});
  UsbPort first({});
  UsbPort second({});
  const auto one = first.open();
  const auto two = second.open();
  EXPECT_EQ(one->description().serial, "A");
  EXPECT_EQ(two->description().serial, "B");  // the first one is taken
  std::string message;
  UsbPort third({});
  EXPECT_EQ(statusOfOpen(third, &message), LinkStatus::kFailed);
  EXPECT_EQ(message, "another program uses the display at USB 2, 480 Mbit/s, bus 1 port 2");
  Listener a;
  Listener b;
  one->start(a.functions());
  two->start(b.functions());
  ASSERT_TRUE(one->send(1, kNoise));
  ASSERT_TRUE(two->send(2, kNoise));
  EXPECT_EQ(a.waitForSent(1), (std::vector<Listener::Sent>{{1, LinkStatus::kDone, kTransfer}}));
  EXPECT_EQ(b.waitForSent(1), (std::vector<Listener::Sent>{{2, LinkStatus::kDone, kTransfer}}));
}

TEST_F(UsbPortTest, aDisplayThatIsClosedCanBeOpenedAgain) {
  UsbEmulator emulator({display()});
  UsbPort port({});
  for (int i = 0; i < 3; ++i) {
    const auto link = port.open();
    Listener listener;
    link->start(listener.functions());
    ASSERT_TRUE(link->send(1, kNoise));
    link->close();
    EXPECT_FALSE(link->send(2, kNoise));
    EXPECT_EQ(usbTransfersAlive(), 0u);
  }
}

TEST_F(UsbPortTest, programsKeepWhatTheyPreload) {
  const UsbEmulator emulator({display()});
  const auto preloaded = [&] { return emulator.environment().front().second; };
  const std::string before = std::getenv("LD_PRELOAD");
  setenv("LD_PRELOAD", "libmine.so", 1);
  EXPECT_EQ(preloaded(), "libumockdev-preload.so.0:libmine.so");
  setenv("LD_PRELOAD", preloaded().c_str(), 1);
  EXPECT_EQ(preloaded(), "libumockdev-preload.so.0:libmine.so");
  unsetenv("LD_PRELOAD");
  EXPECT_EQ(preloaded(), "libumockdev-preload.so.0");
  setenv("LD_PRELOAD", before.c_str(), 1);
}

}  // namespace
}  // namespace ocelli
