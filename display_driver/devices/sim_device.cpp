#include "display_driver/devices/sim_device.h"

#include "display_driver/firmware/memory_bus.h"
#include "display_driver/wire/stream_device.h"

namespace ocelli {
namespace {

/// The device over a link in memory, which it owns.
class SimDevice : public Device {
 public:
  explicit SimDevice(const SimOptions& options) : bus_(options.display) {
    bus_.withDevice([&](EmulatedDevice& display, DeviceMicroseconds) { display.firmware().setSink(options.sink); });
    StreamOptions stream;
    stream.kind = "sim";
    device_ = openStreamDevice(bus_.port(), stream);
  }
  ~SimDevice() override {
    device_.reset();
    bus_.withDevice([](EmulatedDevice& display, DeviceMicroseconds) { display.firmware().setSink(nullptr); });
  }

  const DeviceInfo& info() const override { return device_->info(); }
  const DisplayProfile& profile() const override { return device_->profile(); }
  void present(FrameNumber frame, const Presentation& presentation) override { device_->present(frame, presentation); }
  Telemetry telemetry() override { return device_->telemetry(); }
  void close() override { device_->close(); }

 protected:
  std::shared_ptr<const FrameFence> submitFrame(std::shared_ptr<const Volume> volume,
                                                std::optional<std::span<const int>> changedSlices) override {
    return changedSlices ? device_->submit(std::move(volume), *changedSlices) : device_->submit(std::move(volume));
  }

 private:
  MemoryBus bus_;
  std::unique_ptr<Device> device_;
};

}  // namespace

std::unique_ptr<Device> openSimDevice(const SimOptions& options) {
  return std::make_unique<SimDevice>(options);
}

}  // namespace ocelli
