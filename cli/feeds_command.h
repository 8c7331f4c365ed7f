// The commands of `ocelli feeds`, a file each; without OpenCV and FFmpeg's libraries one that says so.
#pragma once

#include "cli/command.h"

namespace ocelli {

void addFeedsCalibrateCommand(CLI::App& feeds, const CommandContext& context);
void addFeedsRunCommand(CLI::App& feeds, const CommandContext& context);
void addFeedsSimulateCommand(CLI::App& feeds, const CommandContext& context);
void addFeedsEvaluateCommand(CLI::App& feeds, const CommandContext& context);

}  // namespace ocelli
