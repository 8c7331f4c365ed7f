// Volumes of scalars on displays, from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "display_sim/frames/svol_file.h"
#include "display_sim/frames/svol_reader.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

const std::string kVolume = "builtin:volume,name=marschner-lobb,size=32";

size_t litVoxelsOf(const std::string& arguments) {
  const TemporaryFolder folder;
  const ProgramResult result =
      runProgram("slice " + arguments + " --profile test --json -o " + inQuotes(folder / "a.svol"));
  EXPECT_EQ(result.exitCode, 0) << result.error;
  if (result.exitCode != 0) {
    return 0;
  }
  const nlohmann::json json = nlohmann::json::parse(result.output);
  EXPECT_EQ(json["size"], nlohmann::json({32, 32, 32}));
  EXPECT_EQ(readSvol(folder / "a.svol").litVoxels(), json["lit_voxels"]);
  return json["lit_voxels"];
}

TEST(VolumeDisplay, SlicesVolumesAndWhatIsLeftOfThem) {
  const size_t all = litVoxelsOf(kVolume);
  EXPECT_GT(all, 500u);
  const size_t clipped = litVoxelsOf(kVolume + " --clip 'x>0'");
  EXPECT_GT(clipped, all / 4);
  EXPECT_LT(clipped, all * 3 / 4);
  const size_t masked = litVoxelsOf(kVolume + " --mask 0.8:1");
  EXPECT_GT(masked, 0u);
  EXPECT_LT(masked, all);
  const size_t cut = litVoxelsOf(kVolume + " --cutaway 0 --viewer 10,0,0");
  EXPECT_GT(cut, all / 4);
  EXPECT_LT(cut, all * 3 / 4);
  const size_t seen = litVoxelsOf(kVolume + " --seen-opacity 0.5");
  EXPECT_LT(seen, all * 3 / 4);
  EXPECT_GT(litVoxelsOf(kVolume + " --seen-opacity 0.5 --viewer 0,0,10 --viewer 0,0,-10"), seen);
  const size_t weighed = litVoxelsOf(kVolume + " --gradient-light 0.5");
  EXPECT_GT(weighed, 0u);
  EXPECT_LT(weighed, all);
  EXPECT_GT(litVoxelsOf(kVolume + " --light-gain 4"), all);
  EXPECT_GT(litVoxelsOf(kVolume + " --iso 0.5 --dither blue-noise"), 300u);
  EXPECT_GT(litVoxelsOf(kVolume + " --undithered"), all);
}

TEST(VolumeDisplay, TakesAnotherVolumeForTheMask) {
  // Its own values of a half and more, at the nearest voxel.
  const size_t all = litVoxelsOf(kVolume);
  const size_t masked = litVoxelsOf(kVolume + " --mask " + kVolume);
  const size_t range = litVoxelsOf(kVolume + " --mask 0.5:1");
  EXPECT_LT(masked, all);
  // They differ in the cells that hold 0.5, of which a small display has many: of these the range lets a part of the
  // light pass, and the mask weighs them by eighths.
  EXPECT_NEAR(static_cast<double>(masked), static_cast<double>(range), 0.15 * static_cast<double>(range));
}

TEST(VolumeDisplay, PresentsVolumesThatTurnAndWhoseTransferFunctionMoves) {
  const TemporaryFolder folder;
  const auto framesOf = [&](const std::string& options) {
    const ProgramResult result = runProgram(
        "present " + kVolume + " --profile test --device file:" + inQuotes(folder / "r.svol") + " " + options);
    EXPECT_EQ(result.exitCode, 0) << result.error;
    return SvolReader(folder / "r.svol").frames().size();
  };
  EXPECT_EQ(framesOf("--seconds 0.3"), 1u);
  EXPECT_GT(framesOf("--turn 90 --seconds 0.5"), 3u);
  EXPECT_GT(framesOf("--transfer-to hot --transfer-seconds 1 --seconds 0.5"), 3u);
}

TEST(VolumeDisplay, ComparesWaysToShowVolumes) {
  const TemporaryFolder folder;
  const ProgramResult result = runProgram(
      "solidity " + kVolume + " --profile test --interior 0 --image-side 32 --ways everything,seen --json -");
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const nlohmann::json rows = nlohmann::json::parse(result.output)["representations"];
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0]["name"], "everything");
  EXPECT_GT(rows[0]["reference"]["hidden_light"], 0.2);
  EXPECT_LT(rows[1]["reference"]["hidden_light"], 0.01);
}

TEST(VolumeDisplay, ErrorsSayWhatToDo) {
  const TemporaryFolder folder;
  const auto errorOf = [&](const std::string& arguments) {
    const ProgramResult result = runProgram(arguments);
    EXPECT_EQ(result.exitCode, 2) << arguments << result.output;
    return result.error;
  };
  const std::string output = " --profile test -o " + inQuotes(folder / "a.svol");
  EXPECT_THAT(errorOf("slice " + kVolume + " --even-light 0.5" + output), HasSubstr("--even-light"));
  EXPECT_THAT(errorOf("slice " + kVolume + " --antialias" + output), HasSubstr("--antialias"));
  EXPECT_THAT(errorOf("slice " + kVolume + " --exact" + output), HasSubstr("--exact"));
  EXPECT_THAT(errorOf("slice " + kVolume + " --mask nothing" + output), HasSubstr("neither a volume nor a range"));
  EXPECT_THAT(errorOf("slice " + kVolume + " --mask 3:1" + output), HasSubstr("LEAST:GREATEST"));
  EXPECT_THAT(errorOf("slice " + kVolume + " --mask 0:1 --iso 0.5" + output), HasSubstr("one value alone"));
  EXPECT_THAT(errorOf("slice " + kVolume + " --iso 7" + output), HasSubstr("its values run from"));
  EXPECT_THAT(errorOf("slice " + kVolume + " --viewer 0,0,10" + output), HasSubstr("--seen-opacity"));
  EXPECT_THAT(errorOf("slice " + kVolume + " --viewer 0,0,0.5 --cutaway 0" + output), HasSubstr("display"));
  EXPECT_THAT(errorOf("slice builtin:teapot --gradient-light 0.2" + output), HasSubstr("for volumes alone"));
  EXPECT_THAT(errorOf("slice builtin:teapot --seen-opacity 0.2" + output), HasSubstr("for volumes alone"));
  EXPECT_THAT(errorOf("present " + kVolume + " --device null --camera ddoc"), HasSubstr("--seen-opacity"));
  EXPECT_THAT(errorOf("present " + kVolume + " --device null --eyes x.csv"), HasSubstr("--viewer"));
  EXPECT_THAT(errorOf("present " + kVolume + " --device null --transfer-seconds 3"), HasSubstr("--transfer-to"));
  EXPECT_THAT(errorOf("present " + kVolume + " --device null --turn 30 --seen-opacity 0.5"), HasSubstr("--turn"));
  EXPECT_THAT(errorOf("solidity " + kVolume + " --iso 7"), HasSubstr("its values run from"));
  EXPECT_THAT(errorOf("solidity " + kVolume + " --cameras di"), HasSubstr("--ways"));
  EXPECT_THAT(errorOf("solidity " + kVolume + " --ways all"), HasSubstr("everything"));
  EXPECT_THAT(errorOf("solidity builtin:teapot --ways seen"), HasSubstr("for volumes alone"));
}

TEST(VolumeDisplay, SaysWhereNothingIsLit) {
  const TemporaryFolder folder;
  const ProgramResult result =
      runProgram("slice " + kVolume + " --profile test --mask 7:8 -o " + inQuotes(folder / "a.svol"));
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_THAT(result.error, HasSubstr("nothing of the volume has light"));
}

}  // namespace
}  // namespace ocelli::test
