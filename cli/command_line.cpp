#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <sstream>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/program.h"
#include "cli/started_ranks.h"
#include "oc_core/base/error.h"
#include "oc_core/ranks/mpi_launch.h"

namespace ocelli {
namespace {

constexpr int kWorkFailed = 1;
constexpr int kInputWrong = 2;

// A closed standard stream would hand its number to the next file that is opened, and our messages would end up in
// there.
void openStandardStreams() {
  int descriptor = open("/dev/null", O_RDWR);
  while (descriptor >= 0 && descriptor <= STDERR_FILENO) {
    descriptor = open("/dev/null", O_RDWR);
  }
  if (descriptor >= 0) {
    close(descriptor);
  }
}

int fail(const CommandContext& context, int code, const std::string& message) {
  context.clearProgress();
  const std::string rank = beforeFailureOfRank();
  std::fprintf(stderr, "ocelli: error: %s%s\n", rank.c_str(), message.c_str());
  std::fflush(stdout);  // a job that is ended prints nothing any more
  context.abandon(code);
  return code;
}

// The innermost command that the user named: its --help is the one to point at.
std::string namedCommand(const CLI::App& program) {
  std::string name = program.get_name();
  for (const CLI::App* command = &program; !command->get_subcommands().empty();) {
    command = command->get_subcommands().front();
    name += " " + command->get_name();
  }
  return name;
}

/// What `ocelli` alone says: a command is missing, and what to begin with.
constexpr const char* kFirstSteps = R"(no command was given
  try: ocelli --help

Ocelli: non-pinhole cameras, from a scene to a volumetric display. To begin with:
  ocelli demo                                          the whole way, and a page that shows it
  ocelli scene list                                    scenes that need no file
  ocelli render builtin:statues --camera ddoc -o statues.png
                                                       an image by an occlusion camera
  ocelli explore builtin:maze                          walk around corners, in a window
  ocelli evaluate builtin:statues --cameras di,ddoc    what cameras miss, in figures
  ocelli doctor                                        what works on this machine

`ocelli --help` lists all commands, `ocelli COMMAND --help` the options of one, with examples.)";

int runCommand(int argumentCount, char** arguments, const AddCommands& addCommands) {
  const CommandContext context;
  CLI::App program("Ocelli: non-pinhole cameras, from a scene to a volumetric display.", "ocelli");
  program.set_version_flag("--version", "ocelli " OCELLI_VERSION);
  program.require_subcommand(1);
  program.option_defaults()->always_capture_default();
  program.footer("`ocelli COMMAND --help` shows the options of a command, with examples.");
  context.addCommonOptions(program);
  addCommands(program, context);
  try {
    if (argumentCount < 2) {
      return fail(context, kInputWrong, kFirstSteps);
    }
    program.parse(argumentCount, arguments);
    context.run();
    flushStandardOutput();
    return 0;
  } catch (const CLI::Success& help) {
    if (const auto launch = mpiLaunch(); launch && launch->rank > 0) {
      return 0;
    }
    std::ostringstream text;
    program.exit(help, text, text);
    context.print(text.str());
    flushStandardOutput();
    return 0;
  } catch (const CLI::ParseError& error) {
    // CLI11 would only say that a command is missing.
    const std::vector<std::string> rest = program.remaining();
    if (program.get_subcommands().empty() && !rest.empty()) {
      const std::string kind = rest.front().starts_with('-') ? "option" : "command";
      return fail(context, kInputWrong, "there is no " + kind + " \"" + rest.front() + "\"\n  try: ocelli --help");
    }
    return fail(context, kInputWrong, std::string(error.what()) + "\n  try: " + namedCommand(program) + " --help");
  } catch (const ExitCode& exit) {
    flushStandardOutput();
    return exit.code;
  } catch (const InputError& error) {
    return fail(context, kInputWrong, error.what());
  } catch (const std::bad_alloc&) {
    return fail(context, kWorkFailed, "out of memory\n  try: smaller input, or close other programs");
  } catch (const std::exception& error) {
    return fail(context, kWorkFailed, error.what());
  } catch (...) {
    return fail(context, kWorkFailed, "something that is no C++ exception was thrown\n  try: report this");
  }
}

}  // namespace

int runCommandLine(int argumentCount, char** arguments, const AddCommands& addCommands) {
  openStandardStreams();
  std::signal(SIGPIPE, SIG_IGN);
  removeUnfinishedOutputsOnSignals();
  endOnLostFiles(kWorkFailed);
  try {
    return runCommand(argumentCount, arguments, addCommands);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ocelli: error: %s\n", error.what());
    return kWorkFailed;
  }
}

}  // namespace ocelli
