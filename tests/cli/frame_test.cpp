// The frame of the commands, with commands of the test's own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

class FrameTest : public testing::Test {
 protected:
  FrameTest() {
    frame_.addCommonOptions(program_);
    CLI::App& outer = *program_.add_subcommand("outer", "has commands of its own");
    outer.require_subcommand(1);
    frame_.finish(*outer.add_subcommand("inner", ""), "  ocelli outer inner", [this] { calls_ += "inner "; });
    CLI::App& copy = *program_.add_subcommand("copy", "");
    copy.add_option("FILE", file_)->required();
    frame_.finish(copy, "  ocelli copy a.ply", [this] { calls_ += "copy " + file_ + " "; });
  }
  void TearDown() override { setThreadCount(0); }

  void parse(const std::string& line) {
    program_.parse(line);
    frame_.run();
  }

  Frame frame_;
  CLI::App program_;
  std::string file_;
  std::string calls_;
};

TEST_F(FrameTest, RunsTheChosenCommandAlone) {
  parse("copy a.ply");
  EXPECT_EQ(calls_, "copy a.ply ");
}

TEST_F(FrameTest, RunsANestedCommand) {
  parse("outer inner");
  EXPECT_EQ(calls_, "inner ");
}

TEST_F(FrameTest, NothingRunsWhereTheLineIsWrong) {
  EXPECT_THROW(parse("copy"), CLI::ParseError);
  EXPECT_THROW(parse("copy a.ply b.ply"), CLI::ParseError);
  EXPECT_EQ(calls_, "");
}

TEST_F(FrameTest, ThreadsCountBeforeAndAfterTheCommand) {
  parse("--threads 3 copy a.ply");
  EXPECT_EQ(threadCount(), 3);
  parse("outer inner --threads 2");
  EXPECT_EQ(threadCount(), 2);
}

TEST_F(FrameTest, HelpShowsTheExamples) {
  EXPECT_THAT(program_.get_subcommand("copy")->help(), testing::HasSubstr("Examples:\n  ocelli copy a.ply"));
}

TEST_F(FrameTest, NotesGoToStandardErrorUnlessQuiet) {
  testing::internal::CaptureStderr();
  frame_.note("wrote a.ply");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "wrote a.ply\n");
  parse("--quiet copy a.ply");
  testing::internal::CaptureStderr();
  frame_.note("wrote a.ply");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(FrameTest, ResultsGoToStandardOutputEvenWhenQuiet) {
  parse("--quiet copy a.ply");
  testing::internal::CaptureStdout();
  frame_.print("42\n");
  flushStandardOutput();
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "42\n");
}

}  // namespace
}  // namespace ocelli
