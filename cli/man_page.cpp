#include "cli/man_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

namespace ocelli {
namespace {

/// Text as roff shows it as it is: backslashes and hyphens are its own, and so are dots and quotes that begin a line.
std::string shown(const std::string& text) {
  std::string result;
  bool beginsLine = true;
  for (const char c : text) {
    if (beginsLine && (c == '.' || c == '\'')) {
      result += "\\&";
    }
    beginsLine = c == '\n';
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else {
      result += c;
    }
  }
  return result;
}

std::string namesOf(const OptionText& option) {
  std::string names;
  for (const std::string& name : option.names) {
    names += fmt::format("{}\\fB{}\\fR", names.empty() ? "" : ", ", shown(name));
  }
  return option.takesValue() ? names + fmt::format(" \\fI{}\\fR", shown(option.value)) : names;
}

std::string synopsis(const CommandText& command) {
  std::string line = fmt::format("\\fB{}\\fR", shown(command.name));
  if (!command.commands.empty()) {
    return line + " \\fICOMMAND\\fR [\\fIoptions\\fR]";
  }
  line += " [\\fIoptions\\fR]";
  for (const OptionText& option : command.options) {
    if (option.isPositional()) {
      const std::string name = fmt::format("\\fI{}\\fR", shown(option.names.front()));
      line += option.isRequired ? " " + name : " [" + name + "]";
    } else if (option.isRequired && option.takesValue()) {
      line += fmt::format(" \\fB{}\\fR \\fI{}\\fR", shown(option.names.back()), shown(option.value));
    }
  }
  return line;
}

std::string optionLines(const OptionText& option) {
  const std::string head =
      option.isPositional() ? fmt::format("\\fI{}\\fR", shown(option.names.front())) : namesOf(option);
  std::string help = option.help;
  if (!option.choices.empty()) {
    help += fmt::format("; one of {}", fmt::join(option.choices, ", "));
  }
  if (!option.defaultValue.empty() && option.defaultValue != "[]" && option.defaultValue != "\"\"") {
    help += fmt::format("; default: {}", option.defaultValue);
  }
  return fmt::format(".TP\n{}\n{}\n", head, shown(help.empty() ? "See the documentation." : help));
}

std::string section(const char* title, const std::string& lines) {
  return lines.empty() ? "" : fmt::format(".SH {}\n{}", title, lines);
}

/// Lines as they are, without the head of --help.
std::string examples(const CommandText& command) {
  std::string lines;
  std::istringstream stream(command.examples);
  for (std::string line; std::getline(stream, line);) {
    if (line != "Examples:") {
      lines += shown(line) + "\n";
    }
  }
  return command.commands.empty() && !lines.empty() ? ".nf\n" + lines + ".fi\n" : "";
}

}  // namespace

std::string manPage(const CommandText& command, const CommandText* above, const std::string& version) {
  std::string title = command.pageName();
  std::ranges::transform(title, title.begin(), [](char c) { return c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c; });
  std::string positionals;
  std::string options;
  for (const OptionText& option : command.options) {
    (option.isPositional() ? positionals : options) += optionLines(option);
  }
  std::string commands;
  std::string also = above == nullptr ? "" : fmt::format(".BR {} (1)", shown(above->pageName()));
  for (const CommandText& below : command.commands) {
    commands += fmt::format(".TP\n\\fB{}\\fR\n{}\n", shown(below.lastName()), shown(below.summary));
    also += fmt::format("{}.BR {} (1)", also.empty() ? "" : " ,\n", shown(below.pageName()));
  }
  return fmt::format(".TH {} 1 \"\" \"ocelli {}\" \"Ocelli\"\n", shown(title), shown(version)) +
         section("NAME", fmt::format("{} \\- {}\n", shown(command.pageName()), shown(command.summary))) +
         section("SYNOPSIS", synopsis(command) + "\n") + section("ARGUMENTS", positionals) +
         section("COMMANDS", commands) + section("OPTIONS", options) + section("EXAMPLES", examples(command)) +
         section("SEE ALSO", also.empty() ? "" : also + "\n");
}

}  // namespace ocelli
