// Counts what happens to an emulated display, for those who tell of it afterwards.
#pragma once

#include <cstdint>
#include <mutex>

#include "display_driver/firmware/refresh_sink.h"

namespace ocelli {

struct EmulationCounts {
  uint64_t framesArrived = 0;  ///< and were acknowledged
  uint64_t refreshes = 0;
  uint64_t litRefreshes = 0;   ///< that showed a frame
  uint64_t tornRefreshes = 0;  ///< that showed more than one
  uint64_t framesShown = 0;    ///< different ones
};

/// Passes on what it hears.
class EmulationLog final : public RefreshSink, public ArrivalSink {
 public:
  /// `next` hears of refreshes, too. nullptr: nobody does.
  explicit EmulationLog(RefreshSink* next = nullptr) : next_(next) {}

  void refreshEnded(const ShownRefresh& refresh, const Volume& volume) override;
  void frameArrived(uint32_t session, uint32_t frame, const Volume& volume) override;

  EmulationCounts counts() const;

 private:
  RefreshSink* next_;
  mutable std::mutex mutex_;
  EmulationCounts counts_;
  uint32_t lastShown_ = 0;
};

}  // namespace ocelli
