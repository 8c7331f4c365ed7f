// `ocelli camera rays`, and ray maps wherever commands take cameras.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "oc_core/image/image_error.h"
#include "oc_core/image/png_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class RayMapCommand : public testing::Test {
 protected:
  /// In quotes.
  std::string path(const std::string& name) const { return inQuotes(folder_ / name); }
  /// Runs the program, which must succeed.
  std::string run(const std::string& arguments) const {
    const ProgramResult result = runProgram(arguments);
    EXPECT_EQ(result.exitCode, 0) << arguments << ": " << result.error;
    return result.output + result.error;
  }
  /// Runs the program, which must refuse its input.
  std::string refusal(const std::string& arguments) const {
    const ProgramResult result = runProgram(arguments);
    EXPECT_EQ(result.exitCode, 2) << arguments << ": " << result.output << result.error;
    return result.error;
  }
  size_t differingPixels(const std::string& a, const std::string& b) const {
    const Image<Rgb8> first = readPng(folder_ / a);
    const Image<Rgb8> second = readPng(folder_ / b);
    EXPECT_EQ(first.width(), second.width());
    EXPECT_EQ(first.height(), second.height());
    size_t differing = 0;
    for (size_t i = 0; i < first.size(); ++i) {
      differing += first[i] == second[i] ? 0 : 1;
    }
    return differing;
  }
  /// The rays of the example's Python script, which knows nothing of this program.
  void writeForeignMaps() const {
    const ProgramResult result =
        runShell("python3 -B '" OCELLI_SOURCE_DIR "/examples/ray_maps/write_ray_maps.py' " + path(""));
    ASSERT_EQ(result.exitCode, 0) << result.error;
  }

  TemporaryFolder folder_;
};

const std::string kBoxes = "builtin:boxes,count=40 ";

TEST_F(RayMapCommand, raysOfACameraDrawWhatTheCameraDraws) {
  run("camera rays ddoc --scene " + kBoxes + "--size 120x80 -o " + path("ddoc.exr"));
  run("render " + kBoxes + "--camera ddoc --method raycast --size 120x80 -o " + path("camera.png"));
  run("render " + kBoxes + "--camera " + path("ddoc.exr") + " -o " + path("rays.png"));
  // At edges, where rays of 32 bits pass by a hair on the other side; and where the camera's own projection has no
  // image of what its ray meets.
  EXPECT_LE(differingPixels("camera.png", "rays.png"), 20u) << "of 9600";
}

TEST_F(RayMapCommand, camerasOfTheViewAloneNeedNoScene) {
  const auto json =
      nlohmann::json::parse(runProgram("camera rays panorama --size 64x32 --json -o " + path("panorama.exr")).output);
  EXPECT_EQ(json["rays"], 64 * 32);
  EXPECT_EQ(json["bent"], 0);
  EXPECT_EQ(json["wraps_around"], true);
  EXPECT_THAT(refusal("camera rays ddoc -o " + path("x.exr")), AllOf(HasSubstr("--scene"), HasSubstr("ddoc")));
  EXPECT_THAT(refusal("camera rays comprehensive -o " + path("x.exr")), HasSubstr("--scene"));
  EXPECT_THAT(refusal("camera rays nosuch -o " + path("x.exr")), HasSubstr("nosuch"));
  EXPECT_THAT(refusal("camera rays eoc-hv --scene " + kBoxes + "--size 60x40 -o " + path("x.exr")),
              HasSubstr("--image, from 1 to 2"));
  run("camera rays eoc-hv --image 2 --scene " + kBoxes + "--size 60x40 -o " + path("x.exr"));
}

TEST_F(RayMapCommand, bentRaysAreToldByInfo) {
  run("camera rays comprehensive --scene builtin:maze,rows=3,columns=3 --size 90x60 -o " + path("maze.exr"));
  const auto json = nlohmann::json::parse(runProgram("camera info " + path("maze.exr") + " --json").output);
  EXPECT_EQ(json["camera"], "rays");
  EXPECT_EQ(json["name"], "comprehensive");
  EXPECT_GT(json["segments"], 2);
  EXPECT_GT(json["bent"], 90);
  EXPECT_EQ(json["frame"], "world");
  EXPECT_THAT(run("camera info " + path("maze.exr")), AllOf(HasSubstr("90x60"), HasSubstr("bent")));
  EXPECT_THAT(refusal("camera info builtin:maze"), HasSubstr("--camera"));
  run("render builtin:maze,rows=3,columns=3 --camera comprehensive --method raycast --size 90x60 -o " +
      path("camera.png"));
  run("render builtin:maze,rows=3,columns=3 --camera " + path("maze.exr") + " -o " + path("rays.png"));
}

TEST_F(RayMapCommand, camerasOfOtherProgramsWork) {
  writeForeignMaps();
  EXPECT_THAT(run("render builtin:town --camera " + path("push_broom.exr") + " -o " + path("town.png")),
              HasSubstr("push-broom of 720x360"));
  run("render builtin:statues --camera " + path("around.exr") + " --size 120x50 -o " + path("around.png"));
  EXPECT_EQ(readPng(folder_ / "around.png").width(), 120);
  const std::string fisheye = "--camera " + path("fisheye.exr") + " --size 60x60 ";
  run("render builtin:town " + fisheye + "--view '" OCELLI_SOURCE_DIR "/docs/cameras/examples/street_view.json' -o " +
      path("fisheye.png"));
  EXPECT_THAT(refusal("render builtin:town --camera " + path("push_broom.exr") +
                      " --view '" OCELLI_SOURCE_DIR "/docs/cameras/examples/street_view.json' -o " + path("x.png")),
              HasSubstr("stand in the world already"));
}

TEST_F(RayMapCommand, isACameraForOtherCommands) {
  run("camera rays di --size 60x40 -o " + path("di.exr"));
  const std::string camera = kBoxes + "--camera " + path("di.exr");
  run("ocri build " + camera + " -o " + path("image.exr"));
  run("ocri mesh " + path("image.exr") + " -o " + path("image.ply"));
  run("render " + camera + " --antialias uniform-4 -o " + path("smooth.png"));
  run("camera show " + camera + " -o " + path("plan.svg"));
  EXPECT_THAT(fileBytes(folder_ / "plan.svg"), HasSubstr("</svg>"));
  run("evaluate " + kBoxes + "--cameras di," + (folder_ / "di.exr").string() +
      " --size 60x40 --interior 1 --edge-views 0 --runs 1 --json " + path("found.json"));
  const auto found = nlohmann::json::parse(fileBytes(folder_ / "found.json"));
  EXPECT_THAT(found.dump(), HasSubstr("\"di\""));
  run("render builtin:volume,name=phantom --camera " + path("di.exr") + " -o " + path("volume.png"));
}

TEST_F(RayMapCommand, volumesGiveRaysToo) {
  run("camera rays di --scene builtin:volume,name=phantom --size 40x30 -o " + path("di.exr"));
  run("render builtin:volume,name=phantom --camera " + path("di.exr") + " -o " + path("rays.png"));
  run("render builtin:volume,name=phantom --camera di --size 40x30 -o " + path("camera.png"));
  EXPECT_LE(differingPixels("camera.png", "rays.png"), 12u) << "of 1200, by a level: rays are rounded once more";
}

TEST_F(RayMapCommand, whatARayMapCannotDoIsSaid) {
  run("camera rays di --size 60x40 -o " + path("di.exr"));
  const std::string camera = kBoxes + "--camera " + path("di.exr");
  EXPECT_THAT(refusal("render " + camera + " --method points -o " + path("x.png")), HasSubstr("ray casting"));
  EXPECT_THAT(refusal("render " + camera + " --method hybrid -o " + path("x.png")), HasSubstr("ray casting"));
  EXPECT_THAT(refusal("camera info " + path("nosuch.exr")), HasSubstr("nosuch.exr"));
  EXPECT_THAT(refusal("ocri build " + camera + " --viewers 2 -o " + path("x.exr")), HasSubstr("one viewer"));
  run("ocri build " + kBoxes + "--camera di --size 60x40 -o " + path("image.exr"));
  EXPECT_THAT(refusal("render " + kBoxes + "--camera " + path("image.exr") + " -o " + path("x.png")),
              HasSubstr("this is a reference image"));
  EXPECT_THAT(refusal("camera edit " + camera + " -o " + path("x.json")),
              AllOf(HasSubstr("a ray map is no list of operations or turns"), HasSubstr("--camera")));
  EXPECT_THAT(refusal("explore " + camera), AllOf(HasSubstr("no camera to walk with"), HasSubstr("ocelli render")));
  EXPECT_THAT(refusal("ocri mesh " + path("di.exr") + " -o " + path("x.ply")), HasSubstr("this is a ray map"));
}

/// What the command says before it has played a frame of the script.
TEST_F(RayMapCommand, tablesOfChangesMustBeWritableBeforeTheWalkBegins) {
  const ProgramResult result = runProgram("explore builtin:boxes,count=40 --offscreen '" OCELLI_SOURCE_DIR
                                          "/oc_core/explore/examples/town_walk.json' --changes " +
                                          path("nosuch/changes.csv") + " -o " + path("frames"));
  EXPECT_EQ(result.exitCode, 1) << result.error;
  EXPECT_THAT(result.error, HasSubstr("changes.csv"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "frames")) << "nothing was drawn";
}

}  // namespace
}  // namespace ocelli::test
