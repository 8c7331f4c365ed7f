// `ocelli analyse --columns` as a shell sees it.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::MatchesRegex;

const char* const kColumnErrorForm = "ocelli: error: [^\n]+: [^\n]+\n  try: [^\n]+\n";

class AnalyseColumns : public testing::Test {
 protected:
  /// In the folder of the examples.
  ProgramResult analyse(const std::string& rest) const {
    return runShell(fmt::format("cd '{}/analysis/dataset/column_maps/examples' && \"$OCELLI\" analyse {}",
                                OCELLI_SOURCE_DIR, rest));
  }
  std::string report(const std::string& name) const { return inQuotes(folder_ / name); }
  void expectRefused(const std::string& rest, const std::string& reason) const {
    const ProgramResult result = analyse(rest + " -o " + report("refused"));
    EXPECT_EQ(result.exitCode, 2) << rest << ": " << result.error;
    EXPECT_THAT(result.error, AllOf(MatchesRegex(kColumnErrorForm), HasSubstr(reason))) << rest;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "refused"));
  }

  TemporaryFolder folder_;
};

TEST_F(AnalyseColumns, ATableAndItsMapGiveAReport) {
  const ProgramResult result = analyse("psychopy.csv --columns psychopy.json --csv --json -o " + report("report"));
  ASSERT_EQ(result.exitCode, 0) << result.error;
  EXPECT_THAT(result.error, AllOf(HasSubstr("128 trials of 8 subjects"), HasSubstr("delete this report by hand")));
  EXPECT_EQ(nlohmann::json::parse(result.output)["simulated"], true);
  EXPECT_THAT(fileBytes(folder_ / "report/index.html"), HasSubstr("Simulated subjects"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "report/analysis.R"));
}

TEST_F(AnalyseColumns, AMapThatComesWithTheProgramIsFoundByName) {
  const ProgramResult result = analyse("uxf.csv --columns uxf --json --only main -o " + report("report"));
  ASSERT_EQ(result.exitCode, 0) << result.error;
  EXPECT_TRUE(nlohmann::json::parse(result.output)["simulated"].is_null());
  EXPECT_THAT(fileBytes(folder_ / "report/index.html"), HasSubstr("Not known: people or simulated"));
}

TEST_F(AnalyseColumns, RowsOfACellAreLinesOfTheTable) {
  const ProgramResult result =
      analyse("uxf.csv --columns uxf.json --explain task-search-times/all-trials-pinhole/estimate");
  ASSERT_EQ(result.exitCode, 0) << result.error;
  // The second line of uxf.csv is the first trial of P01, with the pinhole.
  EXPECT_THAT(result.output,
              AllOf(HasSubstr("source 1: uxf.csv"), HasSubstr("\n1  2  P01  1  search/hall  pinhole  ")));
}

TEST_F(AnalyseColumns, WhatCannotBeReadIsRefusedWithWhereAndWhatToDo) {
  expectRefused("psychopy.csv", "this is a table, and no database");
  expectRefused("psychopy.csv --columns psychopi", "one of jspsych, psychopy, uxf");
  expectRefused("psychopy.csv --columns uxf", "psychopy.csv:1");
  expectRefused("psychopy.csv --columns psychopy", "column \"key_resp.rt\" is empty as the trial's time ran out");
  expectRefused("uxf.csv ./uxf.csv --columns uxf", "this table is given twice");
  expectRefused("uxf.csv --columns uxf --protocol x.json", "have no protocol");
  expectRefused("uxf.csv --columns uxf --simulated only", "not known whether these subjects are people or simulated");
  expectRefused(". --columns uxf", "this is a folder");
}

}  // namespace
}  // namespace ocelli::test
