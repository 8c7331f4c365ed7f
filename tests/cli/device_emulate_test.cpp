// `ocelli device emulate`: what it refuses before anything is emulated.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace ocelli::test
