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
