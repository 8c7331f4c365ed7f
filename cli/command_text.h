// What a command's --help says, as data: for its manual page and for what shells complete. Commands and options are
// declared once (command.h); this reads them.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace ocelli {

struct OptionText {
  std::vector<std::string> names;    ///< "-o", "--output"; of a positional one name without dashes
  std::string value;                 ///< what it takes, as --help shows it: "WIDTHxHEIGHT"; empty for a flag
  std::vector<std::string> choices;  ///< where it takes one of these words
  std::string help;
  std::string defaultValue;
  bool isRequired = false;
  bool repeats = false;  ///< takes several values

  bool isPositional() const { return !names.front().starts_with('-'); }
  bool takesValue() const { return !value.empty(); }
};

struct CommandText {
  std::string name;  ///< with those above it: "ocelli scene walk"
  std::string summary;
  std::vector<OptionText> options;  ///< positionals first, in their order
  std::string examples;             ///< lines below --help, as they stand there
  std::vector<CommandText> commands;

  /// "walk"
  std::string lastName() const;
  /// "ocelli-scene-walk", as its manual page is called.
  std::string pageName() const;
};

/// Of a command and all below it. `parent` is the name of the one above, "" for the program.
CommandText commandText(const CLI::App& command, const std::string& parent = "");

/// All of them, the first before those below it.
std::vector<const CommandText*> everyCommand(const CommandText& program);

}  // namespace ocelli
