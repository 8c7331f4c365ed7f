// `ocelli feeds` becomes another program: here a script that says what it was given.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

/// What the script does; `arguments` follow `ocelli`.
ProgramResult runWith(const std::string& script, const std::string& arguments) {
  const TemporaryFolder folder;
  const std::filesystem::path program = folder.write("program", "#!/bin/sh\n" + script + "\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  return runShell("OCELLI_FEEDS_PROGRAM=" + inQuotes(program) + " \"$OCELLI\" " + arguments);
}

TEST(FeedsCommand, handsOnItsWords) {
  const ProgramResult result =
      runWith("for word; do echo \"[$word]\"; done", "-q feeds run 'my setup.json' --seconds 2 -o x.mp4");
  EXPECT_EQ(result.exitCode, 0) << result.error;
  EXPECT_EQ(result.output, "[-q]\n[feeds]\n[run]\n[my setup.json]\n[--seconds]\n[2]\n[-o]\n[x.mp4]\n");
}

TEST(FeedsCommand, endsAsTheOtherProgramDoes) {
  const ProgramResult result = runWith("echo no camera >&2; exit 7", "feeds simulate -o x");
  EXPECT_EQ(result.exitCode, 7);
  EXPECT_EQ(result.error, "no camera\n");
  EXPECT_EQ(runWith("kill -9 $$", "feeds evaluate x; echo $?").output, "137\n") << "it is the same process";
}

TEST(FeedsCommand, readsItsOptionsItself) {
  const std::string never = "echo was started";
  EXPECT_THAT(runWith(never, "feeds run --help").output, HasSubstr("--erased"));
  const ProgramResult wrong = runWith(never, "feeds run setup.json --erased green");
  EXPECT_EQ(wrong.exitCode, 2);
  EXPECT_EQ(wrong.output, "");
  EXPECT_THAT(wrong.error, HasSubstr("try: ocelli feeds run --help"));
}

TEST(FeedsCommand, takesNoFolderByTheNameOfAVideo) {
  for (const char* output : {"x.avi", "x.MP4", "x.png"}) {
    const ProgramResult run = runWith("echo was started", std::string("feeds run setup.json -o ") + output);
    EXPECT_EQ(run.exitCode, 2) << output;
    EXPECT_THAT(run.error, HasSubstr("ends neither in .mp4 nor in .mkv"));
  }
  for (const char* output : {"x.mp4", "x.mkv", "frames", "frames.1/"}) {
    EXPECT_EQ(runWith("echo was started", std::string("feeds run setup.json -o ") + output).output, "was started\n");
  }
  const ProgramResult panes = runWith("echo was started", "feeds panes setup.json -o x.txt");
  EXPECT_EQ(panes.exitCode, 2);
  EXPECT_THAT(panes.error, HasSubstr("does not end in .mp4 or .mkv or .png"));
}

TEST(FeedsCommand, saysWhatToInstallWhereTheOtherProgramIsMissing) {
  const ProgramResult result = runShell("OCELLI_FEEDS_PROGRAM=/nowhere/it \"$OCELLI\" feeds simulate -o x");
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.error, HasSubstr("/nowhere/it: there is no program that reads feeds"));
  const TemporaryFolder folder;
  const ProgramResult alone = runShell("cp \"$OCELLI\" " + inQuotes(folder / "ocelli") + " && " +
                                       inQuotes(folder / "ocelli") + " feeds simulate -o x");
  if (!std::filesystem::exists("/usr/local/libexec/ocelli/ocelli-feeds")) {
    EXPECT_EQ(alone.exitCode, 1);
    EXPECT_THAT(alone.error, HasSubstr("the program ocelli-feeds is missing"));
    EXPECT_THAT(alone.error, HasSubstr("OCELLI_WITH_FEEDS=ON"));
  }
}

}  // namespace
}  // namespace ocelli::test
