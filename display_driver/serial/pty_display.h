// An emulated display on a pseudo-terminal: a serial device that programs open as they open a real one.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>

#include "display_driver/firmware/emulated_device.h"

namespace ocelli {

class PtyDisplay {
 public:
  /// `link` becomes a symbolic link to the terminal, as udev makes them under /dev/serial: it stays where the terminal
  /// is another one after the display was unplugged. Throws WorkError where that cannot be.
  PtyDisplay(EmulatedDeviceOptions options, std::filesystem::path link);
  ~PtyDisplay();
  PtyDisplay(const PtyDisplay&) = delete;
  PtyDisplay& operator=(const PtyDisplay&) = delete;

  const std::filesystem::path& path() const;
  /// Of the bytes that travel either way, one in so many is damaged or lost from now on; 0: none.
  void setNoise(uint32_t oneIn);
  uint64_t damagedPackets() const;
  /// Calls `use` with the device while nothing else does.
  void withDevice(const std::function<void(EmulatedDevice& device, DeviceMicroseconds now)>& use);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ocelli
