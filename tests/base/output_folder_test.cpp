#include "oc_core/base/output_folder.h"

#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

TEST(OutputFolder, filesOfScriptsLieInIt) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(pathInFolder(folder.path(), "a.png", "script"), folder / "a.png");
  EXPECT_EQ(pathInFolder(folder.path() / "new", "b/../c/a.png", "script"), folder.path() / "new" / "c" / "a.png");
  EXPECT_TRUE(std::filesystem::is_directory(folder.path() / "new" / "c"));
}

TEST(OutputFolder, noNameIsTheCurrentFolder) {
  EXPECT_EQ(pathInFolder("", "a.png", "script"), "a.png");
  EXPECT_NO_THROW(makeFolder(""));
}

TEST(OutputFolder, refusesWhatLiesElsewhere) {
  for (const char* file : {"/tmp/a.png", "../a.png", "b/../../a.png", "", ".", "b/", ".."}) {
    EXPECT_THROW(pathInFolder("", file, "script"), InputError) << file;
  }
}

TEST(OutputFolder, saysWhereAFolderCannotBeMade) {
  test::TemporaryFolder folder;
  const std::filesystem::path file = folder.write("file", "");
  EXPECT_THROW(makeFolder(file / "new"), WorkError);
  EXPECT_THROW(pathInFolder(file, "a.png", "script"), WorkError);
}

}  // namespace
}  // namespace ocelli
