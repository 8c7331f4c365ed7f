// `ocelli render --antialias`, run as users run it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/image/png_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

TEST(AntialiasCommand, drawsEveryWay) {
  const TemporaryFolder folder;
  for (const std::string way : {"msaa-16", "uniform-4", "area-16", "extreme,tile=200x200", "extreme,regions=objects"}) {
    const std::string file = (folder / "image.png").string();
    const ProgramResult result =
        runProgram("render builtin:particles,count=500 --size 90x60 --antialias " + way + " -o " + file);
    EXPECT_EQ(result.exitCode, 0) << way << result.error;
    EXPECT_THAT(result.error + result.output, HasSubstr("with " + way));
    EXPECT_EQ(readPng(file).width(), 90);
    EXPECT_EQ(result.error.find("region of") != std::string::npos, way.starts_with("extreme")) << result.error;
  }
}

TEST(AntialiasCommand, castsRaysOfOtherCameras) {
  const TemporaryFolder folder;
  for (const std::string camera : {"ddoc", "gpc --method raycast", "portal"}) {
    const std::string scene = camera == "portal" ? "builtin:maze" : "builtin:teapot";
    const ProgramResult result =
        runProgram("render " + scene + " --camera " + camera + " --size 45x30 --antialias uniform-4 -o " +
                   (folder / "image.png").string());
    EXPECT_EQ(result.exitCode, 0) << camera << result.error;
  }
}

TEST(AntialiasCommand, seesABlackSurfaceButNotNothing) {
  const TemporaryFolder folder;
  const std::string black =
      folder
          .write("black.ply",
                 "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                 "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n"
                 "property list uchar int vertex_indices\nend_header\n"
                 "-1 -1 0 0 0 0\n1 -1 0 0 0 0\n0 1 0 0 0 0\n3 0 1 2\n")
          .string();
  const std::string away = folder.write("away.json", R"({"eye": [0, 0, 10], "target": [0, 0, 20]})").string();
  const std::string rest = " --size 45x30 -o " + (folder / "image.png").string() + " --antialias ";
  for (const std::string& way : {black + rest + "area-16", black + rest + "uniform-4 --method raycast",
                                 "builtin:maze" + rest + "uniform-4 --camera portal"}) {
    EXPECT_EQ(runProgram("render " + way).exitCode, 0) << way;
    const ProgramResult result = runProgram("render " + way + " --view " + away);
    EXPECT_EQ(result.exitCode, 2) << way;
    EXPECT_THAT(result.error, HasSubstr("the view sees nothing of the scene")) << way;
  }
  EXPECT_THAT(runProgram("render " + black + rest + "extreme,regions=objects").error, HasSubstr("use regions=auto"));
  EXPECT_THAT(runProgram("render " + black + rest + "extreme,dense=1000").error,
              HasSubstr("all is drawn with area-16"));
}

TEST(AntialiasCommand, refusesWhatDoesNotGoTogether) {
  const TemporaryFolder folder;
  const auto errorOf = [&](const std::string& rest) {
    const ProgramResult result = runProgram("render builtin:teapot --size 45x30 " + rest);
    EXPECT_EQ(result.exitCode, 2) << rest;
    return result.error;
  };
  const std::string png = " -o " + (folder / "image.png").string();
  EXPECT_THAT(errorOf("--antialias msaa-3" + png), HasSubstr("2, 4, 8 or 16"));
  EXPECT_THAT(errorOf("--antialias area-4 -o " + (folder / "image.exr").string()), HasSubstr("has no depth"));
  EXPECT_THAT(errorOf("--antialias area-4 --method points" + png), HasSubstr("use raster or raycast"));
  EXPECT_THAT(errorOf("--antialias area-4 --method raycast" + png), HasSubstr("use uniform-N"));
  EXPECT_THAT(errorOf("--antialias extreme --camera spoc" + png), HasSubstr("use uniform-N"));
}

}  // namespace
}  // namespace ocelli::test
