// Ctrl-C as something that long work can ask about, so that it ends with what is done written.
#pragma once

#include <csignal>
#include <functional>
#include <string>

#include "oc_core/base/progress.h"

namespace ocelli {

/// While it lives, the first SIGINT or SIGTERM is noted; a second one ends the program at once, as it does without
/// this. SIGHUP, of a terminal that is closed, is noted however often it comes. At most one lives at a time. Where a
/// signal is ignored (nohup) it stays so.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  static bool interrupted();
  /// Throws Interrupted where interrupted() holds.
  static void check();

 private:
  struct sigaction oldInterrupt_ {};
  struct sigaction oldTerminate_ {};
  struct sigaction oldHangUp_ {};
};

struct Interrupted {};

/// Calls `work` with a progress that goes to `bar`, and that throws after an interrupt. `work` leaves nothing when it
/// throws; an interrupt is then a WorkError which says so of `output`.
void runOrLeaveNothing(const std::string& output, const Progress& bar,
                       const std::function<void(const Progress&)>& work);

}  // namespace ocelli
