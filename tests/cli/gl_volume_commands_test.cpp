// `ocelli render VOLUME --method gl`: the same picture as the CPU's.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>

#include "oc_core/image/png_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

constexpr const char* kLensFile = R"({"camera": "gpc", "regions": [
  {"center": [0.5, 0.5], "extent": [0.3, 0.3], "zoom": 3, "transition_width": 0.8}]})";

TEST(GlVolumeCommands, renderTheSamePictureAlongAnyCamerasRays) {
  const TemporaryFolder folder;
  const std::string lens = folder.write("lens.json", kLensFile).string();
  const std::string png = (folder / "image.png").string();
  for (const std::string& options :
       {std::string("--camera di"), "--camera '" + lens + "' --clip 'x>0' --step 1", std::string("--camera ddoc"),
        std::string("--surfaces builtin:teapot --surfaces-frame scene --gl osmesa")}) {
    const auto picture = [&](const std::string& method) {
      std::string render = "render builtin:volume,name=marschner-lobb --size 60x40 -o '" + png + "' " + options;
      if (method == "raycast") {
        render.erase(std::min(render.find(" --gl"), render.size()));
      }
      const ProgramResult result = runProgram(render + " --method " + method);
      EXPECT_EQ(result.exitCode, 0) << result.error;
      EXPECT_EQ(result.error.find("OpenGL") != std::string::npos, method == "gl") << result.error;
      return readPng(png);
    };
    const Image<Rgb8> expected = picture("raycast");
    const Image<Rgb8> got = picture("gl");
    // sRGB is up to 13 times as steep as linear light where it is dark: 0.3 of a level become 4.
    constexpr int kLevels = 4;
    int greatest = 0;
    int brightest = 0;
    for (size_t i = 0; i < expected.size(); ++i) {
      for (int c = 0; c < 3; ++c) {
        greatest = std::max(greatest, std::abs(int{expected[i][c]} - int{got[i][c]}));
        brightest = std::max(brightest, int{got[i][c]});
      }
    }
    EXPECT_LE(greatest, kLevels) << options;
    EXPECT_GT(brightest, 100) << options;
  }
}

TEST(GlVolumeCommands, aProviderWithoutItsMethodIsRefused) {
  const ProgramResult result = runProgram("render builtin:volume,name=marschner-lobb --gl egl -o /dev/null.png");
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.error, HasSubstr("--method gl"));
}

}  // namespace
}  // namespace ocelli::test
