// `ocelli camera`, and `ocelli render` with its cameras, from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "oc_core/image/png_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class CameraCommand : public testing::Test {
 protected:
  CameraCommand() {
    folder_.write("cross.json", R"({"camera": "graph", "operations": [
      {"operation": "split", "of": "root", "into": [
        {"name": "left", "plane": {"point": [0, 0, 0.5], "normal": [-0.3, 0, -1]}, "viewpoint": [1.5, 0, 7]},
        {"name": "right", "plane": {"point": [0, 0, 0.5], "normal": [0.3, 0, -1]}, "viewpoint": [-1.5, 0, 7]}]}]})");
    folder_.write("edits.jsonl", R"({"edit": "remove", "name": "left"}

{"edit": "undo"}
{"edit": "rename", "name": "left", "to": "west"}
)");
  }
  std::string path(const std::string& name) const {
    std::string quoted("'");
    quoted += (folder_ / name).string();
    return quoted += '\'';
  }
  std::string bytes(const std::string& name) const { return fileBytes(folder_ / name); }

  TemporaryFolder folder_;
};

TEST_F(CameraCommand, listNamesEveryConstructor) {
  const ProgramResult result = runProgram("camera list");
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_THAT(result.output, AllOf(HasSubstr("graph "), HasSubstr("curved "), HasSubstr("comprehensive ")));
  EXPECT_THAT(result.output, AllOf(HasSubstr("panorama "), HasSubstr("eoc-h ")));
}

TEST_F(CameraCommand, listOfOneTellsItsOptions) {
  const ProgramResult result = runProgram("camera list ddoc");
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_THAT(result.output, AllOf(HasSubstr("\"camera\": \"ddoc\""), HasSubstr("safety_factor"), HasSubstr(" to ")));
  EXPECT_THAT(runProgram("camera list di").output, HasSubstr("no options"));
  const ProgramResult unknown = runProgram("camera list nosuch");
  EXPECT_EQ(unknown.exitCode, 2);
  EXPECT_THAT(unknown.error, HasSubstr("nosuch"));
}

TEST_F(CameraCommand, showDrawsAPlan) {
  for (const std::string ending : {"svg", "png"}) {
    const ProgramResult result =
        runProgram("camera show builtin:boxes --camera " + path("cross.json") +
                   " --from front --cut 0.1 --rays 9 --pixels 200 -o " + path("plan." + ending));
    EXPECT_EQ(result.exitCode, 0) << result.error;
    EXPECT_THAT(result.error, HasSubstr("3 parts of the camera, 9 rays"));
  }
  EXPECT_THAT(bytes("plan.svg"), HasSubstr("</svg>"));
  EXPECT_GT(readPng(folder_ / "plan.png").width(), 200);
}

TEST_F(CameraCommand, infoDescribesAndWritesTheCamera) {
  const std::string command = "camera info builtin:maze,rows=3,columns=3 --camera comprehensive --json -o ";
  const ProgramResult result = runProgram(command + path("maze.json"));
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const auto info = nlohmann::json::parse(result.output);
  EXPECT_EQ(info["camera"], "graph");
  EXPECT_EQ(info["frusta"][0]["name"], "root");
  EXPECT_GT(info["frusta"].size(), 3u);
  EXPECT_TRUE(info["overlaps"].empty());
  // What it wrote is the same camera.
  const auto again = runProgram("camera info builtin:maze,rows=3,columns=3 --json --camera " + path("maze.json"));
  ASSERT_EQ(again.exitCode, 0) << again.error;
  EXPECT_EQ(nlohmann::json::parse(again.output), info);
}

TEST_F(CameraCommand, editsFromAFileEndAtTheFirstError) {
  const std::string command = "camera edit builtin:box --camera " + path("cross.json") + " --image " +
                              path("live.png") + " -o " + path("out.json");
  ProgramResult result = runProgram(command + " --edits " + path("edits.jsonl"));
  EXPECT_EQ(result.exitCode, 0) << result.error;
  EXPECT_THAT(bytes("out.json"), AllOf(HasSubstr("\"west\""), HasSubstr("\"right\""), Not(HasSubstr("\"left\""))));
  EXPECT_EQ(readPng(folder_ / "live.png").width(), 1280);
  folder_.write("bad.jsonl", "{\"edit\": \"undo\"}\n");
  result = runProgram(command + " --edits " + path("bad.jsonl"));
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.error, AllOf(HasSubstr("bad.jsonl, line 1"), HasSubstr("nothing to undo")));
  EXPECT_EQ(runProgram(command + " --edits /no/such/file").exitCode, 2);
}

TEST_F(CameraCommand, editsFromAProgramAreAnsweredOneByOne) {
  const ProgramResult result = runShell(
      "printf '{\"edit\": \"undo\"}\\n{\"edit\": \"remove\", \"name\": \"left\"}\\n' | \"$OCELLI\" camera edit "
      "builtin:box --size 90x60 --camera " +
      path("cross.json") + " -o " + path("out.json"));
  EXPECT_EQ(result.exitCode, 0) << result.error;
  EXPECT_THAT(result.output, AllOf(HasSubstr("\"line\":1"), HasSubstr("nothing to undo")));
  EXPECT_THAT(result.output, HasSubstr("{\"done\":true,\"line\":2}"));
  EXPECT_THAT(bytes("out.json"), Not(HasSubstr("\"left\"")));
}

TEST_F(CameraCommand, renderWritesImagesAndObjects) {
  const std::string command = "render builtin:boxes --size 180x120 --camera " + path("cross.json");
  EXPECT_EQ(runProgram(command + " --identity " + path("objects.png") + " -o " + path("a.png")).exitCode, 0);
  EXPECT_EQ(runProgram(command + " --method raycast -o " + path("b.png")).exitCode, 0);
  EXPECT_EQ(runProgram(command + " -o " + path("c.exr")).exitCode, 0);
  const Image<Rgb8> raster = readPng(folder_ / "a.png");
  const Image<Rgb8> cast = readPng(folder_ / "b.png");
  size_t differing = 0;
  for (size_t i = 0; i < raster.size(); ++i) {
    differing += raster[i] != cast[i];
  }
  EXPECT_LE(differing, raster.size() / 200);
  EXPECT_EQ(readPng(folder_ / "objects.png").width(), 180);
  EXPECT_THAT(bytes("c.exr"), HasSubstr("\"operations\""));
  EXPECT_THAT(runProgram("ocri mesh " + path("c.exr") + " -o " + path("c.ply")).exitCode, 2);
}

TEST_F(CameraCommand, compareMakesAPageOfAllWaysToShowFoci) {
  folder_.write("lenses.json", R"({"camera": "gpc", "regions": [
    {"center": [0.3, 0.5], "extent": [0.2, 0.3], "zoom": 3, "transition_width": 0.6}]})");
  const std::string command = "camera compare builtin:teapot --size 160x90 --runs 1 --camera ";
  const ProgramResult result =
      runProgram(command + path("lenses.json") + " -o " + path("focus") + " --json " + path("focus.json"));
  ASSERT_EQ(result.exitCode, 0) << result.error;
  EXPECT_THAT(result.output, AllOf(HasSubstr("fisheye"), HasSubstr("context hidden, %")));
  const std::string page = bytes("focus/index.html");
  for (const std::string way : {"gpc", "fisheye", "inset", "plain"}) {
    for (const std::string ending : {".png", "-rates.png", "-kept.png"}) {
      EXPECT_THAT(page, HasSubstr("\"" + way + ending + "\""));
      EXPECT_EQ(readPng(folder_ / ("focus/" + way + ending)).width(), 160);
    }
    EXPECT_THAT(bytes("focus.json"), HasSubstr("\"way\": \"" + way + "\""));
  }
  const ProgramResult json = runProgram(command + "gpc -o " + path("focus") + " --json");
  EXPECT_EQ(json.exitCode, 0) << json.error;
  EXPECT_THAT(json.output, AllOf(HasSubstr("\"hidden_share\": "), HasSubstr("\"raster_milliseconds\": null")));
}

TEST_F(CameraCommand, filesSayTheSizeOfTheirImages) {
  ASSERT_EQ(runProgram("camera info builtin:box --camera " + path("cross.json") + " -o " + path("sized.json")).exitCode,
            0);
  ASSERT_EQ(runProgram("render builtin:box --camera " + path("sized.json") + " -o " + path("sized.png")).exitCode, 0);
  EXPECT_EQ(readPng(folder_ / "sized.png").width(), 1280);
  const ProgramResult other =
      runProgram("render builtin:box --size 720x480 --camera " + path("sized.json") + " -o " + path("sized.png"));
  EXPECT_EQ(other.exitCode, 2);
  EXPECT_THAT(other.error, HasSubstr("1280x720, not 720x480"));
}

TEST_F(CameraCommand, errorsSayWhatToDo) {
  const std::string png = " -o " + path("x.png");
  folder_.write("out.json", R"({"camera": "gpc", "regions": [{"zoom": 0.9}]})");
  folder_.write("wall.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
  folder_.write("away.json", R"({"eye": [0, 0, 10], "target": [0, 0, 20], "fov_vertical_degrees": 20})");
  for (const auto& [arguments, message] : std::vector<std::pair<std::string, std::string>>{
           {"camera show builtin:box --camera nothing", "no camera \"nothing\"\n  try: use gpc, graph, curved"},
           {"camera show builtin:box --camera /no/such.json", "/no/such.json"},
           {"camera show builtin:box --camera ddoc", "use gpc, graph, curved"},
           {"camera show builtin:box --camera graph", "--camera FILE.json"},
           {"camera show builtin:box --cut nan --camera " + path("cross.json"), "--cut"},
           {"camera edit builtin:box --edits /tmp --camera " + path("cross.json") + " -o " + path("e.json"), "/tmp"},
           {"render builtin:box --identity " + path("x.png") + " --camera " + path("cross.json"), "both would go into"},
           {"camera show " + path("wall.obj") + " --camera comprehensive", "no floor"},
           {"camera show builtin:house --camera maze", "no walkable floor below"},
           {"camera compare builtin:box --camera ddoc -o " + path("focus"), "no regions of detail"},
           {"camera compare builtin:box --camera " + path("out.json") + " -o " + path("focus"), "zoom by more than 1"},
           {"camera compare builtin:box --camera gpc --view " + path("away.json") + " -o " + path("focus"), "view"},
           {"render builtin:box --camera ddoc --identity " + path("i.png"), "only graph and curved"},
           {"render builtin:box --method points --camera " + path("cross.json"), "use raster, raycast or gl"}}) {
    const ProgramResult result = runProgram(arguments + (arguments.find(" -o ") == std::string::npos ? png : ""));
    EXPECT_EQ(result.exitCode, 2) << arguments;
    EXPECT_THAT(result.error, AllOf(HasSubstr(message), HasSubstr("try:"))) << arguments;
  }
}

// A reference image of any camera goes the whole way: mesh, slices, and what an observer sees.
TEST_F(CameraCommand, imagesOfEveryCameraBecomeMeshesAndVolumes) {
  folder_.write("street.json",
                R"({"eye": [0, 2.5, 40], "target": [0, 2.5, 0], "z_near": 0.1, "fov_vertical_degrees": 60})");
  const std::string street = "builtin:town --no-fit --view " + path("street.json");
  for (const std::string& scene : {street + " --camera panorama", street + " --camera cylinder",
                                   std::string("builtin:maze --camera comprehensive"),
                                   std::string("builtin:maze --camera comprehensive --construction rays")}) {
    SCOPED_TRACE(scene);
    const ProgramResult built = runProgram("ocri build " + scene + " --size 120x60 --json -o " + path("a.exr"));
    ASSERT_EQ(built.exitCode, 0) << built.error;
    const auto figures = nlohmann::json::parse(built.output);
    EXPECT_EQ(figures["images"].at(0)["width"], 120);
    EXPECT_THAT(built.error, HasSubstr(" " + figures["samples"].dump() + " samples"));
    EXPECT_THAT(built.error, HasSubstr(" of 120x60, "));
    const ProgramResult meshed =
        runProgram("ocri mesh " + path("a.exr") + " --json " + path("a.json") + " -o " + path("a.ply"));
    ASSERT_EQ(meshed.exitCode, 0) << meshed.error;
    EXPECT_THAT(meshed.error,
                HasSubstr(" " + nlohmann::json::parse(bytes("a.json"))["triangles"].dump() + " triangles"));
    const ProgramResult sliced = runProgram("slice " + path("a.exr") + " --profile test -o " + path("a.svol"));
    ASSERT_EQ(sliced.exitCode, 0) << sliced.error;
    EXPECT_EQ(runProgram("observe " + path("a.svol") + " --size 60x40 -o " + path("a.png")).exitCode, 0);
    const Image<Rgb8> seen = readPng(folder_ / "a.png");
    EXPECT_GT(std::count_if(seen.begin(), seen.end(), [](const Rgb8& each) { return each != Rgb8{}; }), 20);
  }
  const auto errorOf = [&](const std::string& arguments) {
    return runProgram("ocri build " + arguments + " --size 12x6 -o " + path("b.exr")).error;
  };
  EXPECT_THAT(errorOf("builtin:maze --camera comprehensive --viewers 2"), HasSubstr("made for one viewer"));
  EXPECT_THAT(errorOf("builtin:maze --camera comprehensive --construction gl"), HasSubstr("use auto, raster or rays"));
  folder_.write("wall.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
  EXPECT_THAT(errorOf(path("wall.obj") + " --camera comprehensive"), HasSubstr("no floor"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "b.exr"));
}

}  // namespace
}  // namespace ocelli::test
