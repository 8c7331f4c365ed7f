// What signals that end a program do here: what is half written goes with it, and long work may ask whether one came,
// so that it ends with what is done written.
#pragma once

#include <csignal>
#include <functional>
#include <string>

#include "oc_core/base/progress.h"

namespace ocelli {

/// From now on SIGINT, SIGTERM and SIGHUP end the program as they do by themselves, after they have removed what lies
/// under a temporary name (oc_core/base/unfinished_output.h). Where a signal is ignored (nohup) it stays so.
void removeUnfinishedOutputsOnSignals();

/// From now on a SIGBUS because a file that is mapped (oc_core/base/mapped_file.h) became shorter or cannot be read
/// ends the program with `exitCode` and one line that names the file, after what is half written was removed. Any other
/// SIGBUS ends it as it does by itself.
void endOnLostFiles(int exitCode);

/// While it lives, the first SIGINT or SIGTERM is noted; one that comes more than 0.2 s later ends the program at once,
/// without what is half written. SIGHUP, of a terminal that is closed, is noted however often it comes. At most one
/// lives at a time. Where a signal is ignored (nohup) it stays so.
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
