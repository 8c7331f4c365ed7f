// Copies of volumes that reuse the memory of copies that nobody needs any more: fresh memory for a volume of the
// reference display costs more time than the copying.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "display_sim/frames/volume.h"

namespace ocelli {

/// May be used from any thread; copies may outlive it.
class VolumePool {
 public:
  VolumePool();
  std::shared_ptr<const Volume> copyOf(const Volume& volume);

 private:
  struct State {
    std::mutex mutex;
    std::vector<std::unique_ptr<Volume>> unused;
  };
  std::shared_ptr<State> state_;
};

}  // namespace ocelli
