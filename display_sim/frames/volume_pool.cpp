#include "display_sim/frames/volume_pool.h"

#include <algorithm>

#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

/// Slices in one piece.
constexpr size_t kGrain = 16;

}  // namespace

VolumePool::VolumePool() : state_(std::make_shared<State>()) {}

std::shared_ptr<Volume> VolumePool::take(const DisplayProfile& profile) {
  std::unique_ptr<Volume> volume;
  {
    const std::lock_guard lock(state_->mutex);
    if (!state_->unused.empty()) {
      volume = std::move(state_->unused.back());
      state_->unused.pop_back();
    }
  }
  if (volume == nullptr || volume->profile() != profile) {
    volume = std::make_unique<Volume>(profile);
  }
  const auto giveBack = [state = state_](Volume* used) {
    std::unique_ptr<Volume> owned(used);
    const std::lock_guard lock(state->mutex);
    state->unused.push_back(std::move(owned));
  };
  return {volume.release(), giveBack};
}

std::shared_ptr<const Volume> VolumePool::copyOf(const Volume& volume) {
  const std::shared_ptr<Volume> copy = take(volume.profile());
  parallelFor(static_cast<size_t>(volume.slices()), kGrain, [&](size_t from, size_t to) {
    for (size_t i = from; i < to; ++i) {
      std::ranges::copy(volume.slice(static_cast<int>(i)), copy->slice(static_cast<int>(i)).begin());
    }
  });
  return copy;
}

}  // namespace ocelli
