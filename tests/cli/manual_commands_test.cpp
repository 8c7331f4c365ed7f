// `ocelli man`, `ocelli completion`, and what `ocelli` says alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::vector<std::string> wordsIn(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) {
    words.push_back(word);
  }
  return words;
}

/// The names of options in a --help.
std::set<std::string> optionsOf(const std::string& help) {
  std::set<std::string> options;
  const std::regex option("^  (?:-[a-z],)?(--[a-z-]+)", std::regex::multiline);
  for (std::sregex_iterator match(help.begin(), help.end(), option), end; match != end; ++match) {
    options.insert((*match)[1]);
  }
  return options;
}

/// What bash offers for the last of these words of a command line.
std::vector<std::string> completed(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) {
    line += "'" + word + "' ";
  }
  const ProgramResult result = runShell(
      "export OCELLI; bash -c 'source <(\"$OCELLI\" completion bash); COMP_WORDS=(\"$@\"); "
      "COMP_CWORD=$(($# - 1)); _ocelli; echo \"${COMPREPLY[@]}\"' bash " +
      line);
  EXPECT_EQ(result.exitCode, 0) << result.error;
  EXPECT_THAT(result.error, IsEmpty());
  return wordsIn(result.output);
}

TEST(Completion, offersCommandsOptionsAndWords) {
  EXPECT_THAT(completed({"ocelli", "stu"}), ElementsAre("study"));
  EXPECT_THAT(completed({"ocelli", "study", "ex"}), ElementsAre("export"));
  EXPECT_THAT(completed({"ocelli", "study", "export", "--fo"}), ElementsAre("--form", "--force"));
  EXPECT_THAT(completed({"ocelli", "study", "export", "--form", ""}), ElementsAre("csv", "psych-ds"));
  EXPECT_THAT(completed({"ocelli", "render", "builtin:town", "--method", "ray"}), ElementsAre("raycast"));
  EXPECT_THAT(completed({"ocelli", "completion", ""}), ElementsAre("bash", "zsh"));
  // Files are the shell's.
  EXPECT_THAT(completed({"ocelli", "study", "export", "--db", ""}), IsEmpty());
  EXPECT_THAT(completed({"ocelli", "render", "--quiet", ""}), IsEmpty());
}

TEST(Completion, hasEveryOptionOfACommand) {
  for (const std::string command : {"render", "slice"}) {
    const std::vector<std::string> offered = completed({"ocelli", command, "--"});
    const std::set<std::string> options = optionsOf(runProgram(command + " --help").output);
    EXPECT_GT(options.size(), 10u);
    for (const std::string& option : options) {
      EXPECT_THAT(offered, Contains(option)) << command;
    }
  }
}

TEST(Completion, isThereForZsh) {
  const ProgramResult result = runProgram("completion zsh");
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_TRUE(result.output.starts_with("#compdef ocelli\n"));
  EXPECT_THAT(result.output,
              AllOf(HasSubstr("_ocelli_study_export() {"), HasSubstr("[What to write]:csv|psych-ds:(csv psych-ds)'"),
                    HasSubstr("export) _ocelli_study_export ;;")));
  if (runShell("command -v zsh > /dev/null").exitCode == 0) {
    EXPECT_EQ(
        runShell(
            "\"$OCELLI\" completion zsh > \"${TMPDIR:-/tmp}/_ocelli_$$\" && zsh -n \"${TMPDIR:-/tmp}/_ocelli_$$\"; "
            "code=$?; rm -f \"${TMPDIR:-/tmp}/_ocelli_$$\"; exit $code")
            .exitCode,
        0);
  }
}

TEST(Completion, otherShellsAreRefused) {
  const ProgramResult result = runProgram("completion fish");
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.error, HasSubstr("fish"));
}

TEST(ManualPages, haveEveryCommandAndOption) {
  const TemporaryFolder folder;
  const ProgramResult result = runProgram("man -o " + inQuotes(folder / "new" / "man1"));
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const std::string program = fileBytes(folder / "new" / "man1" / "ocelli.1");
  EXPECT_THAT(program,
              AllOf(HasSubstr(".TH OCELLI 1"), HasSubstr("\\fBrender\\fR"), HasSubstr(".BR ocelli\\-render (1)")));
  size_t pages = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "new" / "man1")) {
    std::string command = entry.path().stem().string();
    const std::string page = fileBytes(entry.path());
    EXPECT_THAT(page, AllOf(HasSubstr(".SH NAME"), HasSubstr(".SH SYNOPSIS"), Not(HasSubstr("\n'"))));
    std::replace(command.begin(), command.end(), '-', ' ');
    const ProgramResult help =
        runProgram(command.substr(std::min(command.size(), std::string("ocelli ").size())) + " --help");
    ASSERT_EQ(help.exitCode, 0) << command;
    for (std::string option : optionsOf(help.output)) {
      option = std::regex_replace(option, std::regex("-"), "\\-");
      EXPECT_THAT(page, HasSubstr(option)) << command;
    }
    ++pages;
  }
  EXPECT_GE(pages, 60u);
}

TEST(ManualPages, sayWhereTheyCannotBeWritten) {
  const TemporaryFolder folder;
  EXPECT_EQ(runShell("echo > " + inQuotes(folder / "file")).exitCode, 0);
  const ProgramResult result = runProgram("man -o " + inQuotes(folder / "file" / "man1"));
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.error, HasSubstr("file/man1"));
}

TEST(Program, aloneSaysWhatToTryFirst) {
  const ProgramResult result = runProgram("");
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.error, AllOf(HasSubstr("ocelli demo"), HasSubstr("--help")));
  // Each command line of it is one.
  std::istringstream lines(result.error);
  int commands = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("  ocelli ")) {
      std::istringstream words(line);
      std::string ocelli;
      std::string command;
      words >> ocelli >> command;
      EXPECT_EQ(runProgram(command + " --help").exitCode, 0) << line;
      ++commands;
    }
  }
  EXPECT_GE(commands, 5);
}

}  // namespace
}  // namespace ocelli::test
