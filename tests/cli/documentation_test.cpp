// The guide keeps up with the program: docs/command_line.md names every command and every option.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <sstream>

#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

/// The names in the list of subcommands of a --help.
std::vector<std::string> subcommandsOf(const std::string& help) {
  std::vector<std::string> names;
  std::istringstream lines(help.substr(std::min(help.find("\nSubcommands:\n"), help.size())));
  for (std::string line; std::getline(lines, line);) {
    if (std::smatch match; std::regex_search(line, match, std::regex("^  ([a-z]+) "))) {
      names.push_back(match[1]);
    }
  }
  return names;
}

/// Calls `visit(command, help)` for `command` ("" or "scene list ") and all below it.
template <class Visit>
void forEachCommand(const std::string& command, const Visit& visit) {
  const ProgramResult help = runProgram(command + "--help");
  ASSERT_EQ(help.exitCode, 0) << command << help.error;
  visit(command, help.output);
  for (const std::string& name : subcommandsOf(help.output)) {
    forEachCommand(command + name + " ", visit);
  }
}

TEST(CommandLineGuide, NamesEveryCommandAndOption) {
  const std::string guide = fileBytes(OCELLI_SOURCE_DIR "/docs/command_line.md");
  std::set<std::string> commands;
  std::set<std::string> options;
  forEachCommand("", [&](const std::string& command, const std::string& help) {
    const std::regex option("^  (?:-[a-z],)?(--[a-z-]+)", std::regex::multiline);
    for (std::sregex_iterator match(help.begin(), help.end(), option), end; match != end; ++match) {
      options.insert((*match)[1]);
    }
    if (subcommandsOf(help).empty()) {
      commands.insert("ocelli " + command.substr(0, command.size() - 1));
    }
  });
  // As many as there were when this was written: the parsing above finds them.
  EXPECT_GE(commands.size(), 12u);
  EXPECT_GE(options.size(), 25u);
  for (const std::string& command : commands) {
    EXPECT_THAT(guide, HasSubstr(command + " "));
  }
  for (const std::string& option : options) {
    EXPECT_TRUE(std::regex_search(guide, std::regex(option + "\\b"))) << option;
  }
}

}  // namespace
}  // namespace ocelli::test
