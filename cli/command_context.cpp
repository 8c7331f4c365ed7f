#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "cli/command.h"
#include "cli/progress_bar.h"
#include "cli/started_ranks.h"
#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/base/output_file.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

constexpr int kMaxThreads = 1024;

// A reader that closed its end (`ocelli ... | head`) has seen what it wanted.
void checkStandardOutput(bool written) {
  if (written || errno == EPIPE) {
    return;
  }
  throw WorkError(std::string("cannot print (") + std::strerror(errno) + ")", "standard output",
                  "check where it is redirected to: is the disk full?");
}

/// Whether a file that the user named goes there.
bool namesStandardOutput(const CLI::App& command) {
  return std::ranges::any_of(command.get_options(), [](const CLI::Option* option) {
    return std::ranges::any_of(option->results(), [](const std::string& text) {
      constexpr std::string_view kFileDevice = "file:";
      return isStandardOutput(text.starts_with(kFileDevice) ? text.substr(kFileDevice.size()) : text);
    });
  });
}

}  // namespace

struct CommandContext::State {
  int threads = 0;
  bool quiet = false;
  bool fileOnStandardOutput = false;
  ProgressBar bar;
  std::function<void()> chosen;
  std::string command;
  bool divides = false;
  std::unique_ptr<Ranks> ranks;

  bool isSilent() const { return ranks && !ranks->isFirst(); }
};

CommandContext::CommandContext() : state_(std::make_shared<State>()) {}

void CommandContext::addCommonOptions(CLI::App& command) const {
  command.add_option("--threads", state_->threads, "Use at most so many threads; 0 stands for all cores")
      ->check(CLI::Range(0, kMaxThreads))
      ->type_name("N");
  command.add_flag("-q,--quiet", state_->quiet, "Print results and errors only");
}

void CommandContext::declare(CLI::App& command, const std::string& examples, std::function<void()> run,
                             bool divides) const {
  addCommonOptions(command);
  command.footer("Examples:\n" + examples);
  command.callback([state = state_, run = std::move(run), divides, &command] {
    state->fileOnStandardOutput = namesStandardOutput(command);
    state->command = command.get_name();
    state->divides = divides;
    state->chosen = run;
  });
}

void CommandContext::finish(CLI::App& command, const std::string& examples, std::function<void()> run) const {
  declare(command, examples, std::move(run), false);
}

void CommandContext::finishShared(CLI::App& command, const std::string& examples, std::function<void()> run) const {
  declare(command, examples, std::move(run), true);
}

Ranks& CommandContext::ranks() const {
  OC_CHECK(state_->ranks != nullptr, "ranks are there while a command runs");
  return *state_->ranks;
}

void CommandContext::print(std::string_view text) const {
  if (state_->isSilent()) {
    return;
  }
  clearProgress();
  std::FILE* const stream = state_->fileOnStandardOutput ? stderr : stdout;
  checkStandardOutput(std::fwrite(text.data(), 1, text.size(), stream) == text.size());
}

void CommandContext::note(std::string_view text) const {
  if (!state_->quiet && !state_->isSilent()) {
    clearProgress();
    std::fprintf(stderr, "%.*s\n", static_cast<int>(text.size()), text.data());
  }
}

Progress CommandContext::progress() const {
  if (state_->quiet || state_->isSilent() || !ProgressBar::possible()) {
    return {};
  }
  return [state = state_](std::string_view stage, double fraction) { state->bar.show(stage, fraction); };
}

void CommandContext::run() const {
  // The command may hold this context: it must not hold itself.
  if (const std::function<void()> chosen = std::exchange(state_->chosen, nullptr)) {
    setThreadCount(state_->threads);
    state_->ranks = startedRanks(state_->divides, state_->command);
    chosen();
    clearProgress();
    flushStandardOutput();
    state_->ranks.reset();
  }
}

void CommandContext::abandon(int exitCode) const {
  if (state_->ranks) {
    state_->ranks->abort(exitCode);
  }
}

void CommandContext::clearProgress() const {
  state_->bar.clear();
}

void flushStandardOutput() {
  checkStandardOutput(std::fflush(stdout) == 0);
}

}  // namespace ocelli
