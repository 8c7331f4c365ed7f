// What an experimenter types while a session runs.
#pragma once

#include <string>
#include <variant>

namespace ocelli {

struct ConsoleCommand {
  enum class Kind { kPause, kResume, kRedo, kAbort, kNote, kStatus, kHelp, kQuit };
  Kind kind = Kind::kHelp;
  std::string text{};  ///< of a note; the reason of a pause or of an end

  bool operator==(const ConsoleCommand&) const = default;
};

/// Why a line is no command, and what would be one.
struct ConsoleMistake {
  std::string text;
};
/// Neither: an empty line.
using ConsoleLine = std::variant<std::monostate, ConsoleCommand, ConsoleMistake>;

ConsoleLine parseConsoleLine(const std::string& line);

/// The commands, a line each.
std::string consoleHelp();

}  // namespace ocelli
