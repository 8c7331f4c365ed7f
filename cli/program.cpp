#include "cli/program.h"

#include "cli/command.h"

namespace ocelli {
namespace {

// One line a command, in the order of `ocelli --help`.
void addCommands(CLI::App& program, const CommandContext& context) {
  addDemoCommand(program, context);
  addSceneCommand(program, context);
  addRenderCommand(program, context);
  addCameraCommand(program, context);
  addOcriCommand(program, context);
  addResampleCommand(program, context);
  addSeaCommand(program, context);
  addRemoteCommand(program, context);
  addQuiltCommand(program, context);
  addSliceCommand(program, context);
  addObserveCommand(program, context);
  addVolumeCommand(program, context);
  addPresentCommand(program, context);
  addDitherCommand(program, context);
  addDeviceCommand(program, context);
  addEvaluateCommand(program, context);
  addExploreCommand(program, context);
  addFeedsCommand(program, context);
  addShadeCommand(program, context);
  addSolidityCommand(program, context);
  addViewersCommand(program, context);
  addViewCommand(program, context);
  addStudyCommand(program, context);
  addAnalyseCommand(program, context);
  addPowerCommand(program, context);
  addDoctorCommand(program, context);
  addManualCommands(program, context);
}

}  // namespace

int runProgram(int argumentCount, char** arguments) {
  return runCommandLine(argumentCount, arguments, addCommands);
}

}  // namespace ocelli
