// Records frames until it is killed: `display_sim_svol_record_child FILE`. For svol_killed_test.cpp.
#include "display_sim/frames/svol_writer.h"
#include "tests/display_sim_observing/recorded_frames.h"

int main(int argumentCount, char** arguments) {
  if (argumentCount != 2) {
    return 2;
  }
  const std::vector<ocelli::Volume> volumes = ocelli::test::killedVolumes();
  ocelli::SvolWriter writer(arguments[1], volumes.front().profile(), {.framesPerKey = 8, .growing = true});
  for (uint32_t k = 0;; ++k) {
    writer.append(volumes[k % volumes.size()], ocelli::test::recordedTime(k));
  }
}
