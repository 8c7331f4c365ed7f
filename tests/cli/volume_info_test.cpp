// `ocelli scene info` and `scene list` of volumes, from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "oc_core/volume/builtin_volumes.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(VolumeInfo, tellsTheGridAndTheValues) {
  const ProgramResult text = runProgram("scene info builtin:volume,name=skull,size=48");
  ASSERT_EQ(text.exitCode, 0) << text.error;
  EXPECT_THAT(text.output,
              AllOf(HasSubstr("voxels     48 x 48 x 48, int16\n"), HasSubstr("spacing    5 x 5 x 5 mm\n"),
                    HasSubstr("i to left, j to back, k to top, of a patient"), HasSubstr("modality   CT\n"),
                    HasSubstr(" HU\n"), HasSubstr("bytes      221184\n"), HasSubstr("transfer   one of its own\n")));
  const ProgramResult json = runProgram("scene info --json builtin:volume,name=skull,size=48");
  ASSERT_EQ(json.exitCode, 0) << json.error;
  const auto info = nlohmann::json::parse(json.output);
  EXPECT_EQ(info["size"], nlohmann::json({48, 48, 48}));
  EXPECT_EQ(info["unit"], "mm");
  EXPECT_EQ(info["anatomical"], true);
  EXPECT_EQ(info["least"], -1000);
  EXPECT_EQ(info["percentiles"].size(), 7U);
  EXPECT_EQ(info["percentiles"][0]["value"], -1000);
  EXPECT_EQ(info["not_finite"], 0);
  EXPECT_EQ(info["lower"], nlohmann::json({-120, -120, -120}));
  EXPECT_EQ(info["times"], nlohmann::json::array());
}

TEST(VolumeInfo, refusesWhatThereIsNot) {
  const ProgramResult still = runProgram("scene info builtin:volume,name=ramp --time 1");
  EXPECT_EQ(still.exitCode, 2);
  EXPECT_THAT(still.error, HasSubstr("time"));
  const ProgramResult unknown = runProgram("scene info builtin:volume,name=teapot");
  EXPECT_EQ(unknown.exitCode, 2);
  EXPECT_THAT(unknown.error, HasSubstr("one of skull"));
  const ProgramResult shown = runProgram("scene info builtin:volume,name=ramp --transfer bogus");
  EXPECT_EQ(shown.exitCode, 2);
  EXPECT_THAT(shown.error, HasSubstr("--transfer"));
}

TEST(VolumeInfo, ofASurfaceIsThatOfItsMesh) {
  const ProgramResult info = runProgram("scene info --json builtin:volume,name=sphere,size=24 --iso 0.5");
  ASSERT_EQ(info.exitCode, 0) << info.error;
  const auto json = nlohmann::json::parse(info.output);
  EXPECT_GT(json["triangles"], 500);
  EXPECT_EQ(json["triangles_in_file"], json["triangles"]);
  const ProgramResult moving = runProgram("scene info builtin:volume,name=sphere,size=24 --iso 0.5 --animation walk");
  EXPECT_EQ(moving.exitCode, 2);
  EXPECT_THAT(moving.error, HasSubstr("--animation"));
}

TEST(SceneList, showsVolumesToo) {
  const std::string text = runProgram("scene list").output;
  const auto json = nlohmann::json::parse(runProgram("scene list --json").output);
  for (const BuiltinVolumeKind& kind : listBuiltinVolumes()) {
    EXPECT_THAT(text, HasSubstr("builtin:volume,name=" + kind.name));
    const bool isListed =
        std::ranges::any_of(json, [&](const auto& entry) { return entry["name"] == "volume,name=" + kind.name; });
    EXPECT_TRUE(isListed) << kind.name;
  }
}

}  // namespace
}  // namespace ocelli::test
