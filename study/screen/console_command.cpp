#include "study/screen/console_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "oc_core/base/trimmed.h"

namespace ocelli {
namespace {

enum class Rest { kNone, kOptional, kNeeded };

struct CommandKind {
  std::string_view name;
  ConsoleCommand::Kind kind;
  Rest rest;
  std::string_view usage;
  std::string_view meaning;
};

constexpr std::array<CommandKind, 8> kCommands{
    {{"pause", ConsoleCommand::Kind::kPause, Rest::kOptional, "pause [REASON]",
      "stop for a while; a trial that runs begins again afterwards"},
     {"resume", ConsoleCommand::Kind::kResume, Rest::kNone, "resume",
      "go on after a pause, or after practice that failed"},
     {"redo", ConsoleCommand::Kind::kRedo, Rest::kNone, "redo", "the trial that runs, or else the last one, again"},
     {"note", ConsoleCommand::Kind::kNote, Rest::kNeeded, "note TEXT", "store a note with the session"},
     {"status", ConsoleCommand::Kind::kStatus, Rest::kNone, "status", "where the session is"},
     {"abort", ConsoleCommand::Kind::kAbort, Rest::kOptional, "abort [REASON]",
      "end the session; `ocelli study resume` can go on with it"},
     {"quit", ConsoleCommand::Kind::kQuit, Rest::kNone, "quit", "the same, and close the window at once"},
     {"help", ConsoleCommand::Kind::kHelp, Rest::kNone, "help", "these lines"}}};

}  // namespace

ConsoleLine parseConsoleLine(const std::string& line) {
  const std::string_view text = trimmed(line);
  if (text.empty()) {
    return std::monostate();
  }
  const size_t space = std::min(text.find_first_of(" \t"), text.size());
  const std::string_view name = text.substr(0, space);
  const std::string_view rest = trimmed(text.substr(space));
  const auto* const command = std::ranges::find(kCommands, name, &CommandKind::name);
  if (command == kCommands.end()) {
    return ConsoleMistake{fmt::format("there is no command \"{}\"; try: help", name)};
  }
  if ((command->rest == Rest::kNone && !rest.empty()) || (command->rest == Rest::kNeeded && rest.empty())) {
    return ConsoleMistake{fmt::format("it is: {}", command->usage)};
  }
  return ConsoleCommand{command->kind, std::string(rest)};
}

std::string consoleHelp() {
  std::string help;
  for (const CommandKind& command : kCommands) {
    help += fmt::format("  {:<16}  {}\n", command.usage, command.meaning);
  }
  return help;
}

}  // namespace ocelli
