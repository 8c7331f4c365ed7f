// `ocelli feeds` in `ocelli`: it becomes the program that does the work, with the same command line. Exit code, signals
// and terminal are that program's.
#include <cerrno>
#include <cstring>

#include "cli/feeds_command.h"
#include "cli/feeds_program.h"
#include "oc_core/base/error.h"

namespace ocelli {

const OwnProgram& feedsProgram() {
  static constexpr OwnProgram kProgram{
      .name = "ocelli-feeds",
      .installed = OCELLI_FEEDS_PROGRAM_INSTALLED,
      .variable = "OCELLI_FEEDS_PROGRAM",
      .does = "reads feeds with OpenCV and FFmpeg's libraries",
      .ifMissing =
          "install the package ocelli-feeds, or those that docs/install.md lists for OCELLI_WITH_FEEDS and build "
          "Ocelli with OCELLI_WITH_FEEDS=ON, or let the environment variable OCELLI_FEEDS_PROGRAM name the program"};
  return kProgram;
}

void addFeedsCommand(CLI::App& program, const CommandContext& context) {
  const auto start = [](const auto& /*choice*/, const CommandContext& /*context*/) {
    const std::filesystem::path found = findOwnProgram(feedsProgram());
    becomeProgram(found, ownCommandLine());
    throw WorkError(std::string("this program cannot be started (") + std::strerror(errno) + ")", found.string(),
                    "install Ocelli whole, so that all its programs are for this machine");
  };
  addFeedsCommands(program, context,
                   {.run = start,
                    .simulate = start,
                    .evaluate = start,
                    .panes = start,
                    .sheet = start,
                    .lens = start,
                    .pose = start,
                    .check = start,
                    .faces = start,
                    .edit = start});
}

}  // namespace ocelli
