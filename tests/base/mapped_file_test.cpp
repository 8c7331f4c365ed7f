#include "oc_core/base/mapped_file.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "oc_core/base/error.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

TEST(MappedFile, HasTheBytesOfTheFile) {
  const test::TemporaryFolder folder;
  const MappedFile file(folder.write("file", "abc"));
  EXPECT_EQ(std::string(file.bytes().begin(), file.bytes().end()), "abc");
  EXPECT_TRUE(MappedFile(folder.write("empty", "")).bytes().empty());
}

TEST(MappedFile, WhatIsNoFileIsRefused) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(MappedFile(folder / "none"), InputError);
  EXPECT_THROW(MappedFile(folder.path()), InputError);
  EXPECT_THROW(MappedFile("/dev/zero"), InputError);
}

TEST(MappedFile, IsKnownByItsAddressesWhileItLives) {
  const test::TemporaryFolder folder;
  const auto path = folder.write("file", "abc");
  const uint8_t* at = nullptr;
  {
    MappedFile first(path);
    at = first.bytes().data();
    EXPECT_STREQ(mappedFileAt(at + 2), path.c_str());
    EXPECT_EQ(mappedFileAt(at + 3), nullptr);
    EXPECT_EQ(mappedFileAt(at - 1), nullptr);
    const MappedFile moved(std::move(first));
    EXPECT_STREQ(mappedFileAt(at), path.c_str());
  }
  EXPECT_EQ(mappedFileAt(at), nullptr);
}

TEST(MappedFile, MoreThanCanBeKnownAreMappedAllTheSame) {
  const test::TemporaryFolder folder;
  const auto path = folder.write("file", "abc");
  for (int round = 0; round < 2; ++round) {
    std::vector<MappedFile> files;
    for (int i = 0; i < 100; ++i) {
      files.emplace_back(path);
      EXPECT_EQ(files.back().bytes()[1], 'b');
    }
    EXPECT_STREQ(mappedFileAt(files.front().bytes().data()), path.c_str());
  }
}

}  // namespace
}  // namespace ocelli
