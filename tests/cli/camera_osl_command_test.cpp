// `ocelli camera osl`. That the rays of shaders are those of cameras: tests/camera_shader.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "oc_core/image/exr_reader.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class CameraOslCommand : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return inQuotes(folder_ / name); }
  static std::string run(const std::string& arguments) {
    const ProgramResult result = runProgram("camera osl " + arguments);
    EXPECT_EQ(result.exitCode, 0) << arguments << ": " << result.error;
    return result.output + result.error;
  }
  static std::string refusal(const std::string& arguments) {
    const ProgramResult result = runProgram("camera osl " + arguments);
    EXPECT_EQ(result.exitCode, 2) << arguments << ": " << result.output << result.error;
    return result.error;
  }
  std::string text(const std::string& name) const { return fileBytes(folder_ / name); }
  bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }

  TemporaryFolder folder_;
};

const std::string kFewBoxes = "--scene builtin:boxes,count=40 --size 60x40 ";

TEST_F(CameraOslCommand, formulasNeedNoOtherFile) {
  EXPECT_THAT(run("panorama --size 64x32 -o " + path("panorama.osl")), HasSubstr("computes the rays"));
  EXPECT_THAT(text("panorama.osl"), AllOf(HasSubstr("shader ocelli_panorama("), HasSubstr("float width = 64.0;"),
                                          Not(HasSubstr("texture("))));
  EXPECT_FALSE(exists("panorama_rays.exr"));
  const std::string camera = folder_.write("two.json", R"({"camera": "gpc", "sampling": "linear", "regions": [
      {"center": [0.25, 0.5], "extent": [0.1, 0.1], "zoom": 3, "transition_width": 1},
      {"center": [0.75, 0.5], "extent": [0.1, 0.1], "zoom": 2, "transition_width": 1}]})");
  run(inQuotes(camera) + " -o " + path("two.osl"));
  EXPECT_THAT(text("two.osl"), AllOf(HasSubstr("int regions = 2;"), HasSubstr("float zoom[2] = {3.0, 2.0};")));
  EXPECT_THAT(run("di --size 60x40 -o /dev/stdout"), HasSubstr("shader ocelli_di("));
}

TEST_F(CameraOslCommand, otherCamerasReadATexture) {
  EXPECT_THAT(run("rppc " + kFewBoxes + "-o " + path("rppc.osl")), HasSubstr("rppc_rays.exr"));
  EXPECT_THAT(text("rppc.osl"), HasSubstr("string rays = \"" + (folder_ / "rppc_rays.exr").string() + "\""));
  const ExrPartHeader header = exrHeaders(text("rppc_rays.exr"), 1).front();
  EXPECT_EQ(header.width, 60);
  EXPECT_EQ(header.height, 80);
  EXPECT_NE(header.find("R"), nullptr);

  run("di --lookup --size 60x40 --texture " + path("rays.exr") + " -o " + path("di.osl"));
  EXPECT_THAT(text("di.osl"), HasSubstr((folder_ / "rays.exr").string()));
  const std::string map = "camera rays di --size 60x40 -o " + path("di.exr");
  EXPECT_EQ(runProgram(map).exitCode, 0);
  run(path("di.exr") + " --texture " + path("of_map.exr") + " -o " + path("of_map.osl"));
  EXPECT_EQ(text("of_map.exr").size(), text("rays.exr").size()) << "a ray map is a camera too";
}

TEST_F(CameraOslCommand, refusesWhatNoShaderIs) {
  EXPECT_THAT(refusal("ddoc " + kFewBoxes + "-o " + path("x.osl")),
              AllOf(HasSubstr("camera \"ddoc\""), HasSubstr("rays bend"), HasSubstr("one straight ray a pixel")));
  EXPECT_THAT(refusal("comprehensive --scene builtin:maze,rows=3,columns=3 --size 60x40 -o " + path("x.osl")),
              HasSubstr("rays bend"));
  EXPECT_THAT(refusal("cell -o " + path("x.osl")), HasSubstr("--scene"));
  EXPECT_THAT(refusal("simplified " + kFewBoxes + "-o " + path("x.osl")), HasSubstr("is a mesh"));
  EXPECT_THAT(refusal("nosuch -o " + path("x.osl")), HasSubstr("nosuch"));
  EXPECT_THAT(refusal("di -o " + path("x.txt")), HasSubstr(".osl"));
  EXPECT_THAT(refusal("di --texture " + path("x.exr") + " -o " + path("x.osl")), HasSubstr("--lookup"));
  EXPECT_THAT(refusal("di --image 2 -o " + path("x.osl")), HasSubstr("has one image"));
  EXPECT_THAT(refusal("di --lookup --size 60x40 -o /dev/stdout"), HasSubstr("--texture"));
  EXPECT_FALSE(exists("x.osl"));
  EXPECT_FALSE(exists("x_rays.exr"));
}

}  // namespace
}  // namespace ocelli::test
