#include "oc_core/base/output_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <functional>
#include <iterator>
#include <thread>

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

/// What `work` writes into one end of a pipe, which it gets as a path.
std::string piped(const std::function<void(const fs::path&)>& work) {
  std::array<int, 2> ends{};
  EXPECT_EQ(pipe(ends.data()), 0);
  work("/dev/fd/" + std::to_string(ends[1]));
  close(ends[1]);
  std::string text;
  std::array<char, 100> bytes{};
  for (ssize_t count = 0; (count = read(ends[0], bytes.data(), bytes.size())) > 0;) {
    text.append(bytes.data(), static_cast<size_t>(count));
  }
  close(ends[0]);
  return text;
}

TEST(OutputFile, WritesToAPipeOfItsOwnProgram) {
  EXPECT_EQ(piped([](const fs::path& path) {
              checkWritable(path);
              OutputFile file(path);
              file.write("through");
              file.commit();
            }),
            "through");
}

TEST(OutputFile, WritesToANamedPipeDirectly) {
  const test::TemporaryFolder folder;
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  std::string got;
  std::thread reader([&] { got = test::fileBytes(folder / "pipe"); });
  {
    OutputFile file(folder / "pipe");
    file.write("through");
    file.commit();
  }
  reader.join();
  EXPECT_EQ(got, "through");
  EXPECT_EQ(entriesIn(folder), 1);
}

TEST(OutputFile, AStreamThatLeadsToAFileIsGoneOnWith) {
  const test::TemporaryFolder folder;
  const int log = open(folder.write("log", "before ").c_str(), O_WRONLY | O_APPEND);
  ASSERT_GE(log, 0);
  OutputFile file("/proc/self/fd/" + std::to_string(log));
  file.write("after");
  file.commit();
  close(log);
  EXPECT_EQ(test::fileBytes(folder / "log"), "before after");
  EXPECT_EQ(entriesIn(folder), 1);
}

TEST(IsStandardOutput, KnowsItsNames) {
  EXPECT_TRUE(isStandardOutput("/dev/stdout"));
  EXPECT_TRUE(isStandardOutput("/dev/fd/1"));
  EXPECT_TRUE(isStandardOutput("/proc/self/fd/1"));
  for (const char* other : {"/dev/fd/10", "/dev/stderr", "/dev/null", "/dev/fd/", "stdout", ""}) {
    EXPECT_FALSE(isStandardOutput(other)) << other;
  }
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
