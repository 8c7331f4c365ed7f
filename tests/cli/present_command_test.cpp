// `ocelli present` from outside. Nothing here says how many refreshes are in time: that is the machine's affair.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "display_sim/frames/svol_file.h"
#include "display_sim/frames/svol_player.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class PresentCommand : public testing::Test {
 protected:
  std::string quoted(const std::string& name) const { return fmt::format("'{}'", (folder_ / name).string()); }
  std::string toFile(const std::string& name) const {
    return fmt::format(" --device 'file:{}' ", (folder_ / name).string());
  }

  TemporaryFolder folder_;
};

constexpr const char* kTeapot = "builtin:teapot,segments=4 --profile test ";

TEST_F(PresentCommand, aStillSceneIsShownAsSliceMakesIt) {
  const ProgramResult sliced = runProgram(std::string("slice ") + kTeapot + "-o " + quoted("a.svol"));
  ASSERT_EQ(sliced.exitCode, 0) << sliced.error;
  const ProgramResult shown = runProgram(std::string("present ") + kTeapot + toFile("shown.svol") + "--seconds 0.4");
  ASSERT_EQ(shown.exitCode, 0) << shown.error;
  EXPECT_THAT(shown.output, AllOf(HasSubstr("on file (test)"), HasSubstr("making"), HasSubstr("from making to light")));
  SvolReader reader(folder_ / "shown.svol");
  EXPECT_EQ(reader.ending(), SvolEnding::kFinished);
  ASSERT_EQ(reader.frames().size(), 1u);
  EXPECT_EQ(readSvol(folder_ / "shown.svol"), readSvol(folder_ / "a.svol"));
}

TEST_F(PresentCommand, aRecordingIsShownAndItsTimeLineIsATable) {
  ASSERT_EQ(runProgram(std::string("present ") + kTeapot + toFile("turning.svol") + "--turn 90 --seconds 0.5").exitCode,
            0);
  const ProgramResult again = runProgram("present " + quoted("turning.svol") + toFile("again.svol") +
                                         "--follow --json --seconds 5 --timeline " + quoted("line.csv"));
  ASSERT_EQ(again.exitCode, 0) << again.error;
  const auto json = nlohmann::json::parse(again.output);
  EXPECT_EQ(json["device"], "file");
  EXPECT_EQ(json["profile"], "test");
  uint64_t sum = 0;
  for (const auto& [name, count] : json["outcomes"].items()) {
    sum += count.get<uint64_t>();
  }
  EXPECT_EQ(sum, json["refreshes"]);
  const std::string line = fileBytes(folder_ / "line.csv");
  EXPECT_THAT(line, testing::StartsWith("refresh,due_ms,frame,outcome,"));
  EXPECT_EQ(static_cast<uint64_t>(std::ranges::count(line, '\n')), 1 + json["refreshes"].get<uint64_t>());
  // What was shown is some of what was recorded.
  SvolReader recorded(folder_ / "turning.svol");
  SvolReader shown(folder_ / "again.svol");
  EXPECT_GE(shown.frames().size(), 1u);
  EXPECT_LE(shown.frames().size(), recorded.frames().size());
}

TEST_F(PresentCommand, eyesComeAsLinesAndWrongOnesAreToldOnce) {
  const ProgramResult result =
      runShell("printf 'time,x,y,z\\n0,0,0,10\\nnonsense\\nmore\\n1,2,0,9.5\\n' | \"$OCELLI\" present " +
               std::string(kTeapot) + "--device null --eyes - --camera di --size 90x60 --json");
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_EQ(json["malformed_eyes"], 2);
  EXPECT_GE(json["frames_shown"], 1);
  EXPECT_EQ(result.error.find("nonsense"), result.error.rfind("nonsense"));
  EXPECT_THAT(result.error, HasSubstr("nonsense"));
}

TEST_F(PresentCommand, aFolderOfMeshesIsAnAnimation) {
  std::filesystem::create_directory(folder_ / "walk");
  for (const char* name : {"sphere", "torus", "box"}) {
    const std::string file = quoted(fmt::format("walk/walk_{}.ply", static_cast<int>(name[0])));
    ASSERT_EQ(runProgram(fmt::format("scene export builtin:{} -o {}", name, file)).exitCode, 0);
  }
  const ProgramResult result =
      runProgram("present " + quoted("walk") + " --profile test --rate 10 --shading none" + toFile("walk.svol"));
  ASSERT_EQ(result.exitCode, 0) << result.error;
  SvolReader reader(folder_ / "walk.svol");
  EXPECT_GE(reader.frames().size(), 1u);
  EXPECT_LE(reader.frames().size(), 3u);
}

TEST_F(PresentCommand, whatMovesIsPlayedWithACameraAndForAnEye) {
  folder_.write("way.csv", "time,x,y,z\n0,0,0,10\n0.1,0.5,0,10\n");
  const std::string moving = "present 'builtin:waving,seconds=0.5' --profile test --device null --json ";
  for (const std::string options :
       {"", "--camera di --size 90x60", "--speed 2", "--camera eoc-h --size 90x60 --loop --seconds 0.4"}) {
    const ProgramResult result = runProgram(moving + options);
    ASSERT_EQ(result.exitCode, 0) << result.error;
    EXPECT_GE(nlohmann::json::parse(result.output)["frames_shown"], 2) << options;
  }
  const ProgramResult seen =
      runProgram(moving + "--camera di --size 90x60 --loop --eyes " + quoted("way.csv") + " --seconds 0.4");
  ASSERT_EQ(seen.exitCode, 0) << seen.error;
  EXPECT_THAT(seen.output, HasSubstr("motion"));
  EXPECT_EQ(runProgram("present 'builtin:waving' --time 1 --profile test --device null --seconds 0.1").exitCode, 0);
}

TEST_F(PresentCommand, aDeviceLogGivesAnotherDeviceTheSameVolumes) {
  const ProgramResult recorded = runProgram(std::string("present ") + kTeapot + toFile("first.svol") +
                                            "--turn 90 --seconds 0.5 --record " + quoted("a.session"));
  ASSERT_EQ(recorded.exitCode, 0) << recorded.error;
  const ProgramResult played = runProgram("present " + quoted("a.session") + toFile("again.svol") + "--fast --json");
  ASSERT_EQ(played.exitCode, 0) << played.error;
  const auto json = nlohmann::json::parse(played.output);
  EXPECT_TRUE(json["whole"]);
  EXPECT_EQ(json["frames_shown"], json["frames_submitted"]);
  // Frames that were dropped the first time are shown, too: all that were shown then are among those of now.
  SvolReader first(folder_ / "first.svol");
  SvolReader again(folder_ / "again.svol");
  EXPECT_GE(again.frames().size(), first.frames().size());
  SvolPlayer firstPlayer(first);
  SvolPlayer againPlayer(again);
  size_t at = 0;
  for (size_t i = 0; i < first.frames().size(); ++i, ++at) {
    firstPlayer.seek(i);
    do {
      ASSERT_LT(at, again.frames().size()) << i;
      againPlayer.seek(at);
    } while (!(againPlayer.volume() == firstPlayer.volume()) && ++at < again.frames().size() + 1);
  }
}

TEST_F(PresentCommand, anInterruptEndsItCleanly) {
  // Shells let programs in the background ignore interrupts; this one must not. It is interrupted once it presents.
  const ProgramResult result = runShell(
      "env --default-signal=INT \"$OCELLI\" present " + std::string(kTeapot) + toFile("cut.svol") +
      " & program=$!; until [ -s " + quoted("cut.svol") +
      " ] || ! kill -0 $program; do sleep 0.05; done; sleep 0.2; kill -INT $program; wait $program; echo code $?");
  EXPECT_THAT(result.output, AllOf(HasSubstr("on file (test)"), HasSubstr("code 0")));
  EXPECT_EQ(SvolReader(folder_ / "cut.svol").ending(), SvolEnding::kFinished);
}

TEST_F(PresentCommand, whatIsNeverShownLeavesTheFileAsItWas) {
  const std::string keep = folder_.write("keep.svol", "not to be lost").string();
  EXPECT_EQ(runProgram("device info" + std::string(" 'file:") + keep + "'").exitCode, 0);
  EXPECT_EQ(runProgram("present builtin:teapt" + toFile("keep.svol")).exitCode, 2);
  const ProgramResult itself = runProgram("present " + quoted("keep.svol") + toFile("keep.svol"));
  EXPECT_EQ(itself.exitCode, 2);
  EXPECT_THAT(itself.error, HasSubstr("would be replaced"));
  EXPECT_EQ(fileBytes(keep), "not to be lost");
}

TEST_F(PresentCommand, aSingleFrameStays) {
  ASSERT_EQ(runProgram(std::string("slice ") + kTeapot + "-o " + quoted("a.svol")).exitCode, 0);
  const ProgramResult shown = runProgram("present " + quoted("a.svol") + " --device null --seconds 0.6 --json");
  ASSERT_EQ(shown.exitCode, 0) << shown.error;
  EXPECT_GE(nlohmann::json::parse(shown.output)["seconds"], 0.3);
}

TEST_F(PresentCommand, whereNothingCanBeSeenThatIsAnError) {
  const ProgramResult blind =
      runProgram("present " + std::string(kTeapot) + "--device null --eyes - --camera di --size 90x60 </dev/null");
  EXPECT_EQ(blind.exitCode, 1);
  EXPECT_THAT(blind.error, HasSubstr("no eye ever came"));
  EXPECT_THAT(blind.output, HasSubstr("refreshes"));
  const ProgramResult absent =
      runProgram("present " + std::string(kTeapot) + "--device multivox:ocelli_is_not_there --seconds 0.3");
  EXPECT_EQ(absent.exitCode, 1);
  EXPECT_THAT(absent.error, HasSubstr("no frame was ever shown"));
}

/// Shared memory of a multivox display of this name, of 128 x 128 x 64 cells.
std::string memoryOf(const std::string& name) {
  return "/dev/shm/" + name + "_double_buffer";
}

TEST_F(PresentCommand, aDisplayThatIsNotThereIsToldAtOnceAndTakenWhenItComes) {
  const std::string name = fmt::format("ocelli_late_{}", getpid());
  const ProgramResult result =
      runShell("\"$OCELLI\" present " + std::string(kTeapot) + "--device multivox:" + name + " --seconds 20 --json 2>" +
               quoted("notes") + " & program=$!; while ! grep -q 'not there' " + quoted("notes") +
               " && kill -0 $program; do sleep 0.05; done; cp " + quoted("notes") + " " + quoted("early") +
               "; head -c 2097160 /dev/zero >" + memoryOf(name) +
               "; sleep 1.5; kill -TERM $program; wait $program; echo code $?; rm -f " + memoryOf(name));
  EXPECT_THAT(fileBytes(folder_ / "early"),
              AllOf(HasSubstr("the display is not there: there is no shared memory"), HasSubstr("./virtex"),
                    HasSubstr("waiting for it"), testing::Not(HasSubstr("is there, after"))));
  EXPECT_THAT(fileBytes(folder_ / "notes"), HasSubstr("the display is there, after"));
  EXPECT_THAT(result.output, HasSubstr("code 0"));
  const auto json = nlohmann::json::parse(result.output.substr(0, result.output.rfind('}') + 1));
  EXPECT_GE(json["frames_shown"], 1);
}

TEST_F(PresentCommand, waitingForADisplayEndsWithTheTimeOrASignal) {
  const ProgramResult absent =
      runProgram("present " + std::string(kTeapot) + "--device multivox:ocelli_is_not_there --seconds 0.6");
  EXPECT_EQ(absent.exitCode, 1);
  EXPECT_THAT(absent.error,
              AllOf(HasSubstr("waiting for it"), HasSubstr("no frame was ever shown: there is no shared")));
  // Once it says that it waits.
  const ProgramResult stopped =
      runShell("\"$OCELLI\" present " + std::string(kTeapot) + "--device multivox:ocelli_is_not_there --seconds 60 2>" +
               quoted("said") + " & while kill -0 $! && ! grep -q 'Ctrl-C ends this' " + quoted("said") +
               "; do sleep 0.02; done; kill -TERM $!; wait $!");
  EXPECT_EQ(stopped.exitCode, 0) << stopped.error;
  EXPECT_THAT(stopped.output, HasSubstr("0 refreshes"));
}

TEST_F(PresentCommand, theTextTellsOfEyesThatCouldNotBeUsed) {
  const ProgramResult result =
      runShell("printf 'time,x,y,z\\n0,0,0,10\\n0,1,zwei,3\\nmore\\n1,2,0,9.5\\n' | \"$OCELLI\" present " +
               std::string(kTeapot) + "--device null --eyes - --camera di --size 90x60");
  ASSERT_EQ(result.exitCode, 0) << result.error;
  EXPECT_THAT(result.error, HasSubstr("not TIME,X,Y,Z (y is not a number): \"0,1,zwei,3\""));
  EXPECT_THAT(result.output, HasSubstr("2 lines could not be used; the first: not TIME,X,Y,Z (y is not a number)"));
}

TEST_F(PresentCommand, logsThatAreCutOrDamagedSaySo) {
  ASSERT_EQ(
      runProgram(std::string("present ") + kTeapot + "--device null --seconds 0.4 --record " + quoted("a.session"))
          .exitCode,
      0);
  const std::string whole = fileBytes(folder_ / "a.session");
  folder_.write("cut.session", whole.substr(0, whole.find("RECD", whole.find("RECD") + 4) + 40));
  std::string damaged = whole;
  damaged[damaged.rfind("RECD") + 4] ^= 1;
  folder_.write("damaged.session", damaged);
  const ProgramResult cut = runProgram("present " + quoted("cut.session") + " --device null");
  EXPECT_EQ(cut.exitCode, 2);
  EXPECT_THAT(cut.error, HasSubstr("before its first frame"));
  const ProgramResult bad = runProgram("present " + quoted("damaged.session") + " --device null --fast");
  EXPECT_EQ(bad.exitCode, 2);
  EXPECT_THAT(bad.error, HasSubstr("is wrong"));
  EXPECT_THAT(bad.output, HasSubstr("frames submitted"));
}

TEST_F(PresentCommand, everyFrameOfALogOnADisplayThatIsNotThereIsCounted) {
  ASSERT_EQ(runProgram(std::string("present ") + kTeapot + "--device null --turn 30 --seconds 0.4 --record " +
                       quoted("a.session"))
                .exitCode,
            0);
  const ProgramResult played =
      runProgram("present " + quoted("a.session") + " --device multivox:ocelli_is_not_there --json");
  EXPECT_EQ(played.exitCode, 1);
  const auto json = nlohmann::json::parse(played.output);
  EXPECT_EQ(json["frames_shown"], 0);
  EXPECT_EQ(json["frames_dropped"].get<int>() + json["frames_lost"].get<int>(), json["frames_submitted"].get<int>());
}

TEST_F(PresentCommand, imagesHaveOneOfTheFormatsThatThereAre) {
  const auto error = [&](const std::string& options) {
    const ProgramResult result = runProgram("present " + std::string(kTeapot) + "--device sim " + options);
    EXPECT_EQ(result.exitCode, 2) << options;
    return result.error;
  };
  EXPECT_THAT(error("--watch " + quoted("w.gif")), HasSubstr(".mp4"));
  EXPECT_THAT(error("--watch " + quoted("w") + " --watch-size 0x0"), HasSubstr("--watch-size"));
  EXPECT_THAT(error("--link usb9"), HasSubstr("unlimited"));
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
}

TEST_F(PresentCommand, aDisplayThatCannotBeReachedIsSaid) {
  const auto present = [](const std::string& device) {
    return runProgram("present " + std::string(kTeapot) + "--device " + device);
  };
  const ProgramResult nobody = present("multivox:127.0.0.1:1");
  EXPECT_EQ(nobody.exitCode, 1);
  EXPECT_THAT(nobody.error, testing::AllOf(HasSubstr("refused"), HasSubstr("127.0.0.1")));
  const ProgramResult unknown = present("multivox:no-such-host.invalid");
  EXPECT_EQ(unknown.exitCode, 2);
  EXPECT_THAT(unknown.error, HasSubstr("not known"));
  const ProgramResult noLine = present("serial:/dev/no_such_line");
  EXPECT_EQ(noLine.exitCode, 1);
  EXPECT_THAT(noLine.error, HasSubstr("/dev/no_such_line"));
}

TEST_F(PresentCommand, whatDoesNotGoTogetherIsRefused) {
  const auto refusal = [](const std::string& arguments) {
    const ProgramResult result = runProgram("present " + arguments);
    EXPECT_EQ(result.exitCode, 2) << arguments;
    return result.error;
  };
  ASSERT_EQ(runProgram(std::string("slice ") + kTeapot + "-o " + quoted("a.svol")).exitCode, 0);
  EXPECT_THAT(refusal("builtin:teapot"), HasSubstr("--device"));
  EXPECT_THAT(refusal("builtin:teapot --device nowhere"), HasSubstr("null"));
  EXPECT_THAT(refusal("builtin:teapot --device null --follow"), HasSubstr("nothing moves"));
  EXPECT_THAT(refusal("builtin:teapot --device null --turn 5 --eyes a.csv"), HasSubstr("either"));
  EXPECT_THAT(refusal("builtin:teapot --device null --turn 5 --camera ddoc"), HasSubstr("without a camera"));
  EXPECT_THAT(refusal("builtin:teapot --device null --turn 5 --exact"), HasSubstr("fast slicer"));
  EXPECT_THAT(refusal("builtin:teapot --device null --turn nan"), HasSubstr("nan"));
  EXPECT_THAT(refusal("builtin:teapot --device null --eyes a.csv --camera none"), HasSubstr("changes nothing"));
  EXPECT_THAT(refusal("builtin:teapot --device null --profile test --eyes udp:0"), HasSubstr("port"));
  EXPECT_THAT(refusal("builtin:teapot --device null --rate 5"), HasSubstr("rate"));
  EXPECT_THAT(refusal("builtin:teapot --device null --speed 2"), HasSubstr("nothing moves by itself"));
  EXPECT_THAT(refusal("builtin:teapot --device null --time 0"), HasSubstr("does not move"));
  EXPECT_THAT(refusal("builtin:waving --device null --exact"), HasSubstr("fast slicer"));
  EXPECT_THAT(refusal(quoted("a.svol") + " --device null --turn 5"), HasSubstr("only a scene"));
  EXPECT_THAT(refusal(quoted("a.svol") + " --device null --profile test"), HasSubstr("profile already"));
  EXPECT_THAT(refusal(quoted("none.session") + " --device null"), HasSubstr("none.session"));
  EXPECT_THAT(refusal(quoted("none.session") + " --device null --loop"), HasSubstr("as it was"));
  EXPECT_THAT(refusal("builtin:teapot --device null --fast"), HasSubstr("device log"));
  EXPECT_THAT(refusal(quoted("none.svol") + " --device null"), HasSubstr("none.svol"));
  EXPECT_THAT(refusal(quoted("") + " --device null"), HasSubstr("no numbered mesh"));
}

}  // namespace
}  // namespace ocelli::test
