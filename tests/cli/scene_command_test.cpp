// `ocelli scene` from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "oc_core/scene/ply_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(SceneList, ShowsEverySceneAndParameter) {
  const ProgramResult result = runProgram("scene list");
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_THAT(result.output, AllOf(HasSubstr("builtin:teapot"), HasSubstr("builtin:fence"), HasSubstr("gap=4")));
  const ProgramResult json = runProgram("scene list --json");
  EXPECT_EQ(json.exitCode, 0);
  EXPECT_GE(nlohmann::json::parse(json.output).size(), 6u);
}

TEST(SceneInfo, CountsTheFittedScene) {
  const ProgramResult result = runProgram("scene info builtin:box,turn=0,tilt=0 --json");
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const auto info = nlohmann::json::parse(result.output);
  EXPECT_EQ(info["triangles"], 12);
  EXPECT_NEAR(info["upper"][0].get<double>(), 0.57735, 1e-5);  // a corner of the cube on the unit sphere
  EXPECT_THAT(runProgram("scene info builtin:box").output, HasSubstr("triangles  12"));
}

TEST(SceneInfo, TellsOfPoints) {
  const TemporaryFolder folder;
  std::string text;
  for (int i = 0; i < 100; ++i) {
    text += std::to_string(i % 10) + " " + std::to_string(i / 10) + " 0\n";
  }
  const std::string path = folder.write("grid.xyz", text).string();
  const ProgramResult result = runProgram("scene info " + path + " --json");
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const auto info = nlohmann::json::parse(result.output);
  EXPECT_EQ(info["triangles"], 200);
  EXPECT_EQ(info["triangles_in_file"], 0);
  EXPECT_EQ(info["points"]["in_file"], 100);
  EXPECT_EQ(info["points"]["panels"], 100);
  EXPECT_TRUE(info["points"]["widths_from_neighbors"]);
  EXPECT_NEAR(info["points"]["median_width"].get<double>(), 1.15, 1e-4);
  EXPECT_THAT(runProgram("scene info " + path + " --point-size 0.25").output,
              AllOf(HasSubstr("points     100: 100 flat panels"), HasSubstr("width      0.25\n")));
  EXPECT_THAT(runProgram("scene info " + path + " --point-size auto").output, HasSubstr("from the neighbours"));
  for (const char* bad : {"0", "-1", "nan", "inf", "1,2", "''"}) {
    EXPECT_EQ(runProgram("scene info " + path + " --point-size " + bad).exitCode, 2) << bad;
  }
  const ProgramResult noPoints = runProgram("scene info builtin:box --point-size 1");
  EXPECT_EQ(noPoints.exitCode, 2);
  EXPECT_THAT(noPoints.error, HasSubstr("--point-size"));
}

TEST(SceneExport, WritesTheMeshAndSaysSo) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a b.ply").string();
  const ProgramResult result = runProgram("scene export builtin:teapot,segments=4 -o '" + path + "'");
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_THAT(result.output, IsEmpty());
  EXPECT_THAT(result.error, AllOf(HasSubstr("wrote"), HasSubstr(path)));
  EXPECT_EQ(readPly(path).triangles.size(), 992u);  // 32 patches of 32 triangles, less 8 degenerate rows of 4
}

TEST(SceneCommand, ExitCodesTellWhoseFaultItIs) {
  EXPECT_EQ(runProgram("scene").exitCode, 2);
  EXPECT_EQ(runProgram("scene info").exitCode, 2);
  EXPECT_EQ(runProgram("scene info /no/such/file.ply").exitCode, 2);
  EXPECT_EQ(runProgram("scene info builtin:castle").exitCode, 2);
  EXPECT_EQ(runProgram("scene info builtin:box --time 1").exitCode, 2);
  EXPECT_EQ(runProgram("scene export builtin:box").exitCode, 2);
  const ProgramResult unwritable = runProgram("scene export builtin:box -o /no/such/folder/x.ply");
  EXPECT_EQ(unwritable.exitCode, 1);
  EXPECT_THAT(unwritable.error, AllOf(HasSubstr("/no/such/folder/x.ply"), HasSubstr("try:")));
}

}  // namespace
}  // namespace ocelli::test
