// Views with depth from outside: made of a scene, built of, measured and exported.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

TEST(DepthViewsCommands, everyWayFromASceneToAnExport) {
  const TemporaryFolder folder;
  for (const char* format : {"exr", "png"}) {
    const std::string views = inQuotes(folder / format);
    const ProgramResult made =
        runProgram("ocri views builtin:statues --size 90x60 --format " + std::string(format) + " -o " + views);
    ASSERT_EQ(made.exitCode, 0) << made.error;
    EXPECT_THAT(made.error, HasSubstr("wrote 9 views of 90x60"));
    for (const char* camera : {"di", "ddoc", "ldi-2", "eoc-hv", "cell", "panorama"}) {
      const ProgramResult built = runProgram("ocri build --from " + views + " --size 90x60 --camera " + camera +
                                             " -o " + inQuotes(folder / "a.exr"));
      ASSERT_EQ(built.exitCode, 0) << camera << built.error;
      EXPECT_THAT(built.error, HasSubstr("9 views, "));
      EXPECT_THAT(built.error, HasSubstr(" of them kept"));
    }
    const ProgramResult exported =
        runProgram("sea export " + views + " --miv " + inQuotes(folder / (std::string("Miv-") + format)));
    ASSERT_EQ(exported.exitCode, 0) << exported.error;
    EXPECT_TRUE(std::filesystem::exists(folder / (std::string("Miv-") + format + "/Miv-" + format + ".json")));
  }
}

TEST(DepthViewsCommands, imagesOfViewsAreMeasuredAgainstTheScene) {
  const TemporaryFolder folder;
  const std::string views = inQuotes(folder / "views");
  ASSERT_EQ(runProgram("ocri views builtin:statues --size 90x60 -o " + views).exitCode, 0);
  const std::string command =
      "evaluate builtin:statues --size 90x60 --profile test --interior 1 --directions 0 --runs 1 --cameras di,ldi-4 "
      "--json - ";
  const auto missing = [](const ProgramResult& result) {
    return nlohmann::json::parse(result.output)["representations"][1]["missing_strict"]["edges"].get<double>();
  };
  const ProgramResult ofViews = runProgram(command + "--from " + views);
  ASSERT_EQ(ofViews.exitCode, 0) << ofViews.error;
  const ProgramResult ofScene = runProgram(command);
  ASSERT_EQ(ofScene.exitCode, 0) << ofScene.error;
  EXPECT_NE(missing(ofViews), missing(ofScene));
  EXPECT_LT(missing(ofViews), 0.1);
}

TEST(DepthViewsCommands, mistakesAreNamed) {
  const TemporaryFolder folder;
  const std::string out = " -o " + inQuotes(folder / "a.exr");
  const std::string views = inQuotes(folder / "views");
  ASSERT_EQ(runProgram("ocri views builtin:teapot --size 30x20 --corners 4 -o " + views).exitCode, 0);
  const auto expectError = [&](const std::string& arguments, const std::string& part) {
    const ProgramResult result = runProgram(arguments);
    EXPECT_EQ(result.exitCode, 2) << arguments;
    EXPECT_THAT(result.error, HasSubstr(part)) << arguments;
  };
  expectError("ocri build" + out, "nothing to build of");
  expectError("ocri build builtin:teapot --from " + views + out, "give one of them");
  expectError("ocri build --no-fit --from " + views + out, "--no-fit says how a scene is read");
  expectError("ocri build --camera comprehensive --from " + views + out, "a scene that one walks through");
  expectError("ocri build --from " + inQuotes(folder / "none") + out, "there is no such folder");
  expectError("evaluate builtin:volume,name=skull --from " + views, "scenes of triangles");
  expectError("ocri views builtin:teapot -o " + views, "holds views already");
  expectError("sea export " + views + " --metre 0.001 --miv " + inQuotes(folder / "miv"), "infinity");
}

}  // namespace
}  // namespace ocelli::test
