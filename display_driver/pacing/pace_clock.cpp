#include "display_driver/pacing/pace_clock.h"

#include <thread>

namespace ocelli {
namespace {

class RealClock final : public PaceClock {
 public:
  HostTime now() override { return std::chrono::steady_clock::now(); }
  void waitUntil(HostTime time) override { std::this_thread::sleep_until(time); }
};

}  // namespace

PaceClock& realClock() {
  static RealClock clock;
  return clock;
}

}  // namespace ocelli
