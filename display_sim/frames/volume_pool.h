// Volumes that reuse the memory of those that nobody holds any more: fresh memory for a volume of the reference display
// costs more time than filling it.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "display_sim/frames/volume.h"

namespace ocelli {

/// May be used from any thread; its volumes may outlive it.
class VolumePool {
 public:
  VolumePool();

  /// To be filled: a used one has the voxels that it had.
  std::shared_ptr<Volume> take(const DisplayProfile& profile);
  std::shared_ptr<const Volume> copyOf(const Volume& volume);

 private:
  struct State {
    std::mutex mutex;
    std::vector<std::unique_ptr<Volume>> unused;
  };
  std::shared_ptr<State> state_;
};

}  // namespace ocelli
