// A link in memory to an emulated display in the same process, in real time: for the simulator, and for tests of what
// lies above links.
#pragma once

#include <functional>
#include <memory>

#include "display_driver/firmware/emulated_device.h"
#include "display_driver/wire/link.h"

namespace ocelli {

/// The device, and a thread that moves it on. It outlives its ports and links.
class MemoryBus {
 public:
  explicit MemoryBus(EmulatedDeviceOptions options);
  ~MemoryBus();
  MemoryBus(const MemoryBus&) = delete;
  MemoryBus& operator=(const MemoryBus&) = delete;

  /// One link at a time can be open.
  std::unique_ptr<wire::LinkPort> port();
  /// Calls `use` with the device while nothing else does.
  void withDevice(const std::function<void(EmulatedDevice& device, DeviceMicroseconds now)>& use);

  struct State;

 private:
  std::shared_ptr<State> state_;
};

}  // namespace ocelli
