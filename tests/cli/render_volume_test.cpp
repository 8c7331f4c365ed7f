// Volumes as SCENE, from outside: `ocelli render` along any camera's rays, and what other commands say.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "oc_core/image/png_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr const char* kVolume = "builtin:volume,name=marschner-lobb";

/// The turn and the split are those of docs/graph_cameras.md.
constexpr const char* kCurved = R"({"camera": "curved", "turns": [
  {"from": {"point": [4, 0, 3], "normal": [-0.25, 0, -1]}, "middle": {"point": [4, 0, 3], "normal": [0, 0, -1]},
   "to": {"point": [4, 0, 3], "normal": [0.25, 0, -1]}, "viewpoint": [-2, 0, 8]}]})";
constexpr const char* kGraph = R"({"camera": "graph", "view": {"eye": [0, 0.2, 10]}, "operations": [
  {"operation": "split", "of": "root", "into": [
    {"name": "left", "plane": {"point": [0, 0, 0.5], "normal": [-0.3, 0, -1]}, "viewpoint": [1.5, 0, 7]},
    {"name": "right", "plane": {"point": [0, 0, 0.5], "normal": [0.3, 0, -1]}, "viewpoint": [-1.5, 0, 7]}]}]})";
constexpr const char* kLens = R"({"camera": "gpc", "regions": [
  {"center": [0.5, 0.5], "extent": [0.3, 0.3], "zoom": 3, "transition_width": 0.8}]})";

class RenderVolume : public testing::Test {
 protected:
  std::string out() const { return (folder_ / "image.png").string(); }
  ProgramResult render(const std::string& options, const std::string& scene = kVolume) const {
    return runProgram("render " + scene + (options.find("--size") == std::string::npos ? " --size 60x40" : "") +
                      " -o " + out() + " " + options);
  }
  /// The error of what must fail as wrong input.
  std::string errorOf(const std::string& options, const std::string& scene = kVolume) const {
    const ProgramResult result = render(options, scene);
    EXPECT_EQ(result.exitCode, 2) << options << result.error;
    return result.error;
  }
  Image<Rgb8> image() const { return readPng(out()); }
  /// Of the channel's values.
  double meanOf(const Image<Rgb8>& image) const {
    double sum = 0;
    for (const Rgb8& pixel : image) {
      sum += pixel.x;
    }
    return sum / static_cast<double>(image.size());
  }

  TemporaryFolder folder_;
};

TEST_F(RenderVolume, AlongTheRaysOfAnyCamera) {
  const std::string curved = folder_.write("curved.json", kCurved).string();
  const std::string graph = folder_.write("graph.json", kGraph).string();
  const std::string lens = folder_.write("lens.json", kLens).string();
  const std::string box = folder_
                              .write("box.json", R"({"camera": "occluder", "box":
      {"lower": [-0.2, -0.2, 0], "upper": [0.2, 0.2, 0.2]}})")
                              .string();
  std::map<std::string, std::string> different;
  for (const std::string& camera : {std::string("di"), lens, graph, curved, box, std::string("panorama"),
                                    std::string("ddoc"), std::string("eoc-h"), std::string("cell")}) {
    const ProgramResult result = render("--camera " + camera + (camera == "panorama" ? " --size 360x180" : ""),
                                        "builtin:volume,name=skull,size=64");
    ASSERT_EQ(result.exitCode, 0) << camera << result.error;
    EXPECT_THAT(result.error, AllOf(HasSubstr("wrote"), HasSubstr("samples")));
    EXPECT_GT(meanOf(image()), 0) << camera;
    for (const auto& [other, bytes] : different) {
      EXPECT_NE(fileBytes(out()), bytes) << camera << " and " << other;
    }
    different[camera] = fileBytes(out());
  }
}

TEST_F(RenderVolume, TheSameBytesWithAnyNumberOfThreads) {
  ASSERT_EQ(render("--threads 1").exitCode, 0);
  const std::string one = fileBytes(out());
  ASSERT_EQ(render("--threads 3").exitCode, 0);
  EXPECT_EQ(fileBytes(out()), one);
}

TEST_F(RenderVolume, ClipsTheHalfSpacesThatAreNotShown) {
  const auto columns = [&](const std::string& clip) {
    EXPECT_EQ(render(clip).exitCode, 0) << clip;
    const Image<Rgb8> shown = image();
    std::pair<int, int> lit{0, 0};  // left and right of the middle
    for (int y = 0; y < shown.height(); ++y) {
      for (int x = 0; x < shown.width(); ++x) {
        (x < shown.width() / 2 ? lit.first : lit.second) += shown(x, y).x > 0 ? 1 : 0;
      }
    }
    return lit;
  };
  const auto [wholeLeft, wholeRight] = columns("");
  EXPECT_GT(wholeLeft, 0);
  EXPECT_GT(wholeRight, 0);
  for (const char* clip : {"--clip 'x>0.05'", "--clip 1,0,0,0.05", "--clip 20,0,0,1"}) {
    const auto [left, right] = columns(clip);
    EXPECT_EQ(left, 0) << clip;
    EXPECT_GT(right, 0) << clip;
  }
  EXPECT_EQ(columns("--clip=-1,0,0,0.05").second, 0);
  // Both together: a slab between them.
  const auto [left, right] = columns("--clip 'x>-0.2' --clip 'x<-0.1'");
  EXPECT_GT(left, 0);
  EXPECT_LT(left, wholeLeft);
  EXPECT_EQ(right, 0);
}

TEST_F(RenderVolume, ShowsABackgroundWhereItIsTransparent) {
  ASSERT_EQ(render("--background '#204060'").exitCode, 0);
  EXPECT_EQ(image()(0, 0), Rgb8(0x20, 0x40, 0x60));
  ASSERT_EQ(render("").exitCode, 0);
  EXPECT_EQ(image()(0, 0), Rgb8(0, 0, 0));
}

TEST_F(RenderVolume, SurfacesStandInIt) {
  // The whole of the volume's cube, in its own coordinates, is behind this: white but for the light.
  const std::string wall =
      folder_.write("wall.obj", "v -2 -2 1.2\nv 2 -2 1.2\nv 2 2 1.2\nv -2 2 1.2\nf 1 2 3 4\n").string();
  ASSERT_EQ(render("").exitCode, 0);
  const Image<Rgb8> without = image();
  ASSERT_EQ(render("--surfaces " + wall + " --shading none").exitCode, 0);
  const Image<Rgb8> with = image();
  EXPECT_EQ(with(30, 20), Rgb8(255, 255, 255));
  EXPECT_NE(without(30, 20), Rgb8(255, 255, 255));
  // In the coordinates of the scene, where the cube's corners are on the unit sphere, it is before the eye as well, and
  // larger than the image.
  ASSERT_EQ(render("--surfaces " + wall + " --surfaces-frame scene --shading none").exitCode, 0);
  EXPECT_EQ(image()(0, 0), Rgb8(255, 255, 255));
  EXPECT_THAT(errorOf("--surfaces-frame scene"), HasSubstr("--surfaces-frame"));
  EXPECT_THAT(errorOf("--surfaces " + std::string(kVolume)), HasSubstr("this is a volume"));
}

TEST_F(RenderVolume, ShadingIsWhatTheUserSays) {
  std::set<std::string> images;
  for (const char* shading : {"--shading lambert", "--shading none"}) {
    ASSERT_EQ(render(shading).exitCode, 0);
    images.insert(fileBytes(out()));
  }
  EXPECT_EQ(images.size(), 2u);
}

/// The example of docs/volumes.md: vessels, which the transfer function shows in red, are hidden behind the forehead,
/// and a camera whose rays bend shows them above it.
TEST_F(RenderVolume, SeesBehindBone) {
  const std::string examples = OCELLI_SOURCE_DIR "/docs/cameras/examples/";
  const auto shown = [&](const std::string& camera) {
    const ProgramResult result = render("--size 180x165 --clip 'y<0.2' --transfer " + examples +
                                            "skull_transfer.json --view " + examples + "skull_view.json " + camera,
                                        "builtin:volume,name=skull,size=192");
    EXPECT_EQ(result.exitCode, 0) << result.error;
    return image();
  };
  const auto redAbove = [](const Image<Rgb8>& image, int row) {
    int count = 0;
    for (int y = 0; y < row; ++y) {
      for (int x = 0; x < image.width(); ++x) {
        count += image(x, y).x > image(x, y).y + 60 ? 1 : 0;
      }
    }
    return count;
  };
  const Image<Rgb8> straight = shown("");
  const Image<Rgb8> bent = shown("--camera " + examples + "skull_curved.json");
  constexpr int kBrow = 58;  // the rim of the cut, in front
  EXPECT_EQ(redAbove(straight, kBrow), 0);
  EXPECT_GT(redAbove(bent, kBrow), 20);
  // What stands before the bend is the pinhole's: the teeth.
  for (int y = 121; y < 139; ++y) {
    EXPECT_EQ(bent(90, y), straight(90, y)) << y;
  }
}

TEST_F(RenderVolume, TellsWhatItTook) {
  const ProgramResult coarse = render("--json --quiet --step 2 --transfer ramp");
  ASSERT_EQ(coarse.exitCode, 0) << coarse.error;
  const auto json = nlohmann::json::parse(coarse.output);
  EXPECT_EQ(json["camera"], "di");
  EXPECT_EQ(json["width"], 60);
  EXPECT_EQ(json["step"], 2);
  EXPECT_GT(json["samples"], 1000);
  EXPECT_GT(json["pixels_touched"], 100);
  EXPECT_GT(json["peak_mib"], 1);
  const ProgramResult fine = render("--json --quiet --step 0.5 --transfer ramp");
  EXPECT_GT(nlohmann::json::parse(fine.output)["samples"], 2 * json["samples"].get<int>());
}

TEST_F(RenderVolume, KeepsItsOpacityInAnExr) {
  const std::string exr = (folder_ / "image.exr").string();
  ASSERT_EQ(runProgram("render " + std::string(kVolume) + " --size 30x20 -o " + exr).exitCode, 0);
  const std::string bytes = fileBytes(exr);
  // Its header names the channels (tests/volume_camera/volume_image_file_test.cpp reads them).
  EXPECT_THAT(bytes, AllOf(HasSubstr(std::string("A\0", 2)), HasSubstr("P.X"), HasSubstr("depth_opacity")));
  const ProgramResult result = runProgram("render " + std::string(kVolume) + " --background '#ffffff' -o " + exr);
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.error, HasSubstr("--background"));
}

TEST_F(RenderVolume, SaysWhatIsWrong) {
  EXPECT_THAT(errorOf("--clip x"), AllOf(HasSubstr("--clip"), HasSubstr("quotes")));
  EXPECT_THAT(errorOf("--clip 0,0,0,1"), HasSubstr("--clip"));
  EXPECT_THAT(errorOf("--clip 'w>1'"), HasSubstr("--clip"));
  EXPECT_THAT(errorOf("--step 0"), HasSubstr("--step"));
  EXPECT_THAT(errorOf("--background red"), AllOf(HasSubstr("--background"), HasSubstr("#RRGGBB")));
  EXPECT_THAT(errorOf("--transfer nonsense"), HasSubstr("nonsense"));
  EXPECT_THAT(errorOf("--method points"), AllOf(HasSubstr("--method"), HasSubstr("--iso")));
  EXPECT_THAT(errorOf("--antialias msaa-4"), AllOf(HasSubstr("--antialias"), HasSubstr("--size")));
  EXPECT_THAT(errorOf("--identity " + (folder_ / "objects.png").string()), HasSubstr("--identity"));
  EXPECT_THAT(errorOf("--point-size 1"), HasSubstr("--point-size"));
  EXPECT_THAT(errorOf("--no-textures"), HasSubstr("--no-textures"));
  EXPECT_THAT(errorOf("--camera corners-8"), HasSubstr("union"));
  EXPECT_THAT(errorOf("--camera simplified"), HasSubstr("is a mesh"));
  EXPECT_THAT(errorOf("--camera comprehensive"), HasSubstr("no floor to walk on"));
  const std::string away = folder_.write("away.json", R"({"eye": [0, 0, 10], "target": [0, 0, 20]})").string();
  EXPECT_THAT(errorOf("--view " + away), HasSubstr("outside of the view"));
  EXPECT_THAT(errorOf("--clip 'x>5'"), HasSubstr("transparent"));
  EXPECT_THAT(errorOf("", "builtin:volume,name=nonsense"), HasSubstr("nonsense"));
}

TEST_F(RenderVolume, OptionsOfVolumesAreForVolumes) {
  for (const char* option : {"--clip 'x>0'", "--step 1", "--surfaces builtin:box", "--background '#ffffff'", "--json",
                             "--surfaces-frame scene"}) {
    EXPECT_THAT(errorOf(option, "builtin:teapot"), HasSubstr("for volumes alone")) << option;
  }
  EXPECT_THAT(errorOf("--transfer ramp", "builtin:teapot"), HasSubstr("no volume"));
  EXPECT_THAT(errorOf("--iso 1", "builtin:teapot"), HasSubstr("no volume"));
}

/// Whoever needs triangles says which option makes some.
TEST(VolumeScenes, AreMeshesByTheirValue) {
  const TemporaryFolder folder;
  const std::string volume = kVolume;
  for (const std::string& command :
       {"remote serve " + volume, "viewers " + volume + " --viewers 2",
        "scene pack " + volume + " -o " + (folder / "a.opack").string(),
        "camera show " + volume + " --camera curved -o " + (folder / "a.svg").string(),
        "shade " + volume + " --effect ambient --by traced -o " + (folder / "a.png").string(),
        "scene export " + volume + " -o " + (folder / "a.ply").string()}) {
    const ProgramResult result = runProgram(command);
    EXPECT_EQ(result.exitCode, 2) << command << result.error;
    EXPECT_THAT(result.error, HasSubstr("--iso")) << command;
  }
}

}  // namespace
}  // namespace ocelli::test
