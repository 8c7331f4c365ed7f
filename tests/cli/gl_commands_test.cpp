// `--method gl` and `--construction gl`: the same results as the CPU's, and errors that say what is wrong.
#include <gmock/gmock.h>

#include "display_sim/frames/svol_file.h"
#include "oc_core/image/png_file.h"
#include "oc_core/ocri/reference_image_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(GlCommands, renderAndConstructTheSameImages) {
  const TemporaryFolder folder;
  for (const char* camera : {"di", "ddoc", "eoc-h", "cell"}) {
    const std::string common = std::string(" builtin:boxes --size 180x120 --camera ") + camera + " -o ";
    const std::string raster = (folder / "raster.exr").string();
    const std::string gl = (folder / "gl.exr").string();
    ASSERT_EQ(runProgram("ocri build" + common + raster).exitCode, 0);
    for (const char* command : {"render --method gl", "ocri build --construction gl --gl osmesa"}) {
      const ProgramResult result = runProgram(command + common + gl);
      ASSERT_EQ(result.exitCode, 0) << result.error;
      EXPECT_THAT(result.error, HasSubstr("with OpenGL on "));
      const ReferenceImage expected = readReferenceImages(raster).front();
      const ReferenceImage got = readReferenceImages(gl).front();
      ASSERT_EQ(got.width(), expected.width()) << camera;
      // Feedback, and which tiles a cell camera takes, may tip over at single samples.
      EXPECT_NEAR(static_cast<double>(got.sampleCount()), static_cast<double>(expected.sampleCount()),
                  0.005 * static_cast<double>(expected.sampleCount()))
          << camera;
    }
  }
}

TEST(GlCommands, graphAndCurvedRayCamerasAreDrawnTheSame) {
  const TemporaryFolder folder;
  const std::string plane = R"("point": [4, 0, 0], "normal": )";
  const std::string graph =
      folder
          .write("graph.json", R"({"camera": "graph", "operations": [{"operation": "bend", "of": "root", "into": {
        "name": "bent", "plane": {"point": [0, 0, 0], "normal": [0, 0, -1]}, "viewpoint": [1, 0.5, 5]}}]})")
          .string();
  const std::string curved =
      folder
          .write("curved.json", R"({"camera": "curved", "turns": [{"from": {)" + plane +
                                    R"([-0.25, 0, -1]}, "middle": {)" + plane + R"([0, 0, -1]}, "to": {)" + plane +
                                    R"([0.25, 0, -1]}, "viewpoint": [-2, 0, 6]}]})")
          .string();
  for (const std::string& camera : {graph, curved}) {
    const auto imageBy = [&](const std::string& method) {
      const std::string file = (folder / (method + ".png")).string();
      const ProgramResult result = runProgram("render builtin:boxes --size 180x120 --method " + method + " --camera '" +
                                              camera + "' -o '" + file + "'");
      EXPECT_EQ(result.exitCode, 0) << result.error;
      return readPng(file);
    };
    const Image<Rgb8> expected = imageBy("raster");
    const Image<Rgb8> got = imageBy("gl");
    size_t differing = 0;
    for (size_t i = 0; i < expected.size(); ++i) {
      differing += expected[i] != got[i];
    }
    EXPECT_LE(differing, expected.size() / 1000) << camera << ": single pixels of silhouettes";
  }
}

TEST(GlCommands, shadeCastsTheSameRays) {
  const TemporaryFolder folder;
  const std::string common = "shade builtin:mirror --size 90x60 --image-size 90x60 --environment-height 64 --by di -o ";
  const std::string cpu = (folder / "cpu.png").string();
  const std::string gl = (folder / "gl.png").string();
  ASSERT_EQ(runProgram(common + cpu).exitCode, 0);
  for (const char* provider : {"egl", "osmesa", "auto"}) {
    const ProgramResult result = runProgram(common + gl + " --gl " + provider);
    ASSERT_EQ(result.exitCode, 0) << result.error;
    EXPECT_THAT(result.error, HasSubstr("with OpenGL on "));
    const Image<Rgb8> expected = readPng(cpu);
    const Image<Rgb8> got = readPng(gl);
    size_t differing = 0;
    for (size_t i = 0; i < expected.size(); ++i) {
      differing += expected[i] != got[i];
    }
    EXPECT_LE(differing, expected.size() / 200);
  }
  const ProgramResult compared = runProgram(common + gl + " --compare --gl egl");
  ASSERT_EQ(compared.exitCode, 0) << compared.error;
  EXPECT_THAT(compared.output, HasSubstr("GL off %"));
  const ProgramResult nothing = runProgram("shade builtin:mirror --by traced --compare --gl egl");
  EXPECT_EQ(nothing.exitCode, 2);
  EXPECT_THAT(nothing.error, AllOf(HasSubstr("no ray is cast with OpenGL"), HasSubstr("leave --gl out")));
}

TEST(GlCommands, sliceAndObserveTheSame) {
  const TemporaryFolder folder;
  const std::string processor = (folder / "processor.svol").string();
  const std::string gl = (folder / "gl.svol").string();
  const std::string slice = "slice builtin:teapot --profile test -o ";
  ASSERT_EQ(runProgram(slice + processor + " --exact").exitCode, 0);
  const ProgramResult result = runProgram(slice + gl + " --method gl");
  ASSERT_EQ(result.exitCode, 0) << result.error;
  EXPECT_THAT(result.error, HasSubstr("sliced with OpenGL on "));
  EXPECT_EQ(readSvol(gl), readSvol(processor));
  const ProgramResult seen = runProgram("observe " + gl + " --method gl -o " + (folder / "seen.png").string());
  EXPECT_EQ(seen.exitCode, 0) << seen.error;
  const std::pair<const char*, const char*> cases[] = {
      {"--aperture 0.01", "x.png"}, {"--ambient 0.01", "x.png"}, {"--ambient 0.01 --turntable 2", "frames"}};
  for (const auto& [options, output] : cases) {
    const ProgramResult refused =
        runProgram("observe " + gl + " --method gl " + options + " -o " + (folder / output).string());
    EXPECT_EQ(refused.exitCode, 2) << options;
    EXPECT_THAT(refused.error, HasSubstr("leave out --method gl")) << options;
    EXPECT_FALSE(std::filesystem::exists(folder / output)) << options;
  }
}

TEST(GlCommands, displaysOfManyBitsAreBadInput) {
  const TemporaryFolder folder;
  const std::string profile = folder
                                  .write("deep.json", R"({"name": "deep", "radius_metres": 0.127,
      "slices_per_half_turn": 24, "width": 64, "height": 64, "rotations_per_minute": 720,
      "second_half_turn": "mirrored", "color_bits_per_channel": 8})")
                                  .string();
  const std::string volume = (folder / "deep.svol").string();
  const std::string slice = "slice builtin:teapot,segments=4 --profile " + profile + " -o " + volume;
  const auto expectRefused = [](const ProgramResult& result) {
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_THAT(result.error, AllOf(HasSubstr("color_bits_per_channel"), HasSubstr("leave out --method gl")));
  };
  expectRefused(runProgram(slice + " --method gl"));
  EXPECT_FALSE(std::filesystem::exists(volume));
  ASSERT_EQ(runProgram(slice).exitCode, 0);
  expectRefused(runProgram("observe " + volume + " --method gl -o " + (folder / "x.png").string()));
}

TEST(GlCommands, sayWhatIsWrong) {
  const TemporaryFolder folder;
  const std::string image = (folder / "x.png").string();
  const auto failure = [](const std::string& arguments) {
    const ProgramResult result = runProgram(arguments);
    return std::to_string(result.exitCode) + " " + result.error;
  };
  EXPECT_THAT(failure("render builtin:teapot --gl egl -o " + image),
              AllOf(HasSubstr("2 "), HasSubstr("nothing draws with OpenGL"), HasSubstr("--method gl")));
  EXPECT_THAT(failure("render builtin:teapot --method gl --gl vulkan -o " + image), HasSubstr("2 "));
  EXPECT_THAT(failure("render builtin:boxes --method gl --camera ldi-4 -o " + (folder / "x.exr").string()),
              AllOf(HasSubstr("2 "), HasSubstr("peels layers")));
  EXPECT_THAT(failure("render no-such-file.obj --method gl -o " + image), HasSubstr("no-such-file.obj"));
  const ProgramResult old =
      runShell("MESA_GL_VERSION_OVERRIDE=3.3 \"$OCELLI\" render builtin:teapot --method gl -o " + image);
  EXPECT_EQ(old.exitCode, 1);
  EXPECT_THAT(old.error, AllOf(HasSubstr("4.5"), HasSubstr("without OpenGL")));
}

}  // namespace
}  // namespace ocelli::test
