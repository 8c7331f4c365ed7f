// A device of one's own: registered under a name, opened by it, and shown a volume.
#include <cstdio>
#include <cstdlib>

#include "display_sim/slicing/slicer.h"
#include "oc_core/base/error.h"
#include "oc_core/worlds/scene_source.h"
#include "text_device.h"

using namespace ocelli;

namespace {

bool run() {
  registerDevice(textDevice());
  const std::unique_ptr<Device> device = openDevice("text:72");
  const auto volume = std::make_shared<const Volume>(slice(loadScene("builtin:teapot"), device->profile()));

  const auto fence = device->submit(volume);
  device->present(fence->number(), {});
  const FrameState state = fence->wait(FrameStage::kShown, std::chrono::seconds(10));
  device->close();
  std::printf("%zu voxels are lit\n", volume->litVoxels());
  return state.stage == FrameStage::kShown;
}

}  // namespace

int main() {
  try {
    return run() ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch (const Error& error) {
    std::fprintf(stderr, "add_a_device: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
