// Emulated displays on an emulated USB: what a program sees that runs with umockdev's preload library and with the
// environment that the emulator names. libusb in such a program finds the displays, opens them, and sends them bytes,
// as it does real ones; faults of their scripts happen to it as they happen with real ones.
//
//   UsbEmulator emulator({{.device = options}});
//   // run a program with emulator.environment() added to its environment
//
// A thread of its own turns the displays on in real time.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "display_driver/emulator/usb_device_record.h"
#include "display_driver/firmware/emulated_device.h"
#include "oc_core/base/error.h"

namespace ocelli {

struct EmulatedUsbDisplay {
  EmulatedDeviceOptions device;
  EmulatedSpeed speed = EmulatedSpeed::kUsb2;  ///< what it says it is; how fast it is the device's options say
  size_t maxBytesUnderWay = 16 << 20;          ///< the system's limit for transfers that have been submitted
};

class UsbEmulator {
 public:
  /// One device a display, plugged in at port 1, 2, ... Sweeps what killed emulators have left. Throws WorkError.
  explicit UsbEmulator(std::vector<EmulatedUsbDisplay> displays);
  ~UsbEmulator();

  /// Whether umockdev's preload library is loaded: without it this process sees no emulated devices, and those that do
  /// not hear of what is plugged in and unplugged.
  static bool preloaded();
  /// Why that library cannot be loaded on this machine, with what to install; nullopt where it can.
  static std::optional<WorkError> preloadError();
  /// Starts this program anew, with the same arguments, so that it is. Returns where it is already, or where that is
  /// not possible; it is tried once.
  static void restartPreloaded();
  /// The same, but throws WorkError where that is not possible.
  static void requirePreloaded();
  /// Variables for the environment of programs that shall see the displays, with their values. Libraries that are
  /// preloaded already stay so, behind umockdev's.
  std::vector<std::pair<std::string, std::string>> environment() const;

  /// Calls `use` while nobody else touches the device. Not for long: nothing moves on meanwhile.
  void use(size_t display, const std::function<void(EmulatedDevice& device, DeviceMicroseconds now)>& use);

  /// By hand, besides the faults of the script.
  void unplug(size_t display);
  void plugIn(size_t display);
  /// Another program holds the display's interface, or does no longer.
  void occupy(size_t display, bool occupied);
  /// The display's endpoint for events stalls until a client clears it.
  void haltEvents(size_t display);
  /// Transfers that were submitted and have not been taken back yet.
  size_t transfersUnderWay(size_t display) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ocelli
