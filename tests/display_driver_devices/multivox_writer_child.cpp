// Shows numbered frames until it is killed: `multivox_writer_child memory|device OBJECT FIRST`. For
// multivox_killed_test.cpp. FIRST is the number of the first frame.
#include <cstdlib>
#include <string_view>
#include <thread>

#include "display_driver/devices/multivox_device.h"
#include "display_driver/devices/multivox_memory.h"
#include "tests/display_driver_devices/numbered_frames.h"

namespace ocelli {
namespace {

/// Writes over the page that is not shown most of the time, so that being killed within a write is likely.
[[noreturn]] void writeMemory(const char* object, uint32_t first) {
  constexpr int kWritesPerShow = 100;
  const VoxelGrid grid;
  MultivoxMemory memory(object, grid);
  for (uint32_t frame = first;; ++frame) {
    if (memory.look() != MultivoxMemory::Found::kNothing) {
      std::this_thread::sleep_until(memory.rested());
      bool whole = false;
      for (int i = 0; i < kWritesPerShow; ++i) {
        // Others first, so that what was written last is not yet there from the write before.
        const uint32_t number = frame + kWritesPerShow - 1 - static_cast<uint32_t>(i);
        whole = memory.write(std::vector<uint8_t>(grid.cells(), test::frameNumberOf(number)));
      }
      if (whole) {
        memory.show();
      }
    }
  }
}

[[noreturn]] void showOnDevice(const char* object, uint32_t first) {
  const DisplayProfile profile = test::numberedProfile();
  const std::unique_ptr<Device> device = openMultivox(object, profile);
  for (uint32_t frame = first;; ++frame) {
    const auto fence = device->submit(test::numberedVolume(profile, test::frameNumberOf(frame)));
    device->present(fence->number(), {});
    fence->wait(FrameStage::kArrived, std::chrono::seconds(1));
  }
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  if (argumentCount != 4) {
    return 2;
  }
  const auto first = static_cast<uint32_t>(std::atoi(arguments[3]));
  if (std::string_view(arguments[1]) == "memory") {
    ocelli::writeMemory(arguments[2], first);
  }
  ocelli::showOnDevice(arguments[2], first);
}
