// `ocelli evaluate` from outside: what it writes, and how it goes on after an interruption.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>

#include "oc_core/image/png_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* kSmallEvaluation =
    "evaluate builtin:doors --size 90x60 --profile test --interior 2 --directions 2 --runs 1 ";

/// Without what differs from run to run.
nlohmann::json timeless(const std::string& bytes) {
  nlohmann::json json = nlohmann::json::parse(bytes);
  for (nlohmann::json& row : json["representations"]) {
    for (const char* time : {"build_ms", "mesh_ms", "slice_ms"}) {
      row.erase(time);
    }
  }
  return json;
}

TEST(Evaluate, WritesAllItsFilesAndLeavesNoOther) {
  const TemporaryFolder folder;
  const ProgramResult result =
      runProgram(kSmallEvaluation + std::string("--cameras di,ddoc --json ") + inQuotes(folder / "x.json") + " --csv " +
                 inQuotes(folder / "x.csv") + " --csv-offsets " + inQuotes(folder / "o.csv") + " --page " +
                 inQuotes(folder / "my page"));
  ASSERT_EQ(result.exitCode, 0) << result.error;
  EXPECT_THAT(result.output, HasSubstr("ddoc"));
  const auto json = nlohmann::json::parse(fileBytes(folder / "x.json"));
  EXPECT_EQ(json["complete"], true);
  ASSERT_EQ(json["representations"].size(), 2u);
  EXPECT_TRUE(json["representations"][1]["flip"]["edges"].is_number());
  const std::string csv = fileBytes(folder / "x.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
  const std::string offsets = fileBytes(folder / "o.csv");
  EXPECT_EQ(static_cast<size_t>(std::count(offsets.begin(), offsets.end(), '\n')),
            1 + 2 * json["offsets"]["half_sides"].size());
  const std::string html = fileBytes(folder / "my page/index.html");
  const std::regex source("src=\"([^\"]*)\"");
  size_t images = 0;
  for (std::sregex_iterator it(html.begin(), html.end(), source); it != std::sregex_iterator(); ++it, ++images) {
    EXPECT_EQ(readPng(folder / ("my page/" + (*it)[1].str())).width(), 90);
  }
  EXPECT_EQ(images, 5u);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 4);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "my page"), {}), 6);
}

TEST(Evaluate, TakesEveryShapeOfCell) {
  for (const std::string shape : {"cube", "sphere", "segment"}) {
    const ProgramResult result =
        runProgram(kSmallEvaluation + std::string("--cameras di --cell 4in --cell-shape ") + shape + " --json -");
    ASSERT_EQ(result.exitCode, 0) << result.error;
    EXPECT_EQ(nlohmann::json::parse(result.output)["cell"]["shape"], shape);
  }
}

TEST(Evaluate, WalksAlongTheEdgesOfACube) {
  const TemporaryFolder folder;
  const ProgramResult result =
      runProgram(kSmallEvaluation + std::string("--cameras di --edge-views 4 --json - --csv-sequences ") +
                 inQuotes(folder / "s.csv"));
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_EQ(json["cell"]["edge_views"], 4);
  ASSERT_EQ(json["representations"][0]["along_edges"].size(), 12u);
  EXPECT_EQ(json["representations"][0]["along_edges"][11]["missing_thick"].size(), 6u);
  const std::string csv = fileBytes(folder / "s.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 12 * 6);
}

TEST(Evaluate, RefusesWhatMakesNoCell) {
  for (const std::string arguments :
       {"--cell 0", "--cell 0in", "--cell -1in", "--cell-shape ball", "--segment-direction 0,0,0",
        "--segment-direction 1,2", "--runs 0", "--directions -1", "--edge-views -1",
        "--edge-views 2 --cell-shape sphere", "--size 0x5", "--cameras nothing", "--resume"}) {
    const TemporaryFolder folder;
    const ProgramResult result = runProgram(kSmallEvaluation + arguments + " --json " + inQuotes(folder / "x.json"));
    EXPECT_EQ(result.exitCode, 2) << arguments << result.error;
    EXPECT_THAT(result.error, HasSubstr("error"));
    EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << arguments;
  }
}

TEST(Evaluate, TakesASinglePixel) {
  const ProgramResult result = runProgram(
      "evaluate builtin:doors --size 1x1 --profile test --interior 1 --directions 1 --runs 1 --cameras di --json -");
  ASSERT_EQ(result.exitCode, 0) << result.error;
  EXPECT_EQ(nlohmann::json::parse(result.output)["representations"][0]["samples"], 1);
}

TEST(Evaluate, FailsEarlyWhereItCannotWrite) {
  const TemporaryFolder folder;
  const std::string file = inQuotes(folder.write("file", ""));
  for (const std::string& arguments :
       {"--json " + inQuotes(folder / "none/x.json"), "--page " + file, "--csv " + inQuotes(folder.path())}) {
    const ProgramResult result = runProgram(kSmallEvaluation + arguments);
    EXPECT_EQ(result.exitCode, 1) << arguments << result.error;
  }
}

// Ends it once the first representation is done. The others take much longer than the signal.
TEST(Evaluate, InterruptedKeepsWhatIsDoneAndGoesOn) {
  const TemporaryFolder folder;
  const std::string json = inQuotes(folder / "x.json");
  const std::string page = inQuotes(folder / "page");
  const std::string command =
      "evaluate builtin:doors --size 180x120 --profile test --interior 2 --directions 1 --runs 1 --cameras "
      "di,ddoc,ddoc-constant ";
  const ProgramResult first = runShell("\"$OCELLI\" " + command + "--json " + json + " --page " + page +
                                       " &\nprogram=$!\n"
                                       "while [ ! -e " +
                                       page +
                                       "/evaluation.work ] && kill -0 $program 2>/dev/null; do sleep 0.01; done\n"
                                       "kill -TERM $program\nwait $program");
  ASSERT_EQ(first.exitCode, 1) << first.error;
  EXPECT_THAT(first.error, HasSubstr("interrupted with"));
  EXPECT_THAT(first.error, HasSubstr("of 3 representations done"));
  const auto partial = nlohmann::json::parse(fileBytes(folder / "x.json"));
  EXPECT_EQ(partial["complete"], false);
  const size_t done = partial["representations"].size();
  EXPECT_GE(done, 1u);
  EXPECT_LT(done, 3u);
  EXPECT_THAT(fileBytes(folder / "page/index.html"), HasSubstr("was interrupted"));

  const ProgramResult second = runProgram(command + "--json " + json + " --page " + page);
  ASSERT_EQ(second.exitCode, 0) << second.error;
  EXPECT_THAT(second.error, HasSubstr("going on with"));
  EXPECT_FALSE(std::filesystem::exists(folder / "page/evaluation.work"));
  EXPECT_THAT(fileBytes(folder / "page/index.html"), Not(HasSubstr("was interrupted")));
  const std::string resumed = fileBytes(folder / "x.json");

  const ProgramResult whole = runProgram(command + "--json -");
  ASSERT_EQ(whole.exitCode, 0) << whole.error;
  EXPECT_EQ(timeless(resumed), timeless(whole.output));
  // What was finished was not done again: even its times are the same.
  EXPECT_EQ(nlohmann::json::parse(resumed)["representations"][0], partial["representations"][0]);
}

TEST(Evaluate, StaleAndBrokenWorkFilesAreNotUsed) {
  const TemporaryFolder folder;
  const std::string command = kSmallEvaluation + std::string("--cameras di --json ") + inQuotes(folder / "x.json");
  for (const std::string bytes : {"", "{", R"({"format": 1, "key": "another", "representations": []})"}) {
    folder.write("x.json.work", bytes);
    const ProgramResult asked = runProgram(command + " --resume");
    EXPECT_EQ(asked.exitCode, 2) << bytes;
    EXPECT_THAT(asked.error, HasSubstr("x.json.work"));
    EXPECT_TRUE(std::filesystem::exists(folder / "x.json.work")) << "it may be of use to another command";
    const ProgramResult result = runProgram(command);
    EXPECT_EQ(result.exitCode, 0) << result.error;
    EXPECT_THAT(result.error, HasSubstr("starting again"));
    EXPECT_FALSE(std::filesystem::exists(folder / "x.json.work"));
    folder.write("x.json.work", bytes);
    const ProgramResult again = runProgram(command + " --no-resume");
    EXPECT_EQ(again.exitCode, 0) << again.error;
    EXPECT_THAT(again.error, Not(HasSubstr("starting again")));
  }
}

}  // namespace
}  // namespace ocelli::test
