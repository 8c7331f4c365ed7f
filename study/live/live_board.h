// The newest status of a session, between the thread that draws and those who ask for it. Neither waits for the other:
// both hold the lock for as long as it takes to copy a pointer.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

#include "study/live/live_status.h"

namespace ocelli {

class LiveBoard {
 public:
  void post(LiveStatus status);
  /// jsonText() of the newest status; before the first one {"state": "not begun"}.
  std::string json() const;

 private:
  struct Posted {
    LiveStatus status;
    int64_t nanoseconds = 0;  ///< of the steady clock
  };
  mutable std::mutex mutex_;
  std::shared_ptr<const Posted> newest_{};  ///< guarded
};

}  // namespace ocelli
