#include "oc_core/base/file_bytes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <thread>

#include "oc_core/base/error.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

TEST(FileBytes, RoundTripKeepsEveryByte) {
  const test::TemporaryFolder folder;
  std::string bytes;
  for (int i = 0; i < 200000; ++i) {  // more than one block of the reader
    bytes.push_back(static_cast<char>(i * 31));
  }
  for (const std::string& content : {std::string(), std::string("\0\r\n", 3), bytes}) {
    writeFile(folder / "a", content);
    EXPECT_EQ(readFile(folder / "a"), content);
  }
}

TEST(FileBytes, ReadingExactlyOneBlockEnds) {
  const test::TemporaryFolder folder;
  const std::string block(1 << 16, 'x');
  EXPECT_EQ(readFile(folder.write("a", block)), block);
}

TEST(FileBytes, ReadingRejectsMissingAndFolder) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(readFile(folder / "missing"), InputError);
  EXPECT_THROW(readFile(folder.path()), InputError);
}

TEST(FileBytes, ReadingEndsWhereADeviceDoesNot) {
  EXPECT_THAT([] { readFile("/dev/zero"); }, testing::ThrowsMessage<InputError>(testing::AllOf(
                                                 testing::HasSubstr("/dev/zero"), testing::HasSubstr("64 MiB"))));
  EXPECT_EQ(readFile("/dev/null"), "");
}

TEST(FileBytes, ReadsAPipeToItsEnd) {
  const test::TemporaryFolder folder;
  const std::filesystem::path pipe = folder / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(pipe) << std::string(200'000, 'x'); });
  EXPECT_EQ(readFile(pipe).size(), 200'000u);
  writer.join();
}

TEST(FileBytes, WritingSaysFileAndReason) {
  const test::TemporaryFolder folder;
  try {
    writeFile(folder / "no" / "folder", "text");
    FAIL() << "nothing was thrown";
  } catch (const WorkError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("no/folder"));
    EXPECT_THAT(error.what(), testing::HasSubstr("No such file or directory"));
  }
  EXPECT_THROW(writeFile(folder.path(), "text"), WorkError);
}

TEST(FileBytes, AFullDeviceIsFoundAndStays) {
  for (const size_t size : {size_t{1}, size_t{1} << 20}) {  // below and above the buffer of stdio
    EXPECT_THROW(writeFile("/dev/full", std::string(size, 'x')), WorkError);
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
  }
}

}  // namespace
}  // namespace ocelli
