#include "cli/shell_completion.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace ocelli {
namespace {

std::string optionNames(const CommandText& command) {
  std::string names;
  for (const OptionText& option : command.options) {
    for (const std::string& name : option.names) {
      if (!option.isPositional()) {
        names += (names.empty() ? "" : " ") + name;
      }
    }
  }
  return names;
}

/// What may stand next: commands below it, or words that a positional takes.
std::string nextWords(const CommandText& command) {
  std::string names;
  for (const OptionText& option : command.options) {
    if (option.isPositional() && !option.choices.empty()) {
      return fmt::format("{}", fmt::join(option.choices, " "));
    }
  }
  for (const CommandText& below : command.commands) {
    names += (names.empty() ? "" : " ") + below.lastName();
  }
  return names;
}

/// Cases of bash that set `values`: for options before the word that take one of a few words, or anything else.
std::string bashValues(const CommandText& command) {
  std::string cases;
  std::string others;
  for (const OptionText& option : command.options) {
    if (option.isPositional() || !option.takesValue()) {
      continue;
    }
    const std::string names = fmt::format("{}", fmt::join(option.names, "|"));
    if (option.choices.empty()) {
      others += (others.empty() ? "" : "|") + names;
    } else {
      cases += fmt::format("        {}) values='{}' ;;\n", names, fmt::join(option.choices, " "));
    }
  }
  return others.empty() ? cases : cases + fmt::format("        {}) files=1 ;;\n", others);
}

/// In single quotes of zsh, inside of a part of _arguments that ends with `:` or `]`.
std::string zshText(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'') {
      result += "'\\''";
    } else if (c == '[' || c == ']' || c == ':' || c == '\\') {
      result += std::string("\\") + c;
    } else {
      result += c == '\n' ? ' ' : c;
    }
  }
  return result;
}

std::string zshAction(const OptionText& option) {
  return option.choices.empty() ? "_files" : fmt::format("({})", fmt::join(option.choices, " "));
}

std::string zshArguments(const CommandText& command) {
  std::string lines;
  int place = 0;
  for (const OptionText& option : command.options) {
    if (option.isPositional()) {
      const std::string places = option.repeats ? "*" : std::to_string(++place);
      lines += fmt::format("    '{}:{}:{}' \\\n", places, zshText(option.names.front()), zshAction(option));
      continue;
    }
    for (const std::string& name : option.names) {
      lines += fmt::format("    '{}[{}]{}' \\\n", name, zshText(option.help),
                           option.takesValue() ? ":" + zshText(option.value) + ":" + zshAction(option) : "");
    }
  }
  return lines;
}

std::string zshFunctionName(const CommandText& command) {
  std::string name = "_" + command.name;
  std::ranges::replace(name, ' ', '_');
  std::ranges::replace(name, '-', '_');
  return name;
}

std::string zshFunction(const CommandText& command) {
  std::string body = "  _arguments -C \\\n" + zshArguments(command);
  if (command.commands.empty()) {
    return fmt::format("{}() {{\n{}    && return\n}}\n\n", zshFunctionName(command), body);
  }
  std::string described;
  std::string cases;
  for (const CommandText& below : command.commands) {
    described += fmt::format("      '{}:{}'\n", below.lastName(), zshText(below.summary));
    cases += fmt::format("        {}) {} ;;\n", below.lastName(), zshFunctionName(below));
  }
  return fmt::format(
      "{0}() {{\n  local state line\n{1}    '1:command:->command' \\\n    '*::argument:->argument' && return\n"
      "  case $state in\n    command)\n      local -a commands=(\n{2}      )\n      _describe command commands ;;\n"
      "    argument)\n      case $line[1] in\n{3}      esac ;;\n  esac\n}}\n\n",
      zshFunctionName(command), body, described, cases);
}

}  // namespace

std::string bashCompletion(const CommandText& program) {
  std::string paths;
  std::string cases;
  for (const CommandText* command : everyCommand(program)) {
    if (command != &program) {
      paths += (paths.empty() ? "" : "|") + fmt::format("'{}'", command->name);
    }
    cases += fmt::format("    '{}')\n      words='{}'\n      options='{}'\n      case $before in\n{}      esac ;;\n",
                         command->name, nextWords(*command), optionNames(*command), bashValues(*command));
  }
  return fmt::format(R"(# Completion of ocelli for bash.
_ocelli() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}}
  local path=ocelli words= options= values= files= i
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case "$path ${{COMP_WORDS[i]}}" in
      {}) path="$path ${{COMP_WORDS[i]}}" ;;
    esac
  done
  case $path in
{}  esac
  if [[ -n $values ]]; then
    COMPREPLY=($(compgen -W "$values" -- "$word"))
  elif [[ -z $files && $word == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$word"))
  elif [[ -z $files && -n $words ]]; then
    COMPREPLY=($(compgen -W "$words" -- "$word"))
  else
    COMPREPLY=()  # files, by -o default
  fi
}}
complete -o default -F _ocelli ocelli
)",
                     paths, cases);
}

std::string zshCompletion(const CommandText& program) {
  std::string functions;
  for (const CommandText* command : everyCommand(program)) {
    functions += zshFunction(*command);
  }
  return "#compdef ocelli\n# Completion of ocelli for zsh.\n\n" + functions + "_ocelli \"$@\"\n";
}

}  // namespace ocelli
