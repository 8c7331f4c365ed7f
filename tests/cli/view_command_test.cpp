// `ocelli view --offscreen`: images, and errors that say what is wrong.
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <vector>

#include "oc_core/image/png_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

ProgramResult view(const std::string& scene, const std::string& script, const TemporaryFolder& folder,
                   const std::string& more = "") {
  const std::string file = folder.write("script.json", script).string();
  return runProgram("view " + scene + " --size 90x60 --profile test --offscreen " + file + " -o " +
                    (folder / "frames").string() + " " + more);
}

TEST(ViewCommand, writesTheFramesOfAScript) {
  const TemporaryFolder folder;
  for (const char* provider : {"egl", "osmesa"}) {
    const ProgramResult result =
        view("builtin:teapot", R"({"size": [640, 400], "steps": [{"wait": "idle"}, {"save": "a.png"}]})", folder,
             std::string("--gl ") + provider);
    EXPECT_EQ(result.exitCode, 0) << result.error;
    EXPECT_THAT(result.error, HasSubstr("a.png"));
    EXPECT_EQ(readPng(folder / "frames/a.png").width(), 640);
    std::filesystem::remove(folder / "frames/a.png");
  }
}

TEST(ViewCommand, aPackedSceneLooksAsItsSource) {
  const TemporaryFolder folder;
  const std::string source = "builtin:statues,triangles=20000";
  const std::string packed = inQuotes(folder / "statues.opack");
  ASSERT_EQ(runProgram("scene pack " + source + " -q -o " + packed).exitCode, 0);
  std::vector<Image<Rgb8>> images;
  for (const std::string& scene : {source, packed}) {
    const ProgramResult result =
        view(scene, R"({"size": [640, 400], "steps": [{"wait": "idle"}, {"save": "a.png"}]})", folder, "--gl osmesa");
    ASSERT_EQ(result.exitCode, 0) << result.error;
    images.push_back(readPng(folder / "frames/a.png"));
    std::filesystem::remove(folder / "frames/a.png");
  }
  ASSERT_EQ(images[0].size(), images[1].size());
  size_t different = 0;
  for (size_t i = 0; i < images[0].size(); ++i) {
    const Rgb8 a = images[0][i];
    const Rgb8 b = images[1][i];
    different += std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b) > 48 ? 1 : 0;
  }
  // The panels name the scene and tell times; the panes show all triangles of both.
  EXPECT_LT(different, images[0].size() / 50);
}

TEST(ViewCommand, aSceneThatIsNoneIsAnError) {
  const TemporaryFolder folder;
  const ProgramResult result = view("no-such-scene.obj", R"({"steps": [{"wait": "idle"}]})", folder);
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.error, HasSubstr("no-such-scene.obj"));
}

TEST(ViewCommand, aWrongScriptIsAnError) {
  const TemporaryFolder folder;
  const ProgramResult result = view("builtin:teapot", R"({"steps": [{"key": "H"}, {"kay": "H"}]})", folder);
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.error, HasSubstr("step 2"));
}

TEST(ViewCommand, wrongOptionsAreErrors) {
  const TemporaryFolder folder;
  for (const char* wrong : {"--camera none", "--gl none", "--view none.json"}) {
    EXPECT_EQ(view("builtin:teapot", R"({"steps": []})", folder, wrong).exitCode, 2) << wrong;
  }
}

// The view that J saves, and the size of the picture, are all that `ocelli shade` needs to draw the same.
TEST(ViewCommand, theEffectPaneShowsWhatShadeDraws) {
  const TemporaryFolder folder;
  const ProgramResult result =
      view("builtin:mirror",
           R"({"size": [480, 320], "steps": [{"wait": "idle"}, {"save_effect": "home.png"}, {"key": "Right"},
               {"key": "Up"}, {"key": "J"}, {"save_effect": "turned.png"}]})",
           folder, "--effect reflection --by di");
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const Image<Rgb8> turned = readPng(folder / "frames/turned.png");
  const std::string shade = "shade builtin:mirror --by di --reference middle --image-size 90x60 --size " +
                            std::to_string(turned.width()) + "x" + std::to_string(turned.height()) + " -o " +
                            inQuotes(folder / "shade.png");
  ASSERT_EQ(runProgram(shade).exitCode, 0);
  EXPECT_EQ(readPng(folder / "shade.png"), readPng(folder / "frames/home.png"));
  ASSERT_EQ(runProgram(shade + " --view " + inQuotes(folder / "frames/ocelli-view-001.json")).exitCode, 0);
  EXPECT_EQ(readPng(folder / "shade.png"), turned);
  EXPECT_NE(turned, readPng(folder / "frames/home.png"));
}

TEST(ViewCommand, wrongEffectsAreErrors) {
  const TemporaryFolder folder;
  const auto expectError = [&](const char* more, const char* part) {
    const ProgramResult result = view("builtin:teapot", R"({"steps": [{"save_effect": "none.png"}]})", folder, more);
    EXPECT_EQ(result.exitCode, 2) << more;
    EXPECT_THAT(result.error, HasSubstr(part)) << more;
  };
  expectError("--effect refelction", "reflection, refraction");
  expectError("--effect reflection --by none", "--by");
  expectError("--by di", "only with --effect");
  expectError("--effect reflection", "drop a file of roles");
  expectError("--effect reflection --roles none.json", "none.json");
}

TEST(ViewCommand, aWindowTakesNoProvider) {
  const ProgramResult result = runProgram("view builtin:teapot --gl osmesa");
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.error, HasSubstr("only with --offscreen"));
}

TEST(ViewCommand, aVolumeLooksAsRenderDrawsItAlongTheRaysOfACameraFile) {
  const TemporaryFolder folder;
  const std::string volume = "builtin:volume,name=marschner-lobb,size=24";
  const std::string camera = inQuotes(folder.write("bent.json", R"({"camera": "curved", "turns": [
      {"from": {"point": [4, 0, 3], "normal": [-0.25, 0, -1]}, "middle": {"point": [4, 0, 3], "normal": [0, 0, -1]},
       "to": {"point": [4, 0, 3], "normal": [0.25, 0, -1]}, "viewpoint": [-2, 0, 8]}]})"));
  for (const std::string& more : {std::string(), " --camera " + camera}) {
    const ProgramResult result = view(volume, R"({"size": [640, 400], "steps": [
        {"wait": "idle"}, {"save_volume": "a.png"}, {"save_transfer": "a.json"}]})",
                                      folder, "--gl osmesa" + more);
    ASSERT_EQ(result.exitCode, 0) << result.error;
    const Image<Rgb8> shown = readPng(folder / "frames/a.png");
    const std::string size = std::to_string(shown.width()) + "x" + std::to_string(shown.height());
    const ProgramResult rendered = runProgram("render " + volume + more + " --size " + size + " -q -o " +
                                              inQuotes(folder / "rendered.png"));
    ASSERT_EQ(rendered.exitCode, 0) << rendered.error;
    EXPECT_EQ(shown, readPng(folder / "rendered.png")) << more;
    const ProgramResult again = runProgram("render " + volume + more + " --transfer " +
                                           inQuotes(folder / "frames/a.json") + " -q -o " +
                                           inQuotes(folder / "again.png"));
    EXPECT_EQ(again.exitCode, 0) << "what was saved is taken: " << again.error;
  }
}

TEST(ViewCommand, optionsOfVolumesAreCheckedAtTheStart) {
  const TemporaryFolder folder;
  const char* script = R"({"steps": [{"wait": "idle"}]})";
  const auto errorOf = [&](const std::string& scene, const std::string& more) {
    const ProgramResult result = view(scene, script, folder, "--gl osmesa " + more);
    EXPECT_EQ(result.exitCode, 2) << more;
    return result.error;
  };
  EXPECT_THAT(errorOf("builtin:teapot", "--clip 'x>0'"), HasSubstr("--clip"));
  EXPECT_THAT(errorOf("builtin:teapot", "--iso 3"), HasSubstr("--iso"));
  EXPECT_THAT(errorOf("builtin:volume,name=marschner-lobb,size=24", "--transfer nonsense"), HasSubstr("nonsense"));
  EXPECT_THAT(errorOf("builtin:volume,name=marschner-lobb,size=24", "--iso 1e6"), HasSubstr("1e"));
}

TEST(ViewCommand, withoutADisplayAWindowIsAnErrorThatSaysWhatToDo) {
  const ProgramResult result = runShell("unset DISPLAY WAYLAND_DISPLAY\n\"$OCELLI\" view builtin:teapot");
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.error, HasSubstr("--offscreen"));
}

}  // namespace
}  // namespace ocelli::test
