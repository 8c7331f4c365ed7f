// The program `ocelli-feeds`: who starts it, and what it does.
#pragma once

#include <filesystem>

#include "cli/feeds_work.h"
#include "oc_core/base/own_program.h"

namespace ocelli {

/// `ocelli-feeds`. OCELLI_FEEDS_PROGRAM names another one.
const OwnProgram& feedsProgram();

// In ocelli-feeds alone.
void runFeedsCommand(const FeedsRunChoice& choice, const CommandContext& context);
void simulateFeedsCommand(const FeedsSimulateChoice& choice, const CommandContext& context);
void evaluateFeedsCommand(const FeedsEvaluateChoice& choice, const CommandContext& context);
void showPanesCommand(const FeedsPanesChoice& choice, const CommandContext& context);
void writeCalibrationSheet(const FeedsSheetChoice& choice, const CommandContext& context);
void calibrateLensCommand(const FeedsLensChoice& choice, const CommandContext& context);
void calibratePosesCommand(const FeedsPoseChoice& choice, const CommandContext& context);
void checkPosesCommand(const FeedsCheckChoice& choice, const CommandContext& context);
void findFacesCommand(const FeedsFacesChoice& choice, const CommandContext& context);
void editFacesCommand(const FeedsEditChoice& choice, const CommandContext& context);

}  // namespace ocelli
