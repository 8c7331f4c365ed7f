// Volumes that go to an emulated display over an emulated USB, through everything that lies between.
#include "display_driver/usb/usb_port.h"
#include "display_driver/wire/stream_device.h"
#include "tests/display_driver_usb/fault_runner.h"
#include "tests/display_driver_usb/usb_bench.h"
#include "tests/display_driver_wire/arrival_check.h"

namespace ocelli {
namespace {

using UsbStreamTest = UsbTest;

TEST_F(UsbStreamTest, arrivesAsItWasSent) {
  EmulatedUsbDisplay shown = display();
  shown.device.firmware.profile = smallProfile(60);
  shown.device.firmware.profile.width = 256;
  shown.device.firmware.profile.height = 128;
  UsbEmulator emulator({shown});
  ArrivalCheck check;
  emulator.use(0, [&](EmulatedDevice& device, DeviceMicroseconds) { device.firmware().setArrivalSink(&check); });
  const auto device = openStreamDevice(std::make_unique<UsbPort>(UsbPortOptions()), {.kind = "usb"});
  EXPECT_EQ(device->info().serial, "EMULATED");
  EXPECT_EQ(device->info().link, "USB 2, 480 Mbit/s, bus 1 port 1");
  for (uint32_t number = 1; number <= 40; ++number) {
    const Volume volume = madeVolume(device->profile(), number, 0.1);
    check.expect(number, volume);
    const auto fence = device->submit(volume);
    device->present(number, {});
    EXPECT_EQ(fence->wait(FrameStage::kArrived, kLong).problem, "");
  }
  device->close();
  EXPECT_EQ(check.right(), 40u);
  EXPECT_EQ(check.wrong(), 0u);
}

TEST_F(UsbStreamTest, opensAndClosesWithoutLeavingAnything) {
  UsbEmulator emulator({display()});
  std::optional<Holdings> before;
  for (int i = 0; i < 200; ++i) {
    {
      UsbPort port({});
      const auto link = port.open();
      Listener listener;
      link->start(listener.functions());
      EXPECT_TRUE(link->send(1, kNoise));
    }
    before = before.value_or(holdingsOfThisProcess());
  }
  EXPECT_TRUE(becomesTrue([&] { return !holdingsOfThisProcess().exceed(*before); }));
  EXPECT_EQ(holdingsOfThisProcess().transfers, 0u);
}

}  // namespace
}  // namespace ocelli
