// What commands tell of scenes that show less than one may expect, and of files of other kinds.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

class SceneNotes : public testing::Test {
 protected:
  std::string at(const std::string& name) const { return fmt::format("'{}'", (folder_ / name).string()); }
  ProgramResult run(const std::string& arguments) const { return runProgram(arguments); }
  void writeTriangle(const char* name, const char* color, const char* coordinates = "0 0 0\n1 0 0\n0 1 0\n") const {
    std::string vertices;
    for (const char* line = coordinates; *line != '\0';) {
      const std::string_view rest = line;
      const size_t end = rest.find('\n');
      vertices += fmt::format("{} {}\n", rest.substr(0, end), color);
      line += end + 1;
    }
    folder_.write(name,
                  "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                  "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n"
                  "property list uchar int vertex_indices\nend_header\n" +
                      vertices + "3 0 1 2\n");
  }

  TemporaryFolder folder_;
};

TEST_F(SceneNotes, aBlackSceneIsToldByEveryCommandThatShowsIt) {
  writeTriangle("black.ply", "0 0 0");
  writeTriangle("grey.ply", "128 128 128");
  const std::string size = " --size 60x40 ";
  const std::vector<std::string> commands = {
      "render SCENE" + size + "-o " + at("x.png"), "ocri build SCENE" + size + "-o " + at("x.exr"),
      "slice SCENE --profile test -o " + at("x.svol"), "present SCENE --profile test --device null --seconds 0.1"};
  for (const std::string& command : commands) {
    const auto with = [&](const std::string& scene) {
      std::string whole = command;
      return run(whole.replace(whole.find("SCENE"), 5, at(scene)));
    };
    const ProgramResult black = with("black.ply");
    EXPECT_EQ(black.exitCode, 0) << command << black.error;
    EXPECT_THAT(black.error, HasSubstr("all of the scene is black")) << command;
    EXPECT_THAT(with("grey.ply").error, Not(HasSubstr("black"))) << command;
  }
  ASSERT_EQ(run("slice " + at("black.ply") + " --profile test -o " + at("dark.svol")).exitCode, 0);
  EXPECT_THAT(run("observe " + at("dark.svol") + size + "-o " + at("y.png")).error, HasSubstr("no voxel"));
  EXPECT_THAT(run("present " + at("dark.svol") + " --device null --seconds 0.1").error, HasSubstr("no voxel"));
}

TEST_F(SceneNotes, presentTellsOfWhatIsCutOffAsSliceDoes) {
  const std::string note = "lies outside of the display and is cut off";
  const std::string scene = " builtin:sphere --profile vortex ";
  EXPECT_THAT(run("slice" + scene + "-o " + at("x.svol")).error, HasSubstr(note));
  EXPECT_THAT(run("present" + scene + "--device null --seconds 0.1").error, HasSubstr(note));
  EXPECT_THAT(run("present builtin:teapot,segments=4 --profile test --device null --seconds 0.1").error,
              Not(HasSubstr(note)));
}

TEST_F(SceneNotes, anEmptyImageSaysWhyItIsEmpty) {
  writeTriangle("flat.ply", "255 255 255", "0 0 0\n1 0 0\n0 0 1\n");
  const std::string flat = "render " + at("flat.ply") + " --size 60x40 -o " + at("x.png");
  const ProgramResult edgeOn = run(flat);
  EXPECT_EQ(edgeOn.exitCode, 2);
  EXPECT_THAT(edgeOn.error, AllOf(HasSubstr("edge-on"), HasSubstr("out of its plane"), Not(HasSubstr("towards"))));
  folder_.write("above.json", R"({"eye": [0, 8, 6]})");
  EXPECT_EQ(run(flat + " --view " + at("above.json")).exitCode, 0);
  folder_.write("away.json", R"({"eye": [0, 0, 10], "target": [0, 0, 20]})");
  EXPECT_THAT(run(flat + " --view " + at("away.json")).error, HasSubstr("turn \"target\" towards the scene"));
  folder_.write("far.json", R"({"eye": [0, 400000, 300000], "fov_vertical_degrees": 90, "z_far": 1000000})");
  EXPECT_THAT(run(flat + " --view " + at("far.json")).error, HasSubstr("smaller than a pixel"));
}

TEST_F(SceneNotes, sceneInfoTellsTrianglesInTheFileAndAfterBaking) {
  Image<Rgb8> checks(32, 32);
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 32; ++x) {
      checks(x, y) = Rgb8((x + y) % 2 == 0 ? 255 : 0);
    }
  }
  writePng(folder_ / "checks.png", checks);
  folder_.write("square.mtl", "newmtl m\nmap_Kd checks.png\n");
  folder_.write("square.obj",
                "mtllib square.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n");
  const ProgramResult info = run("scene info " + at("square.obj"));
  EXPECT_EQ(info.exitCode, 0) << info.error;
  EXPECT_THAT(info.output, testing::ContainsRegex("triangles  2 in the file, [0-9]+ after its textures were baked"));
  const auto json = nlohmann::json::parse(run("scene info --json " + at("square.obj")).output);
  EXPECT_EQ(json["triangles_in_file"], 2);
  EXPECT_GT(json["triangles"], 2);
  EXPECT_THAT(run("scene info --no-textures " + at("square.obj")).output, HasSubstr("triangles  2\n"));
}

TEST_F(SceneNotes, texturesThatDoNotFitAreToldOf) {
  writePng(folder_ / "grey.png", Image<Rgb8>(64, 64, Rgb8(128)));
  folder_.write("square.mtl", "newmtl m\nmap_Kd grey.png\n");
  folder_.write("square.obj",
                "mtllib square.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n");
  const std::string info = "scene info --json " + at("square.obj") + " --texture-triangles ";
  const ProgramResult halved = run(info + "520");
  EXPECT_THAT(halved.error, testing::AllOf(HasSubstr("1/4 of their width"), HasSubstr("--texture-triangles full")));
  EXPECT_EQ(nlohmann::json::parse(halved.output)["triangles"], 512);
  const ProgramResult full = run(info + "full");
  EXPECT_EQ(full.error, "");
  EXPECT_EQ(nlohmann::json::parse(full.output)["triangles"], 8 * 64 * 64);
  for (const char* wrong : {"-1", "some", "20000001", ""}) {
    EXPECT_EQ(run(info + "'" + wrong + "'").exitCode, 2) << wrong;
  }
}

TEST_F(SceneNotes, wrongLabelsAreToldWithTheirLine) {
  folder_.write("labels.csv", "x,y,z,text\n0,0,0,here\n0,zero,0,there\n");
  const ProgramResult wrong = run("scene info builtin:box --labels " + at("labels.csv"));
  EXPECT_EQ(wrong.exitCode, 2);
  EXPECT_THAT(wrong.error, testing::AllOf(HasSubstr("labels.csv:3"), HasSubstr("\"zero\" in column \"y\"")));
  folder_.write("labels.csv", "x,y,z,text\n0,0,0,here\n");
  const std::string box = "scene info --json builtin:box";
  const auto triangles = [&](const std::string& command) {
    return nlohmann::json::parse(run(command).output)["triangles"].get<size_t>();
  };
  EXPECT_GT(triangles(box + " --labels " + at("labels.csv")), triangles(box) + 20);
  EXPECT_EQ(run(box + " --label-facing 0,0,0").exitCode, 2);
  const ProgramResult volume =
      run("render builtin:volume,name=skull --labels " + at("labels.csv") + " -o " + at("x.png"));
  EXPECT_EQ(volume.exitCode, 2);
  EXPECT_THAT(volume.error, HasSubstr("--labels"));
}

TEST_F(SceneNotes, aUnionIsToldOnce) {
  const ProgramResult built = run("ocri build builtin:box --camera corners-8 --size 60x40 -o " + at("x.exr"));
  ASSERT_EQ(built.exitCode, 0) << built.error;
  EXPECT_EQ(built.error.find("wrote"), built.error.rfind("wrote")) << built.error;
  EXPECT_THAT(built.error, HasSubstr("corners-8, 9 images of "));
}

TEST_F(SceneNotes, moreImagesThanAFileHoldsAreAnError) {
  const ProgramResult built =
      run("ocri build builtin:box --camera corners-8 --viewers 12 --size 60x40 -o " + at("x.exr"));
  EXPECT_EQ(built.exitCode, 2);
  EXPECT_THAT(built.error, AllOf(HasSubstr("a file holds 64"), HasSubstr("fewer --viewers")));
}

TEST_F(SceneNotes, filesOfOtherKindsNameTheCommandThatTakesThem) {
  ASSERT_EQ(run("slice builtin:box --profile test -o " + at("a.svol")).exitCode, 0);
  const ProgramResult volume = run("slice " + at("a.svol") + " -o " + at("b.svol"));
  EXPECT_EQ(volume.exitCode, 2);
  EXPECT_THAT(volume.error, AllOf(HasSubstr("sliced already"), HasSubstr("ocelli observe")));
  ASSERT_EQ(run("ocri build builtin:box --size 60x40 -o " + at("a.exr")).exitCode, 0);
  EXPECT_THAT(run("render " + at("a.exr") + " -o " + at("b.png")).error, HasSubstr("ocelli ocri mesh"));
}

TEST_F(SceneNotes, errorsInFilesOfOursNameTheirSchema) {
  const auto wrong = folder_.write("wrong.json", R"({"camera": 1, "plan": 1, "eye": 1, "name": 1, "steps": 1})");
  const std::string file = " " + at("wrong.json") + " ";
  folder_.write("graph.json", R"({"camera": "graph", "operations": 1})");
  folder_.write("curved.json", R"({"camera": "curved", "turns": 1})");
  folder_.write("portal.json", R"({"camera": "portal", "size": 1})");
  const std::pair<std::string, std::string> cases[] = {
      {"render builtin:box -o x.png --view" + file, "oc_core/camera/view.schema.json"},
      {"ocri build builtin:box -o x.exr --camera" + file, "oc_core/ocri/camera.schema.json"},
      {"render builtin:box -o x.png --camera " + at("graph.json"), "oc_core/constructor/graph_camera.schema.json"},
      {"render builtin:box -o x.png --camera " + at("curved.json"),
       "oc_core/constructor/curved_ray_camera.schema.json"},
      {"render builtin:box -o x.png --camera " + at("portal.json"), "oc_core/constructor/constructor.schema.json"},
      {"scene info builtin:maze,file=" + (folder_ / "wrong.json").string(), "oc_core/worlds/maze.schema.json"},
      {"slice builtin:box -o x.svol --profile" + file, "display_sim/frames/profiles/display_profile.schema.json"},
      {"study check" + file, "protocols/protocol.schema.json"},
      {"present builtin:box --profile test --device sim --faults" + file, "docs/emulated_device.md#faults"},
      {"present builtin:box --profile test --device null --eyes" + file, "docs/observer.md#series"}};
  for (const auto& [command, schema] : cases) {
    const ProgramResult result = runShell("cd " + at("") + " && \"$OCELLI\" " + command);
    EXPECT_EQ(result.exitCode, 2) << command;
    EXPECT_THAT(result.error, HasSubstr("try: see " + schema)) << command;
    const std::string path = schema.substr(0, schema.find('#'));
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(OCELLI_SOURCE_DIR) / path)) << path;
  }
}

}  // namespace
}  // namespace ocelli::test
