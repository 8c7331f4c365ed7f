// What commands share, with commands of the test's own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

class CommandContextTest : public testing::Test {
 protected:
  CommandContextTest() {
    context_.addCommonOptions(program_);
    CLI::App& outer = *program_.add_subcommand("outer", "has commands of its own");
    outer.require_subcommand(1);
    context_.finish(*outer.add_subcommand("inner", ""), "  ocelli outer inner", [this] { calls_ += "inner "; });
    CLI::App& copy = *program_.add_subcommand("copy", "");
    copy.add_option("FILE", file_)->required();
    context_.finish(copy, "  ocelli copy a.ply", [this] { calls_ += "copy " + file_ + " "; });
  }
  void TearDown() override { setThreadCount(0); }

  void parse(const std::string& line) {
    program_.parse(line);
    context_.run();
  }

  CommandContext context_;
  CLI::App program_;
  std::string file_;
  std::string calls_;
};

TEST_F(CommandContextTest, RunsTheChosenCommandAlone) {
  parse("copy a.ply");
  EXPECT_EQ(calls_, "copy a.ply ");
}

TEST_F(CommandContextTest, RunsANestedCommand) {
  parse("outer inner");
  EXPECT_EQ(calls_, "inner ");
}

TEST_F(CommandContextTest, NothingRunsWhereTheLineIsWrong) {
  EXPECT_THROW(parse("copy"), CLI::ParseError);
  EXPECT_THROW(parse("copy a.ply b.ply"), CLI::ParseError);
  EXPECT_EQ(calls_, "");
}

TEST_F(CommandContextTest, ThreadsCountBeforeAndAfterTheCommand) {
  parse("--threads 3 copy a.ply");
  EXPECT_EQ(threadCount(), 3);
  parse("outer inner --threads 2");
  EXPECT_EQ(threadCount(), 2);
}

TEST_F(CommandContextTest, HelpShowsTheExamples) {
  EXPECT_THAT(program_.get_subcommand("copy")->help(), testing::HasSubstr("Examples:\n  ocelli copy a.ply"));
}

TEST_F(CommandContextTest, NotesGoToStandardErrorUnlessQuiet) {
  testing::internal::CaptureStderr();
  context_.note("wrote a.ply");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "wrote a.ply\n");
  parse("--quiet copy a.ply");
  testing::internal::CaptureStderr();
  context_.note("wrote a.ply");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(CommandContextTest, ResultsGoToStandardOutputEvenWhenQuiet) {
  parse("--quiet copy a.ply");
  testing::internal::CaptureStdout();
  context_.print("42\n");
  flushStandardOutput();
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "42\n");
}

}  // namespace
}  // namespace ocelli
