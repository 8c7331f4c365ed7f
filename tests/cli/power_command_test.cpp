// `ocelli power` as a shell sees it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/analysis_power/small_protocol.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr int kInputWrong = 2;
constexpr int kWorkFailed = 1;

class PowerCommand : public testing::Test {
 protected:
  PowerCommand() { folder_.write("small.json", smallProtocolText()); }
  ProgramResult power(const std::string& rest) const { return runProgram("power " + path("small.json") + " " + rest); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void expectWrong(const std::string& rest, const std::string& message) const {
    const ProgramResult result = power(rest);
    EXPECT_EQ(result.exitCode, kInputWrong) << rest << result.error;
    EXPECT_THAT(result.error, HasSubstr(message)) << rest;
  }

  TemporaryFolder folder_;
};

TEST_F(PowerCommand, PrintsATableOfPowerAndErrors) {
  const ProgramResult result = power("--task find --ratio 0.6 --subjects 4,8 --simulations 20");
  EXPECT_EQ(result.exitCode, 0) << result.error;
  EXPECT_THAT(result.output,
              AllOf(HasSubstr("simulated studies by small, task find"),
                    HasSubstr("gc takes 0.6 of the time, test of the view"), HasSubstr("a power of 0.8 "),
                    HasSubstr("no effect of the view, test of the view"), HasSubstr("find it though it is not there")));
}

TEST_F(PowerCommand, PrintsJsonThatIsTheSameForAnyNumberOfThreads) {
  const std::string rest =
      "--task count --share-ppc 0.5 --share-gc 0.8 --subjects 4,8 --simulations 20 --seed 3 --json";
  const ProgramResult one = power(rest + " --threads 1");
  EXPECT_EQ(one.exitCode, 0) << one.error;
  EXPECT_EQ(one.output, power(rest + " --threads 3").output);
  const nlohmann::json json = nlohmann::json::parse(one.output);
  EXPECT_EQ(json.at("simulated"), true);
  ASSERT_EQ(json.at("curves").size(), 2U);
  EXPECT_EQ(json.at("curves")[0].at("share_is"), "power");
  EXPECT_EQ(json.at("curves")[1].at("share_is"), "type_1_error");
  EXPECT_EQ(json.at("curves")[0].at("sizes")[1].at("subjects"), 8);
  EXPECT_TRUE(json.at("curves")[0].contains("subjects_for_power"));
  EXPECT_FALSE(json.at("curves")[1].contains("subjects_for_power"));
}

TEST_F(PowerCommand, CasesThatDifferInTheEffectOfTheViewTakeFromThePower) {
  const std::string rest = "--task find --ratio 0.6 --subjects 8 --simulations 40 --without-none --json";
  const ProgramResult alike = power(rest);
  const ProgramResult differing = power(rest + " --case-view-sd 1");
  ASSERT_EQ(differing.exitCode, 0) << differing.error;
  EXPECT_THAT(differing.output, HasSubstr("in the effect of the view by 1"));
  // Estimates are scattered by 1 / sqrt(4 cases) about log 0.6: the mean of 40 studies moves by some hundredths.
  const auto estimate = [](const ProgramResult& result) {
    return nlohmann::json::parse(result.output).at("curves")[0].at("sizes")[0].at("mean_estimate").get<double>();
  };
  EXPECT_NE(estimate(alike), estimate(differing));
  expectWrong("--task find --ratio 0.6 --case-view-sd nan", "is no number from 0 to 180");
}

TEST_F(PowerCommand, WritesAReport) {
  const ProgramResult result = power(
      "--task path --share-ppc 0.7 --odds-ratio 1 --equivalence --subjects 4,8 "
      "--simulations 20 -o " +
      path("report"));
  EXPECT_EQ(result.exitCode, 0) << result.error;
  EXPECT_THAT(fileBytes(folder_ / "report/index.html"), HasSubstr("Simulated studies"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "report/report.pdf"));
  EXPECT_THAT(fileBytes(folder_ / "report/report.json"), HasSubstr("test of equivalence"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "report/figures/figure-power.svg"));
}

TEST_F(PowerCommand, NeedsATaskThatTheProtocolHas) {
  expectWrong("--task survey --ratio 0.8", "--task");
  expectWrong("--ratio 0.8", "--task is required");
  folder_.write("find-only.json", R"({"name": "tiny", "title": "Tiny", "sessions": 1,
    "mazes": {"bend": {"plan": ["+-+-+-+", "|     |", "+ +-+-+"]}},
    "blocks": [{"name": "find", "title": "Find", "task": "find", "maze": "bend", "limit_seconds": 20,
                "cases": [{"label": "end", "row": 0, "column": 2}]}]})");
  const ProgramResult none = runProgram("power " + path("find-only.json") + " --task count --odds-ratio 2");
  EXPECT_EQ(none.exitCode, kInputWrong);
  EXPECT_THAT(none.error, HasSubstr("protocol tiny has no block with the task count"));
  EXPECT_EQ(runProgram("power " + path("none.json") + " --task find --ratio 0.8").exitCode, kInputWrong);
}

TEST_F(PowerCommand, RejectsAbsurdNumbers) {
  expectWrong("--task find", "which effect is it that studies should find?");
  expectWrong("--task find --ratio 0", "is no number from 0.05 to 20");
  expectWrong("--task find --ratio nan", "is no number from 0.05 to 20");
  expectWrong("--task find --ratio 0.8 --residual-sd -1", "is no number from 0 to 180");
  expectWrong("--task count --share-ppc 1 --share-gc 0.5", "is no number from 0.01 to 0.99");
  expectWrong("--task find --ratio 0.8 --subjects 1,10", "a study of one subject");
  expectWrong("--task find --ratio 0.8 --subjects 20,10", "do not rise");
  expectWrong("--task find --ratio 0.8 --subjects 10,10", "do not rise");
  expectWrong("--task find --ratio 0.8 --subjects 5,100000", "--subjects");
  expectWrong("--task find --ratio 0.8 --simulations 3", "--simulations");
  expectWrong("--task find --ratio 0.8 --power 1", "--power");
  expectWrong("--task find --ratio 0.8 --power 0.04", "chance alone reaches a power of 0.04");
  expectWrong("--task find --ratio 0.8 --alpha 0", "--alpha");
  expectWrong("--task find --ratio 0.8 --drop-out 1", "--drop-out");
  expectWrong("--task count --odds-ratio 2 --equivalence", "no bounds of equivalence for the task count");
}

TEST_F(PowerCommand, PlansNeedAModelOfTheView) {
  folder_.write("plan.json", R"({"name": "none", "registered": "nowhere", "models": [
    {"name": "find-survival", "task": "find", "kind": "kaplan_meier"}]})");
  expectWrong("--task find --ratio 0.8 --plan " + path("plan.json"), "the plan has no mixed model of find");
}

TEST_F(PowerCommand, TheFolderOfTheReportIsCheckedBeforeTheWork) {
  std::filesystem::create_directory(folder_ / "full");
  folder_.write("full/letter.txt", "dear");
  expectWrong("--task find --ratio 0.8 --simulations 100000 -o " + path("full"), "is no report");
  EXPECT_EQ(power("--task find --ratio 0.8 --simulations 100000 -o " + path("no/report")).exitCode, kWorkFailed);
}

}  // namespace
}  // namespace ocelli::test
