// The commands of `ocelli feeds` in a build without OpenCV and FFmpeg's libraries: they are there, and say so.
#include <CLI/CLI.hpp>

#include "cli/feeds_command.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

void addMissing(CLI::App& feeds, const CommandContext& context, const std::string& name, const std::string& help) {
  CLI::App& command = *feeds.add_subcommand(name, help);
  command.allow_extras();
  context.finish(command, "  ocelli feeds " + name + " --help", [name] {
    throw InputError("this ocelli was built without graph cameras from video (OCELLI_WITH_FEEDS=OFF)", "feeds " + name,
                     "install OpenCV and FFmpeg's libraries (docs/install.md lists the packages) and build it with "
                     "-DOCELLI_WITH_FEEDS=ON");
  });
}

}  // namespace

void addFeedsCalibrateCommand(CLI::App& feeds, const CommandContext& context) {
  addMissing(feeds, context, "calibrate", "Find lenses and poses of cameras (not in this build)");
}

void addFeedsRunCommand(CLI::App& feeds, const CommandContext& context) {
  addMissing(feeds, context, "run", "Compose the image of a graph camera from its feeds (not in this build)");
}

void addFeedsSimulateCommand(CLI::App& feeds, const CommandContext& context) {
  addMissing(feeds, context, "simulate", "Make feeds of a scene with walkers (not in this build)");
}

void addFeedsEvaluateCommand(CLI::App& feeds, const CommandContext& context) {
  addMissing(feeds, context, "evaluate", "Compare the image with the truth (not in this build)");
}

}  // namespace ocelli
