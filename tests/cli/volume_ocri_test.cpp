// Reference images of volumes, and surfaces of volumes, from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "oc_core/isosurface/isosurface.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

constexpr const char* kVolume = "builtin:volume,name=marschner-lobb,size=32";

TEST(VolumeOcri, ReferenceImagesOfVolumesBecomeMeshes) {
  const TemporaryFolder folder;
  const std::string image = inQuotes(folder / "a.exr");
  for (const char* camera : {"ddoc", "ldi-2"}) {
    const ProgramResult built = runProgram(std::string("ocri build ") + kVolume +
                                           " --size 60x40 --opacity 0.4 --camera " + camera + " -o " + image);
    ASSERT_EQ(built.exitCode, 0) << built.error;
    EXPECT_THAT(built.error, HasSubstr("32 x 32 x 32 voxels, first hits at an opacity of 0.4"));
    EXPECT_THAT(built.error, HasSubstr(camera));
    const ProgramResult meshed = runProgram("ocri mesh " + image + " -o " + inQuotes(folder / "a.ply"));
    ASSERT_EQ(meshed.exitCode, 0) << meshed.error;
    EXPECT_THAT(meshed.error, HasSubstr(" triangles"));
  }
}

TEST(VolumeOcri, EvaluationMeasuresVolumesAndGoesOnWhereItWas) {
  const TemporaryFolder folder;
  const std::string command = std::string("evaluate ") + kVolume +
                              " --size 60x40 --profile test --interior 1 --directions 0 --runs 1 --cameras ";
  const ProgramResult result = runProgram(command + "di,ddoc --json - --page " + inQuotes(folder / "page"));
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const nlohmann::json json = nlohmann::json::parse(result.output);
  ASSERT_EQ(json["representations"].size(), 2u);
  EXPECT_GT(json["representations"][0]["triangles"], 100);
  EXPECT_THAT(fileBytes(folder / "page" / "index.html"), HasSubstr("32 x 32 x 32 voxels"));
  EXPECT_THAT(runProgram(command + "geometry").error, HasSubstr("--iso VALUE"));
}

TEST(VolumeOcri, ErrorsSayWhatToDo) {
  const TemporaryFolder folder;
  const auto errorOf = [&](const std::string& arguments) {
    const ProgramResult result =
        runProgram("ocri build " + arguments + " --size 60x40 -o " + inQuotes(folder / "b.exr"));
    EXPECT_EQ(result.exitCode, 2);
    return result.error;
  };
  const std::string volume = kVolume;
  EXPECT_THAT(errorOf(volume + " --construction gl"), HasSubstr("constructed by rays"));
  EXPECT_THAT(errorOf(volume + " --camera comprehensive"), HasSubstr("ocelli render"));
  EXPECT_THAT(errorOf(volume + " --opacity 1.5"), HasSubstr("--opacity"));
  EXPECT_THAT(errorOf("builtin:teapot --opacity 0.5"), HasSubstr("for volumes alone"));
  EXPECT_THAT(errorOf("builtin:teapot --iso 0.5"), HasSubstr("no volume"));
}

TEST(VolumeOcri, SurfacesAreScenesOfEveryCommand) {
  if (!canExtractIsosurfaces()) {
    GTEST_SKIP() << "this build has no isosurfaces";
  }
  const TemporaryFolder folder;
  const std::string volume = kVolume;
  const ProgramResult exported = runProgram("scene export " + volume + " --iso 0.5 -o " + inQuotes(folder / "a.ply"));
  EXPECT_EQ(exported.exitCode, 0) << exported.error;
  const ProgramResult built =
      runProgram("ocri build " + volume + " --iso 0.5 --size 60x40 -o " + inQuotes(folder / "a.exr"));
  EXPECT_EQ(built.exitCode, 0) << built.error;
  EXPECT_THAT(built.error, HasSubstr("by rasterisation"));
  const ProgramResult outside = runProgram("scene export " + volume + " --iso 7 -o " + inQuotes(folder / "b.ply"));
  EXPECT_EQ(outside.exitCode, 2);
  EXPECT_THAT(outside.error, HasSubstr("its values run from"));
}

}  // namespace
}  // namespace ocelli::test
