// `ocelli feeds` and its commands, a file each: their options. `work` does what was chosen.
#pragma once

#include "cli/command.h"
#include "cli/feeds_work.h"

namespace ocelli {

void addFeedsCommands(CLI::App& program, const CommandContext& context, const FeedsWork& work);

/// `--no-hidden`, of what makes composed images.
void addHiddenOption(CLI::App& command, bool& showsHidden);

void addFeedsCalibrateCommand(CLI::App& feeds, const CommandContext& context, const FeedsWork& work);
void addFeedsFacesCommand(CLI::App& feeds, const CommandContext& context, const FeedsWorkOf<FeedsFacesChoice>& work);
void addFeedsEditCommand(CLI::App& feeds, const CommandContext& context, const FeedsWorkOf<FeedsEditChoice>& work);
void addFeedsRunCommand(CLI::App& feeds, const CommandContext& context, const FeedsWorkOf<FeedsRunChoice>& work);
void addFeedsSimulateCommand(CLI::App& feeds, const CommandContext& context,
                             const FeedsWorkOf<FeedsSimulateChoice>& work);
void addFeedsEvaluateCommand(CLI::App& feeds, const CommandContext& context,
                             const FeedsWorkOf<FeedsEvaluateChoice>& work);
void addFeedsPanesCommand(CLI::App& feeds, const CommandContext& context, const FeedsWorkOf<FeedsPanesChoice>& work);

}  // namespace ocelli
