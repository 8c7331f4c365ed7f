#include "oc_core/base/free_file_name.h"

#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

TEST(FreeFileName, whatIsThereStays) {
  const test::TemporaryFolder folder;
  folder.write("ocelli-001.png", "mine");
  folder.write("ocelli-003.png", "mine too");
  EXPECT_EQ(makeFreeFile(folder.path(), "ocelli", ".png").filename(), "ocelli-002.png");
  EXPECT_EQ(makeFreeFile(folder.path(), "ocelli", ".png").filename(), "ocelli-004.png");
  EXPECT_EQ(test::fileBytes(folder.path() / "ocelli-001.png"), "mine");
}

TEST(FreeFileName, aFolderThatIsMissingIsAnError) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(makeFreeFile(folder.path() / "missing", "ocelli", ".png"), WorkError);
}

}  // namespace
}  // namespace ocelli
