// Ctrl-C as something that long work can ask about, so that it ends with what is done written.
#pragma once

#include <csignal>

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

}  // namespace ocelli
