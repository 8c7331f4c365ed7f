// `ocelli slice`, `ocelli observe` and `ocelli volume` from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "display_sim/exports/kv6_file.h"
#include "display_sim/frames/svol_file.h"
#include "oc_core/image/png_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A folder with the slices of a coarse teapot.
class DisplayCommands : public testing::Test {
 protected:
  void SetUp() override {
    const ProgramResult result = runProgram("slice builtin:teapot,segments=4 --profile test -o " + quoted("a.svol"));
    ASSERT_EQ(result.exitCode, 0) << result.error;
    EXPECT_THAT(result.error, AllOf(HasSubstr("wrote"), HasSubstr("a.svol")));
  }

  std::string quoted(const std::string& name) const {
    std::string path = "'";
    path += (folder_ / name).string();
    return path += "'";
  }

  TemporaryFolder folder_;
};

TEST_F(DisplayCommands, sliceWritesAVolumeOfTheProfile) {
  const Volume volume = readSvol(folder_ / "a.svol");
  EXPECT_EQ(volume.profile(), loadProfile("test"));
  const ProgramResult result =
      runProgram("slice builtin:teapot,segments=4 --profile test --json --quiet -o " + quoted("b.svol"));
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_EQ(json["lit_voxels"], volume.litVoxels());
  EXPECT_EQ(json["triangles"], 992);
  EXPECT_EQ(fileBytes(folder_ / "a.svol"), fileBytes(folder_ / "b.svol"));
}

TEST_F(DisplayCommands, sliceTakesDithers) {
  std::set<std::string> volumes;
  for (const char* options : {"--exact", "--dither blue-noise", "--dither diffusion", "--dither none",
                              "--exact --undithered", "--even-light 0.5"}) {
    const std::string scene = "slice builtin:teapot,segments=4 --profile test ";
    const ProgramResult result = runProgram(scene + options + " -o " + quoted("dithered.svol"));
    ASSERT_EQ(result.exitCode, 0) << result.error;
    const Volume volume = readSvol(folder_ / "dithered.svol");
    std::string bytes;
    for (int i = 0; i < volume.slices(); ++i) {
      bytes.insert(bytes.end(), volume.slice(i).begin(), volume.slice(i).end());
    }
    volumes.insert(bytes);
  }
  EXPECT_EQ(volumes.size(), 6u);
  for (const char* wrong : {"--dither some", "--dither none --undithered", "--even-light 1.5", "--even-light nan",
                            "--even-light 1 --undithered", "--even-light 1 --method gl"}) {
    EXPECT_EQ(
        runProgram("slice builtin:teapot --profile test " + std::string(wrong) + " -o " + quoted("w.svol")).exitCode, 2)
        << wrong;
  }
}

TEST_F(DisplayCommands, ditherScoresAndDraws) {
  const ProgramResult result =
      runProgram("dither --profile test --dither none,ordered --bits 3 --even-light 0 --json -o " + quoted("pictures"));
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_EQ(json["bits_per_channel"], 3);
  ASSERT_EQ(json["dithers"].size(), 2u);
  EXPECT_EQ(json["dithers"][0]["dither"], "ordered");
  EXPECT_LT(json["dithers"][0]["fields"][0]["mean_block_error"], 1.0 / 255);
  EXPECT_GT(json["dithers"][1]["fields"][0]["mean_block_error"], 1.0 / 255);
  for (const char* name : {"ramp.png", "grey-sphere.png", "colour-wheel.png", "evenness.png"}) {
    EXPECT_GT(readPng(folder_ / "pictures" / name).width(), 200) << name;
  }
  const ProgramResult text = runProgram("dither --profile test --dither blue-noise --even-light 0");
  EXPECT_THAT(text.output, AllOf(HasSubstr("colour wheel"), HasSubstr("blue-noise")));
  EXPECT_EQ(runProgram("dither --bits 9").exitCode, 2);
  EXPECT_EQ(runProgram("dither --dither many").exitCode, 2);
}

TEST_F(DisplayCommands, sliceTakesReferenceImages) {
  ASSERT_EQ(runProgram("ocri build builtin:teapot,segments=4 --camera di --size 60x60 -o " + quoted("a.exr")).exitCode,
            0);
  const ProgramResult result = runProgram("slice " + quoted("a.exr") + " --profile test -o " + quoted("c.svol"));
  EXPECT_EQ(result.exitCode, 0) << result.error;
  EXPECT_GT(readSvol(folder_ / "c.svol").litVoxels(), 100u);
}

TEST_F(DisplayCommands, observeWritesAImage) {
  const ProgramResult result =
      runProgram("observe " + quoted("a.svol") + " --eye 3,4,9 --exposure 1/25 --missing-sector 30 --size 90x60 -o " +
                 quoted("eye.png"));
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const Image<Rgb8> image = readPng(folder_ / "eye.png");
  EXPECT_EQ(image.width(), 90);
  EXPECT_EQ(image.height(), 60);
  EXPECT_TRUE(std::ranges::any_of(image, [](const Rgb8& pixel) { return pixel.x > 100; }));
}

TEST_F(DisplayCommands, observeTakesWhatTheDisplayDoes) {
  const auto image = [&](const std::string& options) {
    const ProgramResult result =
        runProgram("observe " + quoted("a.svol") + " --size 60x60 --gain 0.1 " + options + " -o " + quoted("eye.png"));
    EXPECT_EQ(result.exitCode, 0) << options << result.error;
    return fileBytes(folder_ / "eye.png");
  };
  const std::string plain = image("");
  EXPECT_EQ(image("--emission screen --transmission 1 --start -180"), plain) << "these are defaults";
  EXPECT_EQ(image("--aperture 0.05 --focus 1.27"), image("--aperture 0.05")) << "in focus by default";
  for (const char* options :
       {"--emission even", "--transmission 0.1", "--exposure 1/12 --start 20", "--aperture 0.05 --focus 1.2",
        "--exposure 1/12 --wobble 0.005", "--wobble 0.005 --wobble-direction 0,1,0 --wobble-frequency 3",
        "--wobble 0.005 --wobble-phase 40", "--dead-zone 0.05", "--ambient 0.1", "--gamma 2", "--tone reinhard",
        "--tone filmic"}) {
    EXPECT_NE(image(options), plain) << options;
  }
}

TEST_F(DisplayCommands, observeWritesLightAndFigures) {
  const ProgramResult result =
      runProgram("observe " + quoted("a.svol") + " --size 50x40 --json --quiet -o " + quoted("light.exr"));
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_EQ(json["lit_voxels"], readSvol(folder_ / "a.svol").litVoxels());
  EXPECT_GT(json["observe_ms"], 0);
  EXPECT_GT(json["gain"], 0);
  EXPECT_THAT(fileBytes(folder_ / "light.exr"), HasSubstr("lit_voxels"));
}

TEST_F(DisplayCommands, observeWritesPairsAndSeries) {
  const std::string observe = "observe " + quoted("a.svol") + " --size 50x40 ";
  folder_.write("way.csv", "time,x,y,z\n0,0,0,10\n1,3,0,9\n");
  const auto files = [&](const std::string& options, const char* output) {
    const ProgramResult result = runProgram(observe + options + " -o " + quoted(output));
    EXPECT_EQ(result.exitCode, 0) << result.error;
  };
  files("--stereo 0.063", "pair.png");
  EXPECT_EQ(readPng(folder_ / "pair-left.png").width(), 50);
  EXPECT_NE(fileBytes(folder_ / "pair-left.png"), fileBytes(folder_ / "pair-right.png"));
  files("--stereo 0.063 --side-by-side", "both.png");
  EXPECT_EQ(readPng(folder_ / "both.png").width(), 100);
  files("--turntable 3", "turn");
  EXPECT_EQ(readPng(folder_ / "turn/frame_0002.png").height(), 40);
  files("--path " + quoted("way.csv") + " --rate 2 --stereo 0.063", "way");
  EXPECT_EQ(readPng(folder_ / "way/frame_0002.png").width(), 100);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "way/frame_0003.png"));
}

TEST_F(DisplayCommands, anInterruptedSeriesLeavesNothing) {
  // Once frames are there. A shell's background work ignores Ctrl-C, so it is SIGTERM.
  const ProgramResult result =
      runShell("\"$OCELLI\" observe " + quoted("a.svol") + " --size 90x60 --turntable 100000 -o " + quoted("turn") +
               " & while [ ! -e " + quoted("turn.partial/frame_0002.png") +
               " ] && kill -0 $!; do sleep 0.02; done; kill -TERM $!; wait $!");
  EXPECT_EQ(result.exitCode, 1) << result.error;
  EXPECT_THAT(result.error, HasSubstr("interrupted"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "turn"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "turn.partial"));
}

TEST_F(DisplayCommands, observeRefusesWhatMakesNoSense) {
  folder_.write("way.csv", "time,x,y,z\n0,0,0,10\n1,0,0,-10\n");
  const std::pair<const char*, const char*> cases[] = {{"--turntable 3", "x.png"},
                                                       {"", "folder"},
                                                       {"--turntable 0", "folder"},
                                                       {"--turntable 3 --rate 0", "folder"},
                                                       {"--stereo -1", "x.png"},
                                                       {"--side-by-side", "x.png"},
                                                       {"--gain 2", "x.exr"},
                                                       {"--tone sepia", "x.png"},
                                                       {"--start 3 --missing-sector 3", "x.png"},
                                                       {"--frame 1", "x.png"},
                                                       {"--fov 1e-306 --size 8x8", "x.png"},
                                                       {"--focus 1", "x.png"},
                                                       {"--rate 12", "x.png"},
                                                       {"--start soon", "x.png"},
                                                       {"--wobble 9", "x.png"},
                                                       {"--wobble 0.005 --wobble-direction 0,0,0", "x.png"},
                                                       {"--ambient -1", "x.png"},
                                                       {"--dead-zone 1", "x.png"},
                                                       {"--aperture nan", "x.png"}};
  for (const auto& [options, output] : cases) {
    const ProgramResult result = runProgram("observe " + quoted("a.svol") + " " + options + " -o " + quoted(output));
    EXPECT_EQ(result.exitCode, 2) << options << result.error;
    EXPECT_FALSE(std::filesystem::exists(folder_ / output)) << options;
  }
  const ProgramResult through =
      runProgram("observe " + quoted("a.svol") + " --path " + quoted("way.csv") + " --rate 8 -o " + quoted("folder"));
  EXPECT_EQ(through.exitCode, 2);
  EXPECT_THAT(through.error, AllOf(HasSubstr("inside of the display"), HasSubstr("way.csv, between poses 1 and 2")));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "folder"));
  for (const auto& [command, output] : {std::pair("observe", "x.png"), std::pair("volume export", "x.vti")}) {
    const ProgramResult before =
        runProgram(std::string(command) + " " + quoted("a.svol") + " --frame -1 -o " + quoted(output));
    EXPECT_EQ(before.exitCode, 2) << command;
    EXPECT_THAT(before.error, AllOf(HasSubstr("-1 is no frame number"), HasSubstr("--frame"))) << command;
  }
}

TEST_F(DisplayCommands, aViewingDistanceInTheDisplayIsNamed) {
  folder_.write("near.json", R"({"name": "near", "radius_metres": 0.127, "slices_per_half_turn": 24, "width": 64,
      "height": 64, "rotations_per_minute": 720, "second_half_turn": "mirrored", "viewing_distance_metres": 0.01})");
  folder_.write("way.csv", "time,x,y,z\n0,0,0,10\n1,3,0,9\n");
  ASSERT_EQ(runProgram("slice builtin:teapot,segments=4 --profile " + quoted("near.json") + " -o " + quoted("n.svol"))
                .exitCode,
            0);
  const auto observe = [&](const std::string& options, const char* output) {
    return runProgram("observe " + quoted("n.svol") + " --size 20x20 " + options + " -o " + quoted(output));
  };
  const ProgramResult inside = observe("", "x.png");
  EXPECT_EQ(inside.exitCode, 2);
  EXPECT_THAT(inside.error, AllOf(HasSubstr("inside of the display"), HasSubstr("viewing_distance_metres")));
  EXPECT_THAT(observe("--eye 0,0,0.5", "x.png").error, testing::Not(HasSubstr("viewing_distance_metres")));
  EXPECT_EQ(observe("--eye 0,0,9", "x.png").exitCode, 0);
  EXPECT_EQ(observe("--path " + quoted("way.csv") + " --rate 2", "way").exitCode, 0) << "the default eye is not used";
}

TEST_F(DisplayCommands, volumeInfoVerifyAndExport) {
  const ProgramResult info = runProgram("volume info --json " + quoted("a.svol"));
  ASSERT_EQ(info.exitCode, 0) << info.error;
  EXPECT_EQ(nlohmann::json::parse(info.output)["profile"]["name"], "test");
  EXPECT_THAT(runProgram("volume info " + quoted("a.svol")).output, HasSubstr("24 of 64x64"));
  EXPECT_THAT(runProgram("volume verify " + quoted("a.svol")).output, HasSubstr("1 frame of 24 slices, all whole"));
  for (const char* output : {"a.vti", "a.nrrd", "a.kv6", "slices", "a.png"}) {
    EXPECT_EQ(runProgram("volume export " + quoted("a.svol") + " -o " + quoted(output)).exitCode, 0) << output;
  }
  EXPECT_TRUE(fileBytes(folder_ / "a.nrrd").starts_with("NRRD0005"));
  EXPECT_TRUE(fileBytes(folder_ / "a.vti").starts_with("<?xml"));
  EXPECT_FALSE(kv6FromBytes(fileBytes(folder_ / "a.kv6"), "a.kv6").voxels.empty());
  EXPECT_EQ(readPng(folder_ / "slices/slice_0023.png").width(), 64);
}

TEST_F(DisplayCommands, aFileCannotSteerTheTerminal) {
  writeSvol(folder_ / "b.svol", readSvol(folder_ / "a.svol"),
            R"({"scene": "x\n  lit voxels  7\u001b[2J\u0000", "\u009b1m": "\u007f"})");
  const ProgramResult info = runProgram("volume info " + quoted("b.svol"));
  ASSERT_EQ(info.exitCode, 0) << info.error;
  EXPECT_THAT(info.output, AllOf(HasSubstr(R"(  scene       x\n  lit voxels  7\x1b[2J\x00)"), HasSubstr(R"(\u009b1m)"),
                                 HasSubstr(R"(\x7f)"), HasSubstr("of which 1 needs no other")));
  EXPECT_TRUE(
      std::ranges::none_of(info.output, [](char c) { return c != '\n' && (c == 0x7f || (c >= 0 && c < ' ')); }));
}

TEST_F(DisplayCommands, anInterruptedExportOrJoinLeavesNothing) {
  const std::string commands[] = {"export a.svol --pixels 2048 -o x.png",
                                  "join $(yes a.svol | head -n 20000) -o x.svol"};
  for (const std::string& command : commands) {
    // Once a file is there. A shell's background work ignores Ctrl-C, so it is SIGTERM.
    const ProgramResult result = runShell("cd " + quoted("") + " && { \"$OCELLI\" volume " + command +
                                          " & while ! ls | grep -q partial && kill -0 $!; do sleep 0.01; done; "
                                          "kill -TERM $!; wait $!; }");
    EXPECT_EQ(result.exitCode, 1) << result.error;
    EXPECT_THAT(result.error, HasSubstr("interrupted"));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_ / ""), {}), 1) << command;
  }
}

TEST_F(DisplayCommands, volumeRefusesWhatDoesNotApply) {
  for (const char* arguments :
       {"export a.svol --frame 0 -o x.png", "export a.svol --cells 16 -o x.nrrd", "export a.svol --cells 16 -o x.png",
        "export a.svol --cells 16 -o x", "export a.svol --pixels 99 -o x.vti", "export a.svol --pixels 99 -o x",
        "join a.svol --fps nan -o x.svol", "join a.svol --fps 0 -o x.svol"}) {
    const ProgramResult result = runShell("cd " + quoted("") + " && \"$OCELLI\" volume " + arguments);
    EXPECT_EQ(result.exitCode, 2) << arguments << result.error;
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_ / ""), {}), 1) << arguments;
  }
}

TEST_F(DisplayCommands, aRecordingCutInItsFirstFrameIsNotToBeSalvaged) {
  const std::string bytes = fileBytes(folder_ / "a.svol");
  folder_.write("cut.svol", bytes.substr(0, bytes.size() - svol::indexBytes(1) - svol::kEndBytes - 1));
  const ProgramResult verified = runProgram("volume verify " + quoted("cut.svol"));
  EXPECT_EQ(verified.exitCode, 1);
  EXPECT_THAT(verified.error, AllOf(HasSubstr("unfinished"), Not(HasSubstr("--salvage"))));
  EXPECT_THAT(runProgram("volume info " + quoted("cut.svol")).output,
              AllOf(HasSubstr("without a whole frame"), Not(HasSubstr("uncompressed"))));
}

TEST_F(DisplayCommands, volumesAreJoinedToRecordings) {
  const ProgramResult joined =
      runProgram("volume join " + quoted("a.svol") + " " + quoted("a.svol") + " --fps 2 -o " + quoted("film.svol"));
  ASSERT_EQ(joined.exitCode, 0) << joined.error;
  const auto info = nlohmann::json::parse(runProgram("volume info --frames --json " + quoted("film.svol")).output);
  EXPECT_EQ(info["frames"], 2);
  EXPECT_EQ(info["state"], "whole");
  EXPECT_EQ(info["metadata"]["scene"], "builtin:teapot,segments=4");
  EXPECT_EQ(info["frame_table"][1]["seconds"], 0.5);
  EXPECT_EQ(info["frame_table"][1]["unchanged"], 24);
  EXPECT_THAT(runProgram("volume info --frames " + quoted("film.svol")).output, HasSubstr("0.500000  delta"));
  EXPECT_EQ(runProgram("volume export --frame 1 " + quoted("film.svol") + " -o " + quoted("b.nrrd")).exitCode, 0);
  EXPECT_EQ(runProgram("volume export --frame 2 " + quoted("film.svol") + " -o " + quoted("c.nrrd")).exitCode, 2);
}

TEST_F(DisplayCommands, aRecordingBecomesNumberedFiles) {
  Volume second = readSvol(folder_ / "a.svol");
  second.light(3, 40, 20, 7);
  writeSvol(folder_ / "b.svol", second);
  ASSERT_EQ(
      runProgram("volume join " + quoted("a.svol") + " " + quoted("b.svol") + " -o " + quoted("film.svol")).exitCode,
      0);
  const ProgramResult each =
      runProgram("volume export " + quoted("film.svol") + " --each-frame kv6 --cells 40 -o " + quoted("models"));
  ASSERT_EQ(each.exitCode, 0) << each.error;
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_ / "models"), {}), 2);
  for (const int frame : {0, 1}) {
    const std::string number = std::to_string(frame);
    EXPECT_EQ(runProgram("volume export " + quoted("film.svol") + " --frame " + number + " --cells 40 -o " +
                         quoted("one.kv6"))
                  .exitCode,
              0);
    EXPECT_EQ(fileBytes(folder_ / "one.kv6"), fileBytes(folder_ / ("models/frame_000" + number + ".kv6")));
  }
  EXPECT_NE(fileBytes(folder_ / "models/frame_0000.kv6"), fileBytes(folder_ / "models/frame_0001.kv6"));
  for (const char* arguments : {"--each-frame png -o x", "--each-frame obj -o x", "--each-frame kv6 -o x.kv6",
                                "--each-frame kv6 --frame 1 -o x", "--each-frame nrrd --cells 9 -o x"}) {
    const ProgramResult refused = runShell("cd " + quoted("") + " && \"$OCELLI\" volume export film.svol " + arguments);
    EXPECT_EQ(refused.exitCode, 2) << arguments << refused.error;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "x"));
  }
}

TEST_F(DisplayCommands, anUnfinishedRecordingIsToldFromADamagedOne) {
  const std::string bytes = fileBytes(folder_ / "a.svol");
  folder_.write("cut.svol", bytes.substr(0, bytes.size() - 1));
  const ProgramResult verified = runProgram("volume verify " + quoted("cut.svol"));
  EXPECT_EQ(verified.exitCode, 1);
  EXPECT_THAT(verified.error, AllOf(HasSubstr("unfinished"), HasSubstr("1 frame"), HasSubstr("--salvage")));
  EXPECT_THAT(runProgram("volume info " + quoted("cut.svol")).output, HasSubstr("unfinished"));
  EXPECT_EQ(runProgram("volume join " + quoted("cut.svol") + " -o " + quoted("b.svol")).exitCode, 2);
  EXPECT_EQ(runProgram("volume join --salvage " + quoted("cut.svol") + " -o " + quoted("b.svol")).exitCode, 0);
  EXPECT_EQ(fileBytes(folder_ / "b.svol"), bytes);
}

TEST_F(DisplayCommands, aFileOfAnotherKindIsNotOverwritten) {
  folder_.write("mesh.stl", "mine");
  const ProgramResult result = runProgram("slice builtin:box --profile test -o " + quoted("mesh.stl"));
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.error, AllOf(HasSubstr("mesh.stl"), HasSubstr(".svol")));
  EXPECT_EQ(fileBytes(folder_ / "mesh.stl"), "mine");
}

TEST_F(DisplayCommands, exitCodesTellWhoseFaultItIs) {
  std::string bytes = fileBytes(folder_ / "a.svol");
  bytes[bytes.size() / 2] ^= 1;
  folder_.write("damaged.svol", bytes);
  const ProgramResult damaged = runProgram("volume verify " + quoted("damaged.svol"));
  EXPECT_EQ(damaged.exitCode, 2);
  EXPECT_THAT(damaged.error, AllOf(HasSubstr("damaged.svol"), HasSubstr("slice "), HasSubstr("checksum")));
  EXPECT_EQ(runProgram("observe " + quoted("damaged.svol") + " -o " + quoted("x.png")).exitCode, 2);
  EXPECT_EQ(runProgram("observe " + quoted("a.svol") + " --eye 0,0,0.5 -o " + quoted("x.png")).exitCode, 2);
  EXPECT_EQ(runProgram("observe " + quoted("a.svol") + " --exposure soon -o " + quoted("x.png")).exitCode, 2);
  EXPECT_EQ(runProgram("volume info " + quoted("missing.svol")).exitCode, 2);
  EXPECT_EQ(runProgram("volume export " + quoted("a.svol") + " -o " + quoted("a.txt")).exitCode, 2);
  EXPECT_EQ(runProgram("slice builtin:teapot --profile nothing -o " + quoted("x.svol")).exitCode, 2);
  const ProgramResult unwritable =
      runProgram("slice builtin:teapot,segments=4 --profile test -o /no/such/folder/x.svol");
  EXPECT_EQ(unwritable.exitCode, 1);
  EXPECT_THAT(unwritable.error, AllOf(HasSubstr("/no/such/folder/x.svol"), HasSubstr("try:")));
}

}  // namespace
}  // namespace ocelli::test
