// Outputs that go into pipes: the bytes of the file, and nothing else.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// What arrives at the other end of a pipe, byte by byte as in a file of that name.
void expectAsInAFile(const std::string& command, const std::string& name) {
  const TemporaryFolder folder;
  const std::string file = (folder / name).string();
  const std::string pipe = (folder / "piped").string();
  const ProgramResult written = runProgram(command + " -o " + inQuotes(file));
  ASSERT_EQ(written.exitCode, 0) << command << written.error;
  const ProgramResult piped =
      runShell("{ \"$OCELLI\" " + command + " -o /dev/stdout; echo $? >'" + pipe + ".code'; } | cat >'" + pipe + "'");
  EXPECT_EQ(fileBytes(pipe + ".code"), "0\n") << command << piped.error;
  EXPECT_EQ(fileBytes(pipe), fileBytes(file)) << command;
}

TEST(OutputStream, carriesEveryFormatThatIsWrittenInOneGo) {
  const TemporaryFolder folder;
  const std::string volume = inQuotes(folder / "a.svol");
  const std::string image = inQuotes(folder / "a.exr");
  ASSERT_EQ(runProgram("slice builtin:teapot --profile test -o " + volume).exitCode, 0);
  ASSERT_EQ(runProgram("ocri build builtin:teapot --size 60x40 -o " + image).exitCode, 0);
  expectAsInAFile("render builtin:teapot --size 60x40", "x.png");
  expectAsInAFile("ocri build builtin:teapot --size 60x40", "x.exr");
  expectAsInAFile("ocri mesh " + image, "x.ply");
  expectAsInAFile("scene export builtin:teapot", "x.ply");
  expectAsInAFile("slice builtin:teapot --profile test", "x.svol");
  expectAsInAFile("observe " + volume + " --size 60x40", "x.png");
  expectAsInAFile("volume export " + volume, "x.nrrd");
  expectAsInAFile("volume join " + volume + " " + volume, "x.svol");
  expectAsInAFile("camera info builtin:town --camera portal", "x.json");
  expectAsInAFile("camera show builtin:town --camera portal", "x.svg");
}

TEST(OutputStream, whatIsPrintedElseGoesToStandardError) {
  const ProgramResult result =
      runProgram("slice builtin:teapot --profile test --json -o /dev/stdout | { head -c 4; cat >/dev/null; }");
  EXPECT_EQ(result.output, "\x89SVO");
  const size_t begin = result.error.find('{');
  ASSERT_NE(begin, std::string::npos) << result.error;
  EXPECT_EQ(nlohmann::json::parse(result.error.substr(begin, result.error.rfind('}') + 1 - begin))["profile"], "test");
}

TEST(OutputStream, namedPipesMayHaveAnyName) {
  const TemporaryFolder folder;
  const std::string pipe = inQuotes(folder / "pipe");
  const std::string got = inQuotes(folder / "got");
  const ProgramResult result =
      runShell("mkfifo " + pipe + "; cat " + pipe + " >" + got + " & \"$OCELLI\" scene export builtin:box -o " + pipe +
               "; code=$?; wait; exit $code");
  EXPECT_EQ(result.exitCode, 0) << result.error;
  EXPECT_THAT(fileBytes(folder / "got"), StartsWith("ply\n"));
}

TEST(OutputStream, aFileBehindTheStreamIsGoneOnWith) {
  const TemporaryFolder folder;
  const std::string log = inQuotes(folder / "log");
  const ProgramResult result =
      runShell("echo before >" + log + "; \"$OCELLI\" scene export builtin:box -o /dev/stdout >>" + log);
  EXPECT_EQ(result.exitCode, 0) << result.error;
  EXPECT_THAT(fileBytes(folder / "log"), StartsWith("before\nply\n"));
}

TEST(OutputStream, whatIsNotWrittenInOneGoIsRefused) {
  const TemporaryFolder folder;
  const std::string volume = inQuotes(folder / "a.svol");
  ASSERT_EQ(runProgram("slice builtin:teapot --profile test -o " + volume).exitCode, 0);
  for (const std::string arguments : {"--turntable 3", "--stereo 0.06"}) {
    const ProgramResult result = runProgram("observe " + volume + " " + arguments + " -o /dev/stdout | cat");
    EXPECT_THAT(result.output, IsEmpty()) << arguments;
    EXPECT_THAT(result.error, HasSubstr("/dev/stdout")) << arguments;
  }
}

TEST(OutputStream, aReaderThatGoesIsAnError) {
  const TemporaryFolder folder;
  const std::string code = inQuotes(folder / "code");
  const ProgramResult result =
      runShell("{ \"$OCELLI\" scene export builtin:statues,triangles=200000 -o /dev/stdout; echo $? >" + code +
               "; } | head -c 3");
  EXPECT_EQ(result.output, "ply");
  EXPECT_EQ(fileBytes(folder / "code"), "1\n");
  EXPECT_THAT(result.error, HasSubstr("/dev/stdout: cannot write this file (Broken pipe)"));
}

}  // namespace
}  // namespace ocelli::test
