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
