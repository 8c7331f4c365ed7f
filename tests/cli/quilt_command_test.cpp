// `ocelli quilt` from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "oc_core/image/png_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

class QuiltCommand : public testing::Test {
 protected:
  QuiltCommand() {
    folder_.write("small.json",
                  R"({"name": "small", "columns": 3, "rows": 2, "width": 240, "height": 160, "aspect": 1})");
    folder_.write("visual.json", R"({"pitch": {"value": 40}, "slope": {"value": -6}, "center": {"value": 0.2},
                                     "DPI": {"value": 300}, "screenW": {"value": 64}, "screenH": {"value": 48},
                                     "viewCone": {"value": 30}, "flipImageX": {"value": 1}})");
  }
  std::string path(const std::string& name) const { return inQuotes(folder_ / name); }
  ProgramResult quilt(const std::string& arguments) const {
    return runProgram("quilt " + arguments + " --display " + path("small.json"));
  }
  TemporaryFolder folder_;
};

TEST_F(QuiltCommand, writesAQuiltWhoseNameSaysWhatItIs) {
  const ProgramResult result = quilt("builtin:teapot -o " + path("teapot.png"));
  ASSERT_EQ(result.exitCode, 0) << result.error;
  EXPECT_THAT(result.error, HasSubstr("teapot_qs3x2a1.png: 6 views of 80x80 by eoc-h"));
  const Image<Rgb8> image = readPng(folder_ / "teapot_qs3x2a1.png");
  EXPECT_EQ(image.width(), 240);
  EXPECT_EQ(image.height(), 160);
  const auto lit = [&](int x, int y) { return image(x, y) != Rgb8(0); };
  for (int tile = 0; tile < 6; ++tile) {
    EXPECT_TRUE(lit(80 * (tile % 3) + 40, 80 * (tile / 3) + 40)) << tile;
  }
}

TEST_F(QuiltCommand, evaluatesAndPrintsJsonAlone) {
  const ProgramResult result = quilt("builtin:teapot --evaluate --json -o " + path("t.png"));
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_EQ(json["views"], 6);
  ASSERT_EQ(json["evaluation"].size(), 3u);
  EXPECT_EQ(json["evaluation"][0]["by"], "eoc-h");
  EXPECT_LT(json["evaluation"][0]["missing_strict"], json["evaluation"][2]["missing_strict"]);
  const ProgramResult render = quilt("builtin:teapot --by render --evaluate --json -o " + path("t.png"));
  EXPECT_EQ(nlohmann::json::parse(render.output)["evaluation"][0]["missing_strict"], 0);
  EXPECT_EQ(nlohmann::json::parse(render.output)["evaluation"][0]["flip"], 0);
}

TEST_F(QuiltCommand, writesThePanelAndThePairToo) {
  const ProgramResult result =
      quilt("builtin:teapot --calibration " + path("visual.json") + " --panel " + path("panel.png") + " --rgbd " +
            path("pair.png") + " --depth-side left -o " + path("t.png"));
  ASSERT_EQ(result.exitCode, 0) << result.error;
  EXPECT_THAT(result.error, HasSubstr("flipImageX"));
  EXPECT_EQ(readPng(folder_ / "panel.png").width(), 64);
  const Image<Rgb8> pair = readPng(folder_ / "pair.png");
  EXPECT_EQ(pair.width(), 160);
  EXPECT_EQ(pair(40, 40).r, pair(40, 40).b);  // depth, on the left
}

TEST_F(QuiltCommand, takesAReferenceImage) {
  const std::string image = path("eoc.exr");
  ASSERT_EQ(runProgram("ocri build builtin:teapot --camera eoc-h --size 80x80 -o " + image).exitCode, 0);
  const ProgramResult byRows = quilt(image + " --cone 5 -o " + path("rows.png"));
  ASSERT_EQ(byRows.exitCode, 0) << byRows.error;
  EXPECT_THAT(byRows.error, HasSubstr("by the rows of an image"));
  ASSERT_EQ(runProgram("ocri build builtin:teapot --camera di --size 90x60 -o " + image).exitCode, 0);
  const ProgramResult byMesh = quilt(image + " --cone 5 -o " + path("mesh.png"));
  ASSERT_EQ(byMesh.exitCode, 0) << byMesh.error;
  EXPECT_THAT(byMesh.error, AllOf(HasSubstr("not of an eoc-h"), HasSubstr("by the mesh of an image of di")));
}

TEST_F(QuiltCommand, refusesWhatMakesNoSense) {
  const auto refused = [&](const std::string& arguments, const std::string& message) {
    const ProgramResult result = runProgram("quilt builtin:teapot " + arguments);
    EXPECT_EQ(result.exitCode, 2) << arguments;
    EXPECT_THAT(result.error, HasSubstr(message)) << arguments;
  };
  const std::string output = " -o " + path("x.png");
  refused("--display huge" + output, "go, portrait, 16");
  refused("--by magic" + output, "eoc-h, render, rgbd");
  refused("--panel p.png" + output, "--calibration");
  refused("--depth-side behind" + output, "top, bottom, right, left");
  refused("-o " + path("x_qs11x6a0.5625.png"), "another quilt");
  refused("--seconds 2" + output, "--seconds");
  refused("-o " + path("x.mp4"), "stands still");
}

#ifdef OCELLI_WITH_OPENGL
/// Before a window opens.
TEST_F(QuiltCommand, aLightFieldDisplayRefusesOptionsOfOthers) {
  for (const std::string option : {"--turn 30", "--profile perspecta", "--tear", "--eyes udp:5005", "--camera ddoc"}) {
    const ProgramResult result = runProgram("present builtin:teapot --device quilt:portrait " + option);
    EXPECT_EQ(result.exitCode, 2) << option;
    EXPECT_THAT(result.error, HasSubstr("takes no " + option.substr(0, option.find(' ')))) << option;
  }
}
#endif

}  // namespace
}  // namespace ocelli::test
