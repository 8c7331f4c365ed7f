#include "cli/interrupt.h"

#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <ctime>

#include "oc_core/base/error.h"
#include "oc_core/base/mapped_file.h"
#include "oc_core/base/unfinished_output.h"

namespace ocelli {
namespace {

// A signal handler can reach nothing but a global.
volatile std::sig_atomic_t noted = 0;
volatile int64_t notedMilliseconds = 0;
volatile std::sig_atomic_t exitCodeOnLostFiles = 1;

/// May be called in a signal handler.
int64_t milliseconds() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return int64_t{now.tv_sec} * 1000 + now.tv_nsec / 1'000'000;
}

void end(int signal) {
  removeUnfinishedOutputs();
  std::signal(signal, SIG_DFL);
  // It waits until this handler returns, and ends the program then.
  std::raise(signal);
}

void noteOrEnd(int signal) {
  // Shells and `timeout` send one to the program and to its group: twice at the same time, but meant once.
  constexpr int64_t kSameMilliseconds = 200;
  if (noted == 0) {
    notedMilliseconds = milliseconds();
    noted = 1;
  } else if (signal != SIGHUP && milliseconds() - notedMilliseconds > kSameMilliseconds) {
    end(signal);
  }
}

/// May be called in a signal handler.
void say(const char* text) {
  // Nobody is left who could be told of a failure.
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text, std::strlen(text));
}

void endOnLostFile(int signal, siginfo_t* info, void*) {
  const char* const path = mappedFileAt(info->si_addr);
  if (path == nullptr) {
    end(signal);
    return;
  }
  removeUnfinishedOutputs();
  if (isatty(STDERR_FILENO) == 1) {
    say("\r\033[K");
  }
  say("ocelli: error: ");
  say(path);
  say(": this file became shorter, or its disk failed, while it was read\n"
      "  try: the same command again; write files anew under another name and rename them\n");
  _exit(exitCodeOnLostFiles);
}

struct sigaction actionOf(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  // One at a time.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    sigaddset(&action.sa_mask, signal);
  }
  return action;
}

void install(int signal, const struct sigaction& action, struct sigaction& old) {
  sigaction(signal, &action, &old);
  if (old.sa_handler == SIG_IGN) {
    sigaction(signal, &old, nullptr);
  }
}

}  // namespace

void removeUnfinishedOutputsOnSignals() {
  const struct sigaction action = actionOf(end);
  struct sigaction old {};
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    install(signal, action, old);
  }
}

void endOnLostFiles(int exitCode) {
  exitCodeOnLostFiles = exitCode;
  struct sigaction action {};
  action.sa_sigaction = endOnLostFile;
  action.sa_flags = SA_SIGINFO;
  sigaction(SIGBUS, &action, nullptr);
}

InterruptGuard::InterruptGuard() {
  noted = 0;
  const struct sigaction action = actionOf(noteOrEnd);
  install(SIGINT, action, oldInterrupt_);
  install(SIGTERM, action, oldTerminate_);
  // A terminal that goes sends it more than once: from the system, and from the shell.
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
