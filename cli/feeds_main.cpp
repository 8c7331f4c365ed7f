// `ocelli-feeds feeds ...`: what `ocelli feeds` becomes (feeds_work.h).
#include "cli/feeds_command.h"
#include "cli/feeds_program.h"
#include "cli/program.h"

int main(int argumentCount, char** arguments) {
  using namespace ocelli;
  return runCommandLine(argumentCount, arguments, [](CLI::App& program, const CommandContext& context) {
    addFeedsCommands(program, context,
                     {.run = runFeedsCommand,
                      .simulate = simulateFeedsCommand,
                      .evaluate = evaluateFeedsCommand,
                      .panes = showPanesCommand,
                      .sheet = writeCalibrationSheet,
                      .lens = calibrateLensCommand,
                      .pose = calibratePosesCommand,
                      .check = checkPosesCommand,
                      .faces = findFacesCommand,
                      .edit = editFacesCommand});
  });
}
