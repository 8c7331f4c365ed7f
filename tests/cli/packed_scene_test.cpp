// Packed scenes as the SCENE of each command, against the scene that was packed.
#include "oc_core/pack/packed_scene.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/interrupt.h"
#include "display_sim/frames/svol_file.h"
#include "oc_core/base/output_file.h"
#include "oc_core/image/png_file.h"
#include "oc_core/ocri/reference_image_file.h"
#include "oc_core/scene/ply_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"
#include "tests/ocri/seen_by_reference.h"

namespace ocelli::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kSource = "builtin:statues,triangles=60000";

class PackedSceneCommands : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    shared_ = std::make_unique<TemporaryFolder>();
    const ProgramResult packed = runProgram(std::string("scene pack ") + kSource + " -q -o " + inQuotes(pack()));
    ASSERT_EQ(packed.exitCode, 0) << packed.error;
  }
  static void TearDownTestSuite() { shared_.reset(); }

  static std::filesystem::path pack() { return *shared_ / "statues.opack"; }
  std::string out(const std::string& name) const { return inQuotes(folder_ / name); }

  /// Runs it with the source and with the packed scene; `-o` and its file are added.
  void runBoth(const std::string& before, const std::string& after, const std::string& extension) const {
    for (const auto& [scene, name] : {std::pair{std::string(kSource), "source"}, {inQuotes(pack()), "packed"}}) {
      const ProgramResult result =
          runProgram(before + " " + scene + " " + after + " -q -o " + out(std::string(name) + extension));
      ASSERT_EQ(result.exitCode, 0) << before << " " << name << ": " << result.error;
    }
  }

  static std::unique_ptr<TemporaryFolder> shared_;
  TemporaryFolder folder_;
};
std::unique_ptr<TemporaryFolder> PackedSceneCommands::shared_;

/// A quarter of a pixel at silhouettes. ddoc and spoc displace samples by where an edge is, so more of them show
/// another surface.
TEST_F(PackedSceneCommands, OcriBuildShowsTheSource) {
  const PinholeCamera view(View{}, 360, 240);
  for (const std::string camera :
       {"di", "ddoc", "eoc-h", "eoc-hv", "cell", "corners-4", "ldi-4", "spoc", "rppc", "panorama"}) {
    runBoth("ocri build", "--camera " + camera + " --size 360x240", ".exr");
    const ReferenceImages source = readReferenceImages(folder_ / "source.exr");
    const ReferenceImages packed = readReferenceImages(folder_ / "packed.exr");
    EXPECT_LT(otherShare(source, packed, view), camera == "ddoc" || camera == "spoc" ? 0.015 : 0.005) << camera;
    EXPECT_NEAR(static_cast<double>(samplesOf(packed)), static_cast<double>(samplesOf(source)),
                0.02 * static_cast<double>(samplesOf(source)))
        << camera;
  }
}

/// Splats of points cover what lies beside a silhouette by up to a pixel.
TEST_F(PackedSceneCommands, RenderShowsTheSource) {
  for (const std::string method : {"raster", "points", "hybrid", "raycast"}) {
    runBoth("render", "--camera di --size 360x240 --method " + method, ".png");
    const Image<Rgb8> a = readPng(folder_ / "source.png");
    const Image<Rgb8> b = readPng(folder_ / "packed.png");
    ASSERT_EQ(a.size(), b.size());
    size_t different = 0;
    for (size_t i = 0; i < a.size(); ++i) {
      different += std::abs(a[i].r - b[i].r) + std::abs(a[i].g - b[i].g) + std::abs(a[i].b - b[i].b) > 48 ? 1 : 0;
    }
    EXPECT_LT(different, a.size() / (method == "points" ? 50 : 500)) << method;
  }
}

TEST_F(PackedSceneCommands, SlicesLightTheSameSurface) {
  for (const std::string options : {"", "--undithered", "--antialias"}) {
    runBoth("slice", "--profile test " + options, ".svol");
    const auto source = static_cast<double>(readSvol(folder_ / "source.svol").litVoxels());
    // A surface that is off by an eighth of a voxel touches another voxel at some places.
    EXPECT_NEAR(static_cast<double>(readSvol(folder_ / "packed.svol").litVoxels()), source, 0.06 * source) << options;
  }
  runBoth("slice", "--profile test --exact", ".svol");
  EXPECT_EQ(readSvol(folder_ / "source.svol"), readSvol(folder_ / "packed.svol"));
}

TEST_F(PackedSceneCommands, PresentShowsItWithAndWithoutEyes) {
  const std::string present = "present " + inQuotes(pack()) + " --profile test --device null --json ";
  for (const char* options : {"--seconds 0.4", "--seconds 0.4 --turn 30", "--seconds 0.4 --camera ddoc --size 90x60"}) {
    const ProgramResult result = runProgram(present + options);
    ASSERT_EQ(result.exitCode, 0) << options << ": " << result.error;
    EXPECT_GE(json::parse(result.output)["frames_shown"], 1) << options;
  }
  for (const char* camera : {"di", "ddoc", "eoc-h", "cell"}) {
    const ProgramResult result = runShell("printf 'time,x,y,z\\n0,0,0,10\\n1,2,0,9.5\\n' | \"$OCELLI\" " + present +
                                          "--eyes - --size 90x60 --camera " + camera);
    ASSERT_EQ(result.exitCode, 0) << camera << ": " << result.error;
    EXPECT_GE(json::parse(result.output)["frames_shown"], 1) << camera;
    EXPECT_EQ(json::parse(result.output)["eyes_left_out"], 0) << camera;
  }
}

TEST_F(PackedSceneCommands, InfoTellsWhatItHolds) {
  const ProgramResult result = runProgram("scene info " + inQuotes(pack()) + " --json");
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const json packed = json::parse(result.output);
  const json source = json::parse(runProgram(std::string("scene info --json ") + kSource).output);
  EXPECT_EQ(packed["source"], kSource);
  EXPECT_EQ(packed["fit"], true);
  EXPECT_EQ(packed["shading"], "lambert");
  EXPECT_EQ(packed["bytes"], std::filesystem::file_size(pack()));
  for (const char* same : {"triangles", "triangles_in_file", "lower", "upper"}) {
    EXPECT_EQ(packed[same], source[same]) << same;
  }
  EXPECT_GE(packed["levels"], 4);
  EXPECT_LT(packed["coarsest_triangles"], packed["triangles"].get<size_t>() / 20);
  // Each level halves the triangles, so that all have twice as many as the finest.
  EXPECT_NEAR(packed["stored_triangles"].get<double>(), 2 * packed["triangles"].get<double>(),
              0.1 * packed["triangles"].get<double>());
  EXPECT_LT(packed["finest_clusters"], packed["clusters"]);
  EXPECT_LT(packed["coarsest_clusters"], packed["finest_clusters"]);
  EXPECT_THAT(runProgram("scene info " + inQuotes(pack())).output,
              AllOf(HasSubstr("source     builtin:statues"), HasSubstr("levels "), HasSubstr("at the coarsest"),
                    HasSubstr("bytes ")));
}

TEST_F(PackedSceneCommands, OthersTakeAllOfIt) {
  const std::string scene = inQuotes(pack());
  ASSERT_EQ(runProgram("scene export " + scene + " -o " + out("all.ply")).exitCode, 0);
  ASSERT_EQ(runProgram(std::string("scene export ") + kSource + " -o " + out("source.ply")).exitCode, 0);
  EXPECT_EQ(readPly(folder_ / "all.ply").triangles.size(), readPly(folder_ / "source.ply").triangles.size());
  const auto samples = [&](const std::string& of) {
    const ProgramResult result = runProgram("evaluate " + of +
                                            " --size 90x60 --profile test --interior 2 --directions 2 --runs 1 "
                                            "--cameras di,ddoc -q --json " +
                                            out("evaluation.json"));
    EXPECT_EQ(result.exitCode, 0) << result.error;
    return json::parse(fileBytes(folder_ / "evaluation.json"))["representations"][0]["samples"];
  };
  EXPECT_EQ(samples(scene), samples(kSource));
  for (const std::string& command :
       {"solidity " + scene + " --profile test", "ocri build " + scene + " --viewers 3 --size 90x60 -o " + out("v.exr"),
        "ocri build " + scene + " --construction rays --size 90x60 -o " + out("r.exr")}) {
    const ProgramResult result = runProgram(command);
    EXPECT_EQ(result.exitCode, 0) << command << ": " << result.error;
  }
}

TEST_F(PackedSceneCommands, WhatItCannotDoIsAnErrorThatSaysWhatToDo) {
  const std::string scene = inQuotes(pack());
  struct Case {
    std::string command;
    const char* says;
  };
  for (const Case& each : std::vector<Case>{
           {"scene info " + scene + " --no-fit", "pack it with --no-fit"},
           {"render " + scene + " --shading none -o " + out("a.png"), "pack it with --shading none"},
           {"scene pack " + scene + " -o " + out("again.opack"), "packed already"},
           {"scene info builtin:statues,mesh=" + scene, "the file that it was packed from"},
           {"demo " + scene + " -o " + out("demo"), "the file that it was packed from"},
           {"ocri build " + scene + " --camera geometry -o " + out("a.exr"), "no image"},
           {"observe " + scene + " -o " + out("a.png"), "no .svol file"},
           {"scene info " + inQuotes(folder_.write("cut.opack", fileBytes(pack()).substr(0, 100'000))), "cut off"},
           {"slice " + inQuotes(folder_ / "none.opack") + " -o " + out("a.svol"), "No such file"}}) {
    const ProgramResult result = runProgram(each.command);
    EXPECT_EQ(result.exitCode, 2) << each.command;
    EXPECT_THAT(result.error, AllOf(HasSubstr(each.says), HasSubstr("try:"), HasSubstr("ocelli: error: ")))
        << each.command;
  }
}

/// The first job is held up where it has made a part, then killed.
TEST_F(PackedSceneCommands, ASecondJobIsRefusedAndAKilledOneGoesOn) {
  const ProgramResult result = runShell("cd " + inQuotes(folder_.path()) + R"(
"$OCELLI" scene pack builtin:statues,triangles=800000 -o many.opack -q & job=$!
while kill -0 $job && ! ls many.opack.work/part_0 2>/dev/null >&2; do sleep 0.01; done
kill -STOP $job
"$OCELLI" scene pack builtin:box -o many.opack; echo "second $?"
kill -KILL $job; wait $job 2>/dev/null
ls many.opack many.opack.partial 2>/dev/null
"$OCELLI" scene pack builtin:statues,triangles=800000 -o many.opack --json; echo "third $?"
ls)");
  EXPECT_THAT(result.output, AllOf(HasSubstr("second 1"), HasSubstr("third 0"), Not(HasSubstr("many.opack.work"))));
  EXPECT_THAT(result.error, AllOf(HasSubstr("many.opack: another job"), HasSubstr("were at hand")));
}

TEST_F(PackedSceneCommands, AFileThatBecomesShorterEndsTheProgramWithAnErrorThatNamesIt) {
  const std::filesystem::path copy = folder_ / "copy.opack";
  std::filesystem::copy_file(pack(), copy);
  const std::filesystem::path unfinished = folder_ / "half.svol";
  EXPECT_EXIT(
      {
        endOnLostFiles(1);
        const OutputFile output(unfinished);
        const PackedScene scene(copy);
        std::filesystem::resize_file(copy, 8192);
        scene.verify();
      },
      testing::ExitedWithCode(1), "ocelli: error: .*copy.opack: this file became shorter.*\n  try: ");
  EXPECT_FALSE(std::filesystem::exists(unfinished.string() + ".partial"));
  // Any other reason is the program's own affair.
  EXPECT_EXIT(
      {
        endOnLostFiles(1);
        std::raise(SIGBUS);
      },
      testing::KilledBySignal(SIGBUS), "");
}

}  // namespace
}  // namespace ocelli::test
