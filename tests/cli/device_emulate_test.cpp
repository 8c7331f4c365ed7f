// `ocelli device emulate`: what it refuses before anything is emulated, and a display on a pseudo-terminal.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "display_sim/frames/svol_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(DeviceEmulate, aSerialNumberIsPrintableAscii) {
  const TemporaryFolder folder;
  const std::string shown = (folder / "shown").string();
  const std::pair<const char*, const char*> cases[] = {
      {"a\\nb", "a\\nb"}, {"a\\tb", "a\\tb"}, {"\\033[2J", "\\x1b[2J"}, {"d\\303\\251j\\303\\240", "d"}};
  for (const auto& [given, told] : cases) {
    const ProgramResult result =
        runShell(std::string("serial=$(printf '") + given +
                 "'); \"$OCELLI\" device emulate --serial \"$serial\" --shown '" + shown + "' -- true");
    EXPECT_EQ(result.exitCode, 2) << given << result.error;
    EXPECT_THAT(result.error, AllOf(HasSubstr("printable characters of ASCII"), HasSubstr(told))) << given;
  }
  const ProgramResult longest = runProgram("device emulate --serial " + std::string(127, 'x') + " -- true");
  EXPECT_EQ(longest.exitCode, 2);
  EXPECT_THAT(longest.error, HasSubstr("at most 126"));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(DeviceEmulate, aProgramShowsSomethingOnASerialLine) {
  const TemporaryFolder folder;
  const std::string line = (folder / "line").string();
  const std::string shown = (folder / "shown").string();
  const ProgramResult result =
      runProgram("device emulate --profile test --tty '" + line + "' --shown '" + shown +
                 "' -- ocelli present builtin:teapot,segments=4 --turn 5 --seconds 1 --device 'serial:" + line + "'");
  EXPECT_EQ(result.exitCode, 0) << result.error;
  EXPECT_THAT(result.output + result.error, AllOf(HasSubstr("on serial (test)"), HasSubstr("frames arrived")));
  EXPECT_GT(readSvol(folder / "shown/shown.svol", 1).litVoxels(), 0u);
  EXPECT_FALSE(std::filesystem::exists(std::filesystem::symlink_status(folder / "line"))) << "nothing is left";
}

TEST(DeviceEmulate, aTerminalThatCannotBeMadeIsSaid) {
  const ProgramResult result = runProgram("device emulate --profile test --tty /no/such/folder/line -- true");
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.error, AllOf(HasSubstr("/no/such/folder/line"), HasSubstr("pseudo-terminal")));
}

}  // namespace
}  // namespace ocelli::test
