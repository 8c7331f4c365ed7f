#include "oc_core/antialiasing/antialias_option.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "tests/antialiasing/antialias_scenes.h"
#include "tests/base/temporary_folder.h"

namespace ocelli::test {
namespace {

std::string optionError(const std::string& text) {
  try {
    antialiasChoice(text, "--antialias");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(AntialiasOption, readsWaysAndTheirKeys) {
  EXPECT_EQ(antialiasChoice("none", "").samples, 1);
  EXPECT_EQ(antialiasChoice("msaa-16", "").samples, 16);
  const AntialiasChoice uniform = antialiasChoice("uniform-256,placement=jittered", "");
  EXPECT_EQ(uniform.samples, 256);
  EXPECT_STREQ(uniform.placement->name, "jittered");
  const AntialiasChoice extreme = antialiasChoice("extreme,tile=320x200,dense=2.5,exact=0,outside=msaa-16", "");
  EXPECT_EQ(extreme.tile.width, 320);
  EXPECT_EQ(extreme.tile.height, 200);
  EXPECT_EQ(extreme.dense, 2.5);
  EXPECT_EQ(extreme.maxExactTriangles, 0U);
  EXPECT_EQ(extreme.outside->text, "msaa-16");
  const AntialiasChoice standard = antialiasChoice("extreme", "");
  EXPECT_EQ(standard.tile.width, 640);
  EXPECT_EQ(standard.tile.height, 720);
  EXPECT_EQ(standard.regions, "auto");
  EXPECT_EQ(standard.dense, 1);
  EXPECT_STREQ(standard.placement->name, "slanted");
  EXPECT_EQ(standard.maxExactTriangles, 4U);
  EXPECT_EQ(standard.outside->text, "area-16");
}

TEST(AntialiasOption, helpNamesEveryWayAndKey) {
  const std::string help = antialiasHelp();
  for (const AntialiasMethod& each : antialiasMethods()) {
    EXPECT_THAT(help, testing::HasSubstr(each.description));
    for (const char* key : each.keys) {
      EXPECT_THAT(help, testing::HasSubstr(std::string("\n  ") + key + "="));
    }
  }
}

TEST(AntialiasOption, refusesWhatIsWrongAndSaysWhatIsRight) {
  EXPECT_THAT(optionError("best"), testing::HasSubstr("use none, msaa-N, uniform-N, area-N, extreme"));
  EXPECT_THAT(optionError("none-4"), testing::HasSubstr("there is no antialiasing"));
  EXPECT_THAT(optionError("msaa"), testing::HasSubstr("2, 4, 8 or 16"));
  EXPECT_THAT(optionError("msaa-32"), testing::HasSubstr("2, 4, 8 or 16"));
  EXPECT_THAT(optionError("uniform-15"), testing::HasSubstr("a square number up to 4096"));
  EXPECT_THAT(optionError("uniform-4225"), testing::HasSubstr("a square number up to 4096"));
  EXPECT_THAT(optionError("uniform-99999999999"), testing::HasSubstr("a square number"));
  EXPECT_THAT(optionError("uniform--4"), testing::HasSubstr("there is no antialiasing"));
  EXPECT_THAT(optionError("uniform-16,tile=3x3"),
              testing::HasSubstr("use placement=grid|sheared|slanted|multijittered|jittered"));
  EXPECT_THAT(optionError("msaa-4,exact=2"), testing::HasSubstr("leave it out"));
  EXPECT_THAT(optionError("extreme,tile=640"), testing::HasSubstr("give tile=WIDTHxHEIGHT"));
  EXPECT_THAT(optionError("extreme,tile=0x5"), testing::HasSubstr("give tile=WIDTHxHEIGHT"));
  EXPECT_THAT(optionError("extreme,tile=32768x32768"), testing::HasSubstr("at most 268435456"));
  EXPECT_THAT(optionError("extreme,exact=17"), testing::HasSubstr("give exact="));
  EXPECT_THAT(optionError("extreme,placement=round"), testing::HasSubstr("give placement="));
  EXPECT_THAT(optionError("extreme,dense=nan"), testing::HasSubstr("give dense="));
  EXPECT_THAT(optionError("extreme,dense=-1"), testing::HasSubstr("give dense=NUMBER, 0 to 1000000"));
  EXPECT_THAT(optionError("extreme,tile=32769x1"), testing::HasSubstr("give tile=WIDTHxHEIGHT, 1 to 32768"));
  EXPECT_THAT(optionError("extreme,regions=all"), testing::HasSubstr("give regions=auto|objects|FILE.json"));
  EXPECT_THAT(optionError("extreme,regions=missing.json"), testing::HasSubstr("missing.json"));
  EXPECT_THAT(optionError("extreme,outside=extreme"), testing::HasSubstr("give outside=METHOD"));
  EXPECT_THAT(optionError("extreme,outside=msaa-3"), testing::HasSubstr("outside=msaa-3"));
  EXPECT_THAT(optionError("extreme,exact=2,exact=3"), testing::HasSubstr("stands twice"));
  EXPECT_THAT(optionError("extreme,"), testing::HasSubstr("nothing that can be said"));
}

TEST(AntialiasOption, regionsSmallerThanAPixelAndTooManySamplesAreErrors) {
  const PinholeCamera camera({}, 4000, 3000);
  const Mesh mesh = triangleCloud(10, 0.1f);
  const AntialiasScene scene(camera, mesh);
  AntialiasChoice choice = antialiasChoice("extreme", "--antialias");
  choice.regions = "file";
  choice.requested = {{{0.5, 0.5}, {1e-4, 1e-4}, 4}};
  EXPECT_THROW(antialiasRegions(choice, scene), InputError);
  choice.requested = {{{0.5, 0.5}, {1, 1}, 64}};  // 12 million pixels of 4,096 samples
  EXPECT_THROW(antialiasRegions(choice, scene), InputError);
  choice.requested = {{{0.5, 0.5}, {1, 1}, 16}};
  EXPECT_EQ(antialiasRegions(choice, scene).front().side, 16);
}

TEST(AntialiasOption, aFileOfRegionsLeavesNothingToDensity) {
  const TemporaryFolder folder;
  const std::string file = (folder / "REGIONS.JSON").string();
  writeFile(file, R"({"regions": [{"center": [0.5, 0.5], "extent": [0.5, 0.5]}]})");
  EXPECT_EQ(antialiasChoice("extreme,regions=" + file, "").requested.size(), 1U);
  for (const std::string& both : {"extreme,dense=2,regions=" + file, "extreme,regions=" + file + ",dense=2"}) {
    EXPECT_THAT(optionError(both), testing::HasSubstr("leave dense= or the file out"));
  }
}

TEST(AntialiasOption, regionsByObjectsNeedObjects) {
  const PinholeCamera camera({}, 90, 60);
  const Mesh mesh = triangleCloud(500, 0.1f);
  const AntialiasScene scene(camera, mesh);
  const AntialiasChoice choice = antialiasChoice("extreme,regions=objects,dense=0", "--antialias");
  EXPECT_THROW(antialiasRegions(choice, scene), InputError);
  std::vector<uint32_t> objects(mesh.triangles.size(), 0);
  EXPECT_THROW(antialiasRegions(choice, scene, objects), InputError);
  objects[0] = 1;
  EXPECT_EQ(antialiasRegions(choice, scene, objects).size(), 1U);
}

TEST(AntialiasOption, raysTakeWhatIsOfSamplesEverywhere) {
  EXPECT_EQ(rayPattern(antialiasChoice("uniform-25", ""), "").size(), 25);
  EXPECT_EQ(rayPattern(antialiasChoice("none", ""), "").size(), 1);
  EXPECT_THROW(rayPattern(antialiasChoice("msaa-4", ""), ""), InputError);
  EXPECT_THROW(rayPattern(antialiasChoice("area-16", ""), ""), InputError);
  EXPECT_THROW(rayPattern(antialiasChoice("extreme", ""), ""), InputError);
}

}  // namespace
}  // namespace ocelli::test
