// Volumes that go to an emulated display over an emulated USB, through everything that lies between.
#include <map>

#include "display_driver/stream/stream_device.h"
#include "display_driver/usb/usb_port.h"
#include "tests/display_driver_usb/usb_bench.h"

namespace ocelli {
namespace {

using UsbStreamTest = UsbTest;

TEST_F(UsbStreamTest, arrivesAsItWasSent) {
  EmulatedUsbDisplay shown = display();
  shown.device.firmware.profile = smallProfile(60);
  shown.device.firmware.profile.width = 256;
  shown.device.firmware.profile.height = 128;
  UsbEmulator emulator({shown});
  Arrivals arrivals;
  emulator.use(0, [&](EmulatedDevice& device, DeviceMicroseconds) { device.firmware().setArrivalSink(&arrivals); });
  const auto device = openStreamDevice(std::make_unique<UsbPort>(UsbPortOptions()), {.kind = "usb"});
  EXPECT_EQ(device->info().serial, "EMULATED");
  std::map<FrameNumber, Volume> submitted;
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    const Volume volume = madeVolume(device->profile(), seed, 0.1);
    const auto fence = device->submit(volume);
    submitted.emplace(fence->number(), volume);
    device->present(fence->number(), {});
    EXPECT_EQ(fence->wait(FrameStage::kArrived, kLong).problem, "");
  }
  EXPECT_EQ(device->telemetry().framesArrived, 40u);
  device->close();
  EXPECT_EQ(arrivals.differing(submitted), 0u);
  EXPECT_EQ(arrivals.count(), 40u);
}

}  // namespace
}  // namespace ocelli
