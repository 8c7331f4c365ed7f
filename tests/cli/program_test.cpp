// The program from outside: exit codes, streams, messages.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

TEST(Program, PrintsItsVersion) {
  const ProgramResult result = runProgram("--version");
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.output, "ocelli " OCELLI_VERSION "\n");
  EXPECT_THAT(result.error, IsEmpty());
}

TEST(Program, PrintsHelp) {
  const ProgramResult result = runProgram("--help");
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_THAT(result.output, AllOf(HasSubstr("Usage: ocelli"), HasSubstr("--threads"), HasSubstr("--quiet")));
  EXPECT_THAT(result.error, IsEmpty());
}

TEST(Program, WithoutACommandSaysWhatToTry) {
  const ProgramResult result = runProgram("");
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.output, IsEmpty());
  EXPECT_THAT(result.error, AllOf(StartsWith("ocelli: error: "), HasSubstr("try: ocelli --help")));
}

TEST(Program, NamesAnUnknownCommand) {
  const ProgramResult result = runProgram("slcie bunny.ply");
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.error, AllOf(StartsWith("ocelli: error: "), HasSubstr("\"slcie\"")));
}

TEST(Program, RejectsAnUnknownOption) {
  const ProgramResult result = runProgram("--no-such-option");
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.error, HasSubstr("--no-such-option"));
}

TEST(Program, RejectsAWrongThreadCount) {
  for (const char* threads : {"-1", "many", "99999999999", "", "1.5"}) {
    const ProgramResult result = runProgram("--threads '" + std::string(threads) + "'");
    EXPECT_EQ(result.exitCode, 2) << threads;
    EXPECT_THAT(result.error, HasSubstr("--threads")) << threads;
  }
}

TEST(Program, AFullStandardOutputIsAnError) {
  const ProgramResult result = runProgram("--help >/dev/full");
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.error, AllOf(StartsWith("ocelli: error: standard output: "), HasSubstr("No space left")));
}

TEST(Program, AClosedStandardOutputDoesNoHarm) {
  EXPECT_EQ(runProgram("--help >&-").exitCode, 0);
}

TEST(Program, AClosedStandardErrorDoesNoHarm) {
  EXPECT_EQ(runProgram("no-such-command 2>&-").exitCode, 2);
}

TEST(Program, AReaderThatIsGoneDoesNoHarm) {
  // `true` has ended when the program writes; its exit code goes around the pipe through descriptor 3.
  const ProgramResult result = runShell("{ { sleep 0.2; \"$OCELLI\" --help; echo $? >&3; } | true; } 3>&1");
  EXPECT_EQ(result.output, "0\n");
  EXPECT_THAT(result.error, IsEmpty());
}

TEST(Program, WhatDoesNotDivideItsWorkRefusesToRunInAJobOfRanks) {
  const ProgramResult result = runShell("OMPI_COMM_WORLD_RANK=0 OMPI_COMM_WORLD_SIZE=4 \"$OCELLI\" scene list");
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.error, HasSubstr("does not divide its work among 4 ranks"));
}

#ifndef OCELLI_WITH_MPI
TEST(Program, WithoutMpiRefusesToRunInAJobOfRanks) {
  const ProgramResult result =
      runShell("OMPI_COMM_WORLD_RANK=0 OMPI_COMM_WORLD_SIZE=4 \"$OCELLI\" ocri build builtin:teapot -o /dev/null");
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.error, HasSubstr("built without MPI"));
  const ProgramResult one = runShell(
      "OMPI_COMM_WORLD_RANK=0 OMPI_COMM_WORLD_SIZE=1 \"$OCELLI\" slice builtin:teapot --profile test -o /dev/null");
  EXPECT_EQ(one.exitCode, 0) << one.error;
}
#endif

}  // namespace
}  // namespace ocelli::test
