// `ocelli sea` from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "oc_core/image/png_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class SeaCommand : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return inQuotes(folder_ / name); }
  /// A few small images of a house.
  ProgramResult build(const std::string& options = "") const {
    return runProgram(
        "sea build builtin:house --grid 2,2,2.3,2.2,0.1 --size 96x64 --samples 1 --proxy-triangles 3000 " + options +
        " -o " + path("house.sea"));
  }

  TemporaryFolder folder_;
};

TEST_F(SeaCommand, buildsTellsGetsAndVerifies) {
  const ProgramResult built = build();
  ASSERT_EQ(built.exitCode, 0) << built.error;
  EXPECT_THAT(built.output, AllOf(HasSubstr("12, of which 1 are I-nodes"), HasSubstr(": 1")));
  const ProgramResult info = runProgram("sea info --json - " + path("house.sea"));
  ASSERT_EQ(info.exitCode, 0) << info.error;
  const auto figures = nlohmann::json::parse(info.output);
  EXPECT_EQ(figures["images"], 12);
  EXPECT_EQ(figures["settings"]["source"], "builtin:house");
  EXPECT_NEAR(figures["spacing"], 0.1, 1e-6);
  EXPECT_EQ(runProgram("sea verify --decode " + path("house.sea")).exitCode, 0);
  const ProgramResult got = runProgram("sea get " + path("house.sea") + " --image 5 --json - -o " + path("five.png"));
  ASSERT_EQ(got.exitCode, 0) << got.error;
  EXPECT_LT(nlohmann::json::parse(got.output)["bytes_read"], figures["bytes"]);
  const Image<Rgb8> five = readPng(folder_ / "five.png");
  EXPECT_EQ(five.width(), 96);
  // The nearest to its place is the same one, and so is the view from there, up to blending.
  runProgram("sea get " + path("house.sea") + " --near 2.1,1.6,2.1 -o " + path("near.png"));
  EXPECT_EQ(readPng(folder_ / "near.png"), five);
  EXPECT_EQ(runProgram("sea get " + path("house.sea") + " --at 2.13,1.6,2.08 --yaw 30 -o " + path("at.png")).exitCode,
            0);
}

TEST_F(SeaCommand, evaluatesAgainstItsSource) {
  ASSERT_EQ(build("--i-codec png --p-codec png").exitCode, 0);
  const ProgramResult result =
      runProgram("sea evaluate --samples 1 --images 3 --timed 4 --peers webp --json - " + path("house.sea"));
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const auto figures = nlohmann::json::parse(result.output);
  EXPECT_LT(figures["flip"], 0.01) << "codecs without loss";
  EXPECT_GT(figures["ssim"], 0.99);
  EXPECT_EQ(figures["peers"][0]["name"], "webp");
}

TEST_F(SeaCommand, aFolderThatWasExportedMakesTheSameSea) {
  ASSERT_EQ(build("--i-codec png --p-codec png --i-spacing 0").exitCode, 0);
  ASSERT_EQ(runProgram("sea export " + path("house.sea") + " --folder " + path("photos")).exitCode, 0);
  const ProgramResult built = runProgram("sea build " + path("photos") + " --proxy " + path("photos/proxy.ply") +
                                         " --i-codec png --p-codec png --refine none -o " + path("again.sea"));
  ASSERT_EQ(built.exitCode, 0) << built.error;
  for (const char* file : {"house", "again"}) {
    runProgram("sea get " + path(std::string(file) + ".sea") + " --image 7 -o " + path(std::string(file) + ".png"));
  }
  const Image<Rgb8> first = readPng(folder_ / "house.png");
  const Image<Rgb8> again = readPng(folder_ / "again.png");
  for (size_t i = 0; i < first.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      ASSERT_LE(std::abs(int{first[i][c]} - int{again[i][c]}), 1) << i;
    }
  }
  const ProgramResult named =
      runProgram("sea get " + path("again.sea") + " --name image00007.png -o " + path("named.png"));
  EXPECT_EQ(named.exitCode, 0) << named.error;
  EXPECT_EQ(readPng(folder_ / "named.png"), again);
}

TEST_F(SeaCommand, exportsAPage) {
  ASSERT_EQ(build().exitCode, 0);
  const ProgramResult result = runProgram("sea export " + path("house.sea") + " --page " + path("page") + " --every 5");
  ASSERT_EQ(result.exitCode, 0) << result.error;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "page/index.html"));
  // Of twelve images those with the numbers 0, 5 and 10.
  EXPECT_TRUE(std::filesystem::exists(folder_ / "page/images/00002.js"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "page/images/00003.js"));
  const std::string sea = fileBytes(folder_ / "page/sea.js");
  const size_t from = sea.find('(') + 1;
  const auto data = nlohmann::json::parse(sea.substr(from, sea.rfind(')') - from));
  EXPECT_EQ(data["title"], "house");
  ASSERT_EQ(data["places"].size(), 3u);
  EXPECT_NEAR(data["places"][0]["eye"][0], 2, 1e-5);
  EXPECT_NEAR(data["places"][0]["eye"][1], 1.6, 1e-5);
  EXPECT_NEAR(data["places"][0]["forward"][2], -1, 1e-5);
  EXPECT_FALSE(data["proxy"].is_null());
  for (const char* wrong : {"", " --folder f --page p", " --folder f --every 2"}) {
    EXPECT_EQ(runProgram("sea export " + path("house.sea") + wrong).exitCode, 2) << wrong;
  }
}

TEST_F(SeaCommand, saysWhatIsWrong) {
  const auto fails = [&](const std::string& arguments) {
    const ProgramResult result = runProgram("sea " + arguments);
    EXPECT_EQ(result.exitCode, 2) << arguments;
    return result.error;
  };
  EXPECT_THAT(fails("build builtin:teapot -o " + path("t.sea")), HasSubstr("--positions"));
  EXPECT_THAT(fails("build builtin:house --grid 2,2,2.3,2.2,0.1 --i-codec gif -o " + path("t.sea")), HasSubstr("gif"));
  EXPECT_THAT(fails("build builtin:house --grid 2,2,2.3,2.2,0.1 --refine gauss -o " + path("t.sea")),
              HasSubstr("bobyqa"));
  EXPECT_THAT(fails("info " + path("none.sea")), HasSubstr("none.sea"));
  folder_.write("text.sea", "text");
  EXPECT_THAT(fails("verify " + path("text.sea")), HasSubstr("no sea of images"));
  ASSERT_EQ(build().exitCode, 0);
  EXPECT_THAT(fails("get " + path("house.sea") + " -o " + path("x.png")), HasSubstr("--image"));
  EXPECT_THAT(fails("get " + path("house.sea") + " --image 12 -o " + path("x.png")), HasSubstr("0 to 11"));
  EXPECT_THAT(fails("get " + path("house.sea") + " --name a.png -o " + path("x.png")), HasSubstr("a.png"));
  EXPECT_THAT(fails("evaluate --peers mpeg2 " + path("house.sea")), HasSubstr("x265"));
}

TEST_F(SeaCommand, goesOnWhereItWasStopped) {
  ASSERT_EQ(build().exitCode, 0);
  const std::string whole = fileBytes(folder_ / "house.sea");
  std::filesystem::rename(folder_ / "house.sea", folder_ / "other.sea");
  // What is left there is of another build.
  ASSERT_EQ(build("--count 6").exitCode, 0);
  std::filesystem::rename(folder_ / "house.sea", folder_ / "house.sea.partial");
  const ProgramResult refused = build();
  EXPECT_EQ(refused.exitCode, 2);
  EXPECT_THAT(refused.error, HasSubstr("--start-over"));
  EXPECT_EQ(build("--start-over").exitCode, 0);
  EXPECT_EQ(fileBytes(folder_ / "house.sea"), whole);
}

}  // namespace
}  // namespace ocelli::test
