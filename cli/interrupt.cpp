#include "cli/interrupt.h"

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

// A signal handler can reach nothing but a global.
volatile std::sig_atomic_t noted = 0;

void note(int) {
  noted = 1;
}

void install(int signal, const struct sigaction& action, struct sigaction& old) {
  sigaction(signal, &action, &old);
  if (old.sa_handler == SIG_IGN) {
    sigaction(signal, &old, nullptr);
  }
}

}  // namespace

InterruptGuard::InterruptGuard() {
  noted = 0;
  struct sigaction action {};
  action.sa_handler = note;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigemptyset(&action.sa_mask);
  install(SIGINT, action, oldInterrupt_);
  install(SIGTERM, action, oldTerminate_);
  // A terminal that goes sends it more than once: from the system, and from the shell.
  action.sa_flags = SA_RESTART;
  install(SIGHUP, action, oldHangUp_);
}

InterruptGuard::~InterruptGuard() {
  sigaction(SIGINT, &oldInterrupt_, nullptr);
  sigaction(SIGTERM, &oldTerminate_, nullptr);
  sigaction(SIGHUP, &oldHangUp_, nullptr);
}

bool InterruptGuard::interrupted() {
  return noted != 0;
}

void InterruptGuard::check() {
  if (interrupted()) {
    throw Interrupted{};
  }
}

void runOrLeaveNothing(const std::string& output, const Progress& bar,
                       const std::function<void(const Progress&)>& work) {
  const InterruptGuard guard;
  try {
    work([&](std::string_view stage, double fraction) {
      InterruptGuard::check();
      report(bar, stage, fraction);
    });
  } catch (const Interrupted&) {
    throw WorkError("interrupted: nothing is written", output, "the same command again");
  }
}

}  // namespace ocelli
