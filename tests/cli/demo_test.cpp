// `ocelli demo` from outside, on one small scene.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "oc_core/image/png_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

constexpr const char* kSmall = "demo --only --size 90x60 --profile test ";

TEST(Demo, LeavesAPageWithItsImages) {
  const TemporaryFolder folder;
  const std::string page = (folder / "my page").string();
  const ProgramResult result = runProgram(std::string(kSmall) + "builtin:doors -o '" + page + "'");
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const std::string html = fileBytes(page + "/index.html");
  const std::regex source("src=\"([^\"]*)\"");
  size_t images = 0;
  for (std::sregex_iterator it(html.begin(), html.end(), source); it != std::sregex_iterator(); ++it, ++images) {
    EXPECT_FALSE(readPng(page + "/" + (*it)[1].str()).empty());
  }
  // Rows of 2, 3, 3, 2, 3, 3, 3 and 4 images, each shown side by side and in one place.
  EXPECT_EQ(images, 46u);
}

TEST(Demo, ShowsVolumesByPinholesAndByBentRays) {
  const TemporaryFolder folder;
  const std::string page = (folder / "page").string();
  const ProgramResult result = runProgram(std::string(kSmall) + "builtin:volume,name=skull,size=48 -o '" + page + "'");
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const std::string html = fileBytes(page + "/index.html");
  EXPECT_THAT(html, testing::HasSubstr("Curved ray camera"));
  // It has no meshes to measure.
  EXPECT_THAT(html, testing::Not(testing::HasSubstr("Errors and times")));
  std::set<std::string> images;
  for (const char* name : {"front", "above", "curved"}) {
    images.insert(fileBytes(page + "/given-1/" + name + ".png"));
  }
  EXPECT_EQ(images.size(), 3u);
}

TEST(Demo, SaysWhichMeshItCannotRead) {
  const TemporaryFolder folder;
  const ProgramResult result =
      runProgram(std::string(kSmall) + "no-such-mesh.obj -o '" + (folder / "page").string() + "'");
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.error, testing::HasSubstr("no-such-mesh.obj"));
}

TEST(Demo, FailsWhereTheFolderCannotBeMade) {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "").string();
  const ProgramResult result = runProgram(std::string(kSmall) + "builtin:doors -o '" + file + "'");
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.error, testing::HasSubstr(file));
}

TEST(Demo, WantsAScene) {
  const ProgramResult result = runProgram("demo --only");
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.error, testing::HasSubstr("--only"));
}

}  // namespace
}  // namespace ocelli::test
