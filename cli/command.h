// What every command of the `ocelli` program shares: how it is declared, prints and reports progress.
//
// Recipe for a new command, four files:
//   1. cli/NAME_command.cpp: `void addNameCommand(CLI::App& program, const CommandContext& context)`. It adds a
//      subcommand, its options, and ends with context.finish(command, examples, run). `run` calls a room and prints: no
//      logic here.
//   2. cli/command.h: its declaration.
//   3. cli/program.cpp and cli/CMakeLists.txt: one line each.
//
// `run` throws InputError for what the user gave wrongly (exit code 2) and WorkError where the work failed (1);
// runProgram() prints both as "ocelli: error: ...". Any other exception is exit code 1 too.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "oc_core/base/progress.h"
#include "oc_core/ranks/ranks.h"

namespace CLI {
class App;
}

namespace ocelli {

class CommandContext {
 public:
  CommandContext();

  /// Ends the declaration of a command: adds --threads and --quiet, and shows `examples` (one command line a line)
  /// below its --help. `run` is called once after the whole command line has been read, if the user chose this command.
  void finish(CLI::App& command, const std::string& examples, std::function<void()> run) const;
  /// The same for a command that divides its work among the ranks of an MPI job (docs/many_machines.md), which all call
  /// `run`. Others refuse to run in a job of several.
  void finishShared(CLI::App& command, const std::string& examples, std::function<void()> run) const;
  /// Adds --threads and --quiet alone: for the program itself.
  void addCommonOptions(CLI::App& command) const;

  /// Those that run the command together, while it runs. All but the first print nothing and show no progress.
  Ranks& ranks() const;

  /// Prints a result to standard output, or to standard error where an output file of the command goes to standard
  /// output (-o /dev/stdout). Throws WorkError where that is full; a reader that has gone is no error.
  void print(std::string_view text) const;
  /// Prints a note on what was done ("wrote FILE ...") to standard error, unless --quiet.
  void note(std::string_view text) const;
  /// For a room's last parameter: a bar on standard error where that is a terminal, nothing otherwise or with --quiet.
  Progress progress() const;

  /// Calls the chosen command's `run`. Does nothing where none was chosen.
  void run() const;
  /// Takes the bar off the terminal, so that a message can follow.
  void clearProgress() const;
  /// Ends the other ranks, where there are any: they would wait for this one, which has failed.
  void abandon(int exitCode) const;

 private:
  void declare(CLI::App& command, const std::string& examples, std::function<void()> run, bool divides) const;

  struct State;
  std::shared_ptr<State> state_;
};

void addCameraCommand(CLI::App& program, const CommandContext& context);
void addOcriCommand(CLI::App& program, const CommandContext& context);
void addObserveCommand(CLI::App& program, const CommandContext& context);
void addDeviceCommand(CLI::App& program, const CommandContext& context);
void addDitherCommand(CLI::App& program, const CommandContext& context);
void addDoctorCommand(CLI::App& program, const CommandContext& context);
void addDemoCommand(CLI::App& program, const CommandContext& context);
void addQuiltCommand(CLI::App& program, const CommandContext& context);
void addRemoteCommand(CLI::App& program, const CommandContext& context);
void addRenderCommand(CLI::App& program, const CommandContext& context);
void addResampleCommand(CLI::App& program, const CommandContext& context);
void addEvaluateCommand(CLI::App& program, const CommandContext& context);
void addFeedsCommand(CLI::App& program, const CommandContext& context);
void addExploreCommand(CLI::App& program, const CommandContext& context);

/// Thrown by `run` to end with the exit code of another program, which has said itself what went wrong.
struct ExitCode {
  int code = 0;
};

/// Flushes standard output. Throws WorkError where what was printed could not be written in full.
void flushStandardOutput();

void addSeaCommand(CLI::App& program, const CommandContext& context);
void addSceneCommand(CLI::App& program, const CommandContext& context);
void addPresentCommand(CLI::App& program, const CommandContext& context);
void addShadeCommand(CLI::App& program, const CommandContext& context);
void addSliceCommand(CLI::App& program, const CommandContext& context);
void addSolidityCommand(CLI::App& program, const CommandContext& context);
void addVolumeCommand(CLI::App& program, const CommandContext& context);
void addViewersCommand(CLI::App& program, const CommandContext& context);
void addViewCommand(CLI::App& program, const CommandContext& context);
void addStudyCommand(CLI::App& program, const CommandContext& context);
void addAnalyseCommand(CLI::App& program, const CommandContext& context);
void addPowerCommand(CLI::App& program, const CommandContext& context);
void addManualCommands(CLI::App& program, const CommandContext& context);

}  // namespace ocelli
