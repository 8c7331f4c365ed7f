#include "oc_core/base/output_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <iterator>

#include "oc_core/base/error.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

long entriesIn(const test::TemporaryFolder& folder) {
  return std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator());
}

TEST(OutputFile, AppearsWithCommitAlone) {
  const test::TemporaryFolder folder;
  {
    OutputFile file(folder / "a");
    file.write("one ");
    file.write("two");
    EXPECT_FALSE(fs::exists(folder / "a"));
    file.commit();
    EXPECT_EQ(test::fileBytes(folder / "a"), "one two");
  }
  EXPECT_EQ(entriesIn(folder), 1);
}

TEST(OutputFile, LeavesTheOldFileWithoutCommit) {
  const test::TemporaryFolder folder;
  folder.write("a", "old");
  { OutputFile(folder / "a").write("new"); }
  EXPECT_EQ(test::fileBytes(folder / "a"), "old");
  EXPECT_EQ(entriesIn(folder), 1);
}

TEST(OutputFile, CommitReplacesTheOldFile) {
  const test::TemporaryFolder folder;
  folder.write("a", "an older and longer one");
  OutputFile file(folder / "a");
  file.write("new");
  file.commit();
  EXPECT_EQ(test::fileBytes(folder / "a"), "new");
}

TEST(OutputFile, APublishedFileCanBeReadWhileItGrowsAndStays) {
  const test::TemporaryFolder folder;
  folder.write("a", "an older and longer one");
  {
    OutputFile file(folder / "a");
    file.write("one");
    EXPECT_EQ(test::fileBytes(folder / "a"), "an older and longer one");
    file.publish();
    EXPECT_EQ(test::fileBytes(folder / "a"), "one");
    file.write(" two");
    file.flush();
    EXPECT_EQ(test::fileBytes(folder / "a"), "one two");
  }
  EXPECT_EQ(test::fileBytes(folder / "a"), "one two");
  EXPECT_EQ(entriesIn(folder), 1);
}

TEST(OutputFile, ALinkStaysALink) {
  const test::TemporaryFolder folder;
  folder.write("a", "old");
  fs::create_symlink("a", folder / "link");
  OutputFile file(folder / "link");
  file.write("new");
  file.commit();
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(test::fileBytes(folder / "a"), "new");
}

TEST(OutputFile, AWriteProtectedFileStays) {
  if (geteuid() == 0) {
    GTEST_SKIP() << "root may write everything";
  }
  const test::TemporaryFolder folder;
  fs::permissions(folder.write("a", "old"), fs::perms::owner_read);
  EXPECT_THROW(OutputFile(folder / "a"), WorkError);
  EXPECT_EQ(test::fileBytes(folder / "a"), "old");
}

TEST(OutputFile, WritesToADeviceDirectly) {
  OutputFile file("/dev/null");
  file.write("gone");
  file.commit();
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(OutputFile, AFolderIsAWorkError) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(OutputFile(folder.path()), WorkError);
}

TEST(CheckWritable, SaysBeforeTheWorkWhatWouldFailAfterIt) {
  const test::TemporaryFolder folder;
  EXPECT_NO_THROW(checkWritable(folder / "a"));
  EXPECT_EQ(entriesIn(folder), 0);
  try {
    checkWritable(folder / "no" / "folder");
    FAIL() << "nothing was thrown";
  } catch (const WorkError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("no/folder"));
  }
}

}  // namespace
}  // namespace ocelli
