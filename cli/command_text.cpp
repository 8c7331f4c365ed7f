#include "cli/command_text.h"

#include <CLI/CLI.hpp>
#include <algorithm>

namespace ocelli {
namespace {

/// The words of a text such as "csv|psych-ds"; none where a part is a place holder such as FILE.
std::vector<std::string> wordsOf(const std::string& text, char separator) {
  std::vector<std::string> words;
  for (std::string& word : CLI::detail::split(text, separator)) {
    const bool isWord = !word.empty() && std::ranges::all_of(word, [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '.' || c == '_';
    });
    if (!isWord) {
      return {};
    }
    words.push_back(std::move(word));
  }
  return words.size() > 1 ? words : std::vector<std::string>{};
}

/// Of a type as --help shows it: "csv|psych-ds", or "NAME:{raster,points}" where a check has the words.
std::vector<std::string> choicesOf(const std::string& type) {
  const size_t begin = type.find('{');
  const size_t end = type.find('}', begin);
  return end != std::string::npos ? wordsOf(type.substr(begin + 1, end - begin - 1), ',')
                                  : wordsOf(type.substr(0, type.find(':')), '|');
}

OptionText optionText(const CLI::Option& option) {
  OptionText text;
  for (const std::string& name : option.get_snames()) {
    text.names.push_back("-" + name);
  }
  for (const std::string& name : option.get_lnames()) {
    text.names.push_back("--" + name);
  }
  if (text.names.empty()) {
    text.names.push_back(option.get_name(true));
  }
  // What checks add to the type is for --help alone: "N:INT in [0 - 1024]".
  const std::string type = option.get_type_name();
  text.value = option.get_items_expected_max() > 0 || text.isPositional() ? type.substr(0, type.find(':')) : "";
  text.choices = text.takesValue() ? choicesOf(type) : std::vector<std::string>{};
  text.help = option.get_description();
  text.defaultValue = option.get_default_str();
  text.isRequired = option.get_required();
  text.repeats = option.get_items_expected_max() > 1;
  return text;
}

}  // namespace

std::string CommandText::lastName() const {
  return name.substr(name.rfind(' ') + 1);
}

std::string CommandText::pageName() const {
  std::string page = name;
  std::ranges::replace(page, ' ', '-');
  return page;
}

CommandText commandText(const CLI::App& command, const std::string& parent) {
  CommandText text;
  text.name = parent.empty() ? command.get_name() : parent + " " + command.get_name();
  text.summary = command.get_description();
  text.examples = command.get_footer();
  for (const CLI::Option* option : command.get_options()) {
    text.options.push_back(optionText(*option));
  }
  std::ranges::stable_partition(text.options, &OptionText::isPositional);
  for (const CLI::App* below : command.get_subcommands([](const CLI::App*) { return true; })) {
    text.commands.push_back(commandText(*below, text.name));
  }
  return text;
}

std::vector<const CommandText*> everyCommand(const CommandText& program) {
  std::vector<const CommandText*> all{&program};
  for (const CommandText& below : program.commands) {
    const std::vector<const CommandText*> more = everyCommand(below);
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

}  // namespace ocelli
