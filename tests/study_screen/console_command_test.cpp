#include "study/screen/console_command.h"

#include <gmock/gmock.h>

namespace ocelli {
namespace {

using testing::HasSubstr;
using Kind = ConsoleCommand::Kind;

TEST(ConsoleCommand, readsEachCommand) {
  const std::vector<std::pair<std::string, ConsoleCommand>> lines{
      {"pause", {Kind::kPause}},
      {"pause the phone rings", {Kind::kPause, "the phone rings"}},
      {"resume", {Kind::kResume}},
      {"redo", {Kind::kRedo}},
      {"abort", {Kind::kAbort}},
      {"abort fire alarm", {Kind::kAbort, "fire alarm"}},
      {"note wears  glasses", {Kind::kNote, "wears  glasses"}},
      {"status", {Kind::kStatus}},
      {"help", {Kind::kHelp}},
      {"quit", {Kind::kQuit}},
      {"  redo \t\r", {Kind::kRedo}},
      {"note\tx", {Kind::kNote, "x"}}};
  for (const auto& [line, command] : lines) {
    const ConsoleLine read = parseConsoleLine(line);
    ASSERT_TRUE(std::holds_alternative<ConsoleCommand>(read)) << line;
    EXPECT_EQ(std::get<ConsoleCommand>(read), command) << line;
  }
}

TEST(ConsoleCommand, takesNothingForNothing) {
  for (const char* line : {"", "   ", "\t\r"}) {
    EXPECT_TRUE(std::holds_alternative<std::monostate>(parseConsoleLine(line)));
  }
}

TEST(ConsoleCommand, saysWhatIsWrong) {
  const std::vector<std::pair<std::string, std::string>> mistakes{{"stop", "\"stop\""},     {"PAUSE", "\"PAUSE\""},
                                                                  {"note", "note TEXT"},    {"note   ", "note TEXT"},
                                                                  {"redo trial 3", "redo"}, {"quit now", "quit"}};
  for (const auto& [line, said] : mistakes) {
    const ConsoleLine read = parseConsoleLine(line);
    ASSERT_TRUE(std::holds_alternative<ConsoleMistake>(read)) << line;
    EXPECT_THAT(std::get<ConsoleMistake>(read).text, HasSubstr(said));
  }
}

TEST(ConsoleCommand, helpNamesEachCommand) {
  for (const char* name : {"pause", "resume", "redo", "note TEXT", "status", "abort", "quit", "help"}) {
    EXPECT_THAT(consoleHelp(), HasSubstr(name));
  }
}

}  // namespace
}  // namespace ocelli
