// `ocelli shade` from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "oc_core/base/file_bytes.h"
#include "oc_core/image/png_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

constexpr const char* kSmallShade = "shade builtin:mirror --size 90x60 --image-size 90x60 --environment-height 64 ";

TEST(Shade, writesAPicture) {
  const TemporaryFolder folder;
  const ProgramResult result = runProgram(kSmallShade + std::string("--by di -o ") + inQuotes(folder / "p.png"));
  ASSERT_EQ(result.exitCode, 0) << result.error;
  EXPECT_EQ(readPng(folder / "p.png").width(), 90);
}

TEST(Shade, comparesInAllItsForms) {
  const TemporaryFolder folder;
  const ProgramResult result =
      runProgram(kSmallShade + std::string("--by environment,di,spoc --json ") + inQuotes(folder / "x.json") +
                 " --csv " + inQuotes(folder / "x.csv") + " --page " + inQuotes(folder / "page"));
  ASSERT_EQ(result.exitCode, 0) << result.error;
  EXPECT_THAT(result.output, HasSubstr("environment"));
  const auto json = nlohmann::json::parse(fileBytes(folder / "x.json"));
  ASSERT_EQ(json["by"].size(), 4u) << "traced stands first";
  EXPECT_EQ(json["by"][0]["name"], "traced");
  EXPECT_EQ(json["by"][0]["lost"], 0.0);
  EXPECT_TRUE(json["by"][1]["lost"].is_null());
  EXPECT_GT(json["by"][2]["psnr_db"], json["by"][1]["psnr_db"]);
  EXPECT_GT(json["cast_rays"], 20);
  const std::string csv = fileBytes(folder / "x.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5);
  // Four pictures, two error maps, two maps of steps, and the page.
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "page"), {}), 9);
}

TEST(Shade, refractsThroughALens) {
  const ProgramResult result = runProgram(
      "shade builtin:lens --effect refraction --by di --json --size 90x60 --image-size 90x60 --environment-height 64");
  ASSERT_EQ(result.exitCode, 0) << result.error;
  EXPECT_EQ(nlohmann::json::parse(result.output)["effect"], "refraction");
}

TEST(Shade, drawsReliefTilesAtThePlacesOfRoles) {
  const TemporaryFolder folder;
  writeFile(folder / "roles.json", R"({"objects": [{"object": 0, "roles": ["billboard"]},
    {"source": "builtin:torus", "radius": 0.4, "roles": ["relief"],
     "places": [{"center": [-0.6, 0, 0.8]}, {"center": [0.6, 0, 0.8], "turn_degrees": 90}]}]})");
  const ProgramResult result = runProgram(
      "shade builtin:room --effect relief --by height-field,cell --json --size 90x60 --image-size 64x64 --roles " +
      inQuotes(folder / "roles.json"));
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_EQ(json["effect"], "relief");
  EXPECT_EQ(json["tiles"], 2);
  EXPECT_EQ(json["objects"], 1);
  ASSERT_EQ(json["by"].size(), 3u);
  EXPECT_TRUE(json["by"][0]["wrong"].is_null());
  EXPECT_LT(json["by"][2]["wrong"], json["by"][1]["wrong"]);
  EXPECT_LE(json["by"][1]["texels"], 64 * 64);
}

TEST(Shade, walksByStepsAndFollowsRaysOfSecondOrder) {
  const TemporaryFolder folder;
  writeFile(folder / "roles.json", R"({"objects": [{"object": 0, "roles": ["billboard"]},
    {"object": 1, "roles": ["mirror"]}, {"object": 2, "roles": ["mirror", "cast"]}, {"object": 3, "roles": ["cast"]},
    {"object": 4, "roles": ["cast"]}]})");
  const ProgramResult result = runProgram(
      kSmallShade + std::string("--by di,di:stepped-1/2 --order 2 --json --roles ") + inQuotes(folder / "roles.json"));
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_EQ(json["order"], 2);
  EXPECT_EQ(json["reference_views"].size(), 2u) << "each mirror has its own";
  EXPECT_EQ(json["by"][0]["lost"], 0.0);
  EXPECT_GT(json["by"][2]["steps_per_ray"], 0.0);
  EXPECT_EQ(json["by"][2]["name"], "di:stepped-1/2");
  EXPECT_TRUE(json["by"][2]["triangles"].is_null());
}

TEST(Shade, measuresAmbientLightWithoutRoles) {
  const ProgramResult result =
      runProgram("shade builtin:boxes --effect ambient --by horizon,graph --radius 0.4 --split 0 --json --size 90x60");
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_EQ(json["radius"], 0.4);
  ASSERT_EQ(json["by"].size(), 3u);
  EXPECT_EQ(json["by"][0]["rmse"], 0.0);
  EXPECT_LT(json["by"][1]["rmse"], 0.2);
}

TEST(Shade, reflectsAMazeByAGraphCamera) {
  const ProgramResult result = runProgram(
      "shade builtin:mirrormaze,rows=3,columns=3 --by comprehensive,comprehensive:by-frusta --json --size 60x40 "
      "--image-size 180x120 --environment-height 64");
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const auto json = nlohmann::json::parse(result.output);
  ASSERT_EQ(json["by"].size(), 3u);
  EXPECT_EQ(json["by"][2]["name"], "comprehensive:by-frusta");
  EXPECT_GT(json["by"][2]["steps_per_ray"], json["by"][1]["steps_per_ray"]);
}

TEST(Shade, saysWhatIsWrong) {
  const auto expectError = [](const std::string& arguments, const std::string& part) {
    const ProgramResult result = runProgram(arguments);
    EXPECT_EQ(result.exitCode, 2) << arguments;
    EXPECT_THAT(result.error, HasSubstr(part)) << arguments;
  };
  expectError("shade builtin:mirror --compare", "--by");
  expectError("shade builtin:mirror --by di", "nothing says what is wanted");
  expectError("shade builtin:mirror --by di,ddoc -o x.png", "one picture is by one camera");
  expectError("shade builtin:mirror --by dii --compare", "--by: there is no \"dii\"");
  expectError("shade builtin:mirror --by geometry --compare", "no image for rays to hit");
  expectError("shade builtin:mirror --effect glow --by di --compare", "reflection, refraction");
  expectError("shade builtin:mirror --effect refraction --by di --compare", "has the role \"refract\"");
  expectError("shade builtin:teapot --by di --compare", "--roles FILE.json");
  expectError("shade builtin:mirror --by di --compare --size 0x0", "--size");
  expectError("shade builtin:mirror --by di:by-frusta --compare", "no graph camera");
  expectError("shade builtin:boxes --effect ambient --by horizon --compare --radius wide", "--radius");
  expectError("shade builtin:boxes --effect ambient --by di:horizon --compare", "no graph camera");
  expectError("shade builtin:mirror --by di --compare --order 0", "--order");
  expectError("shade builtin:mirror --by di --compare --reference eye", "--reference");
  expectError("shade builtin:mirror --by di:searched-exit --compare", "do not pass a mirror");
  expectError("shade builtin:mirror --by eoc-hv:stepped --compare --size 90x60 --image-size 90x60",
              "steps along their projections");
}

}  // namespace
}  // namespace ocelli::test
