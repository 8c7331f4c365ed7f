// Several viewers from outside: `ocelli viewers`, and `ocelli ocri build --viewers`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

const std::string kSmallViewers = "viewers builtin:doors --size 90x60 --cell 4in --interior 1 ";

TEST(Viewers, AreMeasuredOneByOne) {
  const TemporaryFolder folder;
  const std::string file = (folder / "x.json").string();
  const ProgramResult result = runProgram(kSmallViewers + "--viewers 3 --json '" + file + "'");
  ASSERT_EQ(result.exitCode, 0) << result.error;
  EXPECT_THAT(result.output, HasSubstr("3 viewers, ddoc"));
  const auto json = nlohmann::json::parse(fileBytes(file));
  ASSERT_EQ(json["viewers"].size(), 3u);
  EXPECT_EQ(json["viewers"][0]["samples_built"], json["viewers"][0]["samples_kept"]);
}

TEST(Viewers, ViewsMayBeFiles) {
  const TemporaryFolder folder;
  const std::string right = folder.write("right.json", R"({"eye": [10, 0, 0]})").string();
  const std::string left = folder.write("left.json", R"({"eye": [-10, 0, 0]})").string();
  const std::string views = "--view '" + right + "' --view '" + left + "' ";
  const ProgramResult result = runProgram(kSmallViewers + views + "--json");
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const auto json = nlohmann::json::parse(result.output);
  ASSERT_EQ(json["viewers"].size(), 2u);
  EXPECT_EQ(json["viewers"][1]["view"]["eye"], nlohmann::json::parse("[-10.0, 0.0, 0.0]"));
  EXPECT_EQ(runProgram(kSmallViewers + views + "--viewers 2").exitCode, 2);
}

// The same images as those that are measured; one file, one mesh, one volume.
TEST(Viewers, ImagesOfAllGoIntoOneFile) {
  const TemporaryFolder folder;
  const std::string image = (folder / "x.exr").string();
  const ProgramResult built =
      runProgram("ocri build builtin:doors --camera di --size 90x60 --viewers 2 -o '" + image + "'");
  ASSERT_EQ(built.exitCode, 0) << built.error;
  const auto measured = nlohmann::json::parse(runProgram(kSmallViewers + "--camera di --viewers 2 --json").output);
  const ProgramResult mesh = runProgram("ocri mesh '" + image + "' -o '" + (folder / "x.ply").string() + "'");
  ASSERT_EQ(mesh.exitCode, 0) << mesh.error;
  EXPECT_THAT(mesh.error, HasSubstr(std::to_string(measured["triangles"].get<size_t>()) + " triangles"));
  const ProgramResult sliced =
      runProgram("slice '" + image + "' --profile test --json -o '" + (folder / "x.svol").string() + "'");
  ASSERT_EQ(sliced.exitCode, 0) << sliced.error;
  EXPECT_EQ(nlohmann::json::parse(sliced.output)["triangles"], measured["triangles"]);
}

TEST(Viewers, RefusesWhatMakesNoViewers) {
  for (const std::string arguments :
       {"--viewers 0", "--viewers 13", "--viewers x", "--view missing.json", "--camera geometry", "--cell 0"}) {
    const ProgramResult result = runProgram(kSmallViewers + arguments);
    EXPECT_EQ(result.exitCode, 2) << arguments << result.error;
    EXPECT_EQ(result.output, "");
  }
}

}  // namespace
}  // namespace ocelli::test
