#include "display_driver/emulator/emulation_log.h"

namespace ocelli {

void EmulationLog::refreshEnded(const ShownRefresh& refresh, const Volume& volume) {
  {
    const std::lock_guard lock(mutex_);
    ++counts_.refreshes;
    bool lit = false;
    for (const ShownRefresh::Part& part : refresh.parts) {
      lit = lit || part.frame != 0;
      counts_.framesShown += part.frame != 0 && part.frame != lastShown_ ? 1 : 0;
      lastShown_ = part.frame;
    }
    counts_.litRefreshes += lit ? 1 : 0;
    counts_.tornRefreshes += refresh.parts.size() > 1 ? 1 : 0;
  }
  if (next_ != nullptr) {
    next_->refreshEnded(refresh, volume);
  }
}

void EmulationLog::frameArrived(uint32_t /*session*/, uint32_t /*frame*/, const Volume& /*volume*/) {
  const std::lock_guard lock(mutex_);
  ++counts_.framesArrived;
}

EmulationCounts EmulationLog::counts() const {
  const std::lock_guard lock(mutex_);
  return counts_;
}

}  // namespace ocelli
