// emulated_stream: an emulated display, and a client of it that streams until it is killed. For tests that kill either.
// Prints the process id of the client once it streams.
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <thread>

#include "display_driver/emulator/client_process.h"
#include "display_driver/emulator/usb_emulator.h"
#include "display_driver/usb/usb_port.h"
#include "tests/display_driver_wire/made_volumes.h"

namespace ocelli {
namespace {

[[noreturn]] void stream() {
  UsbPort port({});
  const auto link = port.open();
  const std::vector<uint8_t> bytes(size_t{1} << 18, 0x55);
  wire::LinkListener listener;
  listener.sent = [&](size_t tag, wire::LinkStatus status, size_t) {
    if (tag == 0 && status == wire::LinkStatus::kDone) {
      fmt::print("{}\n", ::getpid());
      std::fflush(stdout);
    }
    link->send(tag + 8, bytes);
  };
  link->start(listener);
  for (size_t tag = 0; tag < 8; ++tag) {
    link->send(tag, bytes);
  }
  for (;;) {
    std::this_thread::sleep_for(std::chrono::seconds(1));
  }
}

int emulate() {
  UsbEmulator::restartPreloaded();
  EmulatedUsbDisplay display;
  display.device.firmware.profile = smallProfile();
  display.device.bytesPerSecond = 4e6;
  UsbEmulator emulator({display});
  const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
  const int first = runClient({self, "client"}, emulator.environment());
  // Where a client was killed, its display is free for the next one.
  fmt::print("client ended with {}\n", first);
  std::fflush(stdout);
  return runClient({self, "client"}, emulator.environment());
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char**) {
  if (argumentCount > 1) {
    ocelli::stream();
  }
  return ocelli::emulate();
}
