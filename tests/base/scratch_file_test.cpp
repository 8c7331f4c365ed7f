#include "oc_core/base/scratch_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "oc_core/base/error.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

TEST(ScratchFile, KeepsWhatWasAppended) {
  const test::TemporaryFolder folder;
  ScratchArray<uint32_t> numbers(folder.path());
  constexpr uint32_t kCount = 1'000'000;
  for (uint32_t i = 0; i < kCount; ++i) {
    numbers.push(i * 2654435761U);
  }
  numbers.pushZeros(1000);
  const std::span<uint32_t> all = numbers.map();
  ASSERT_EQ(all.size(), kCount + 1000);
  for (uint32_t i = 0; i < kCount; ++i) {
    ASSERT_EQ(all[i], i * 2654435761U);
  }
  EXPECT_TRUE(std::all_of(all.begin() + kCount, all.end(), [](uint32_t x) { return x == 0; }));
}

TEST(ScratchFile, WhatIsWrittenStaysWhereMemoryIsGivenBack) {
  const test::TemporaryFolder folder;
  ScratchArray<uint32_t> numbers(folder.path());
  numbers.pushZeros(100'000);
  const std::span<uint32_t> all = numbers.map();
  for (uint32_t i = 0; i < all.size(); ++i) {
    all[i] = i;
  }
  numbers.release();
  for (uint32_t i = 0; i < all.size(); ++i) {
    ASSERT_EQ(all[i], i);
  }
}

TEST(ScratchFile, LeavesNoFile) {
  const test::TemporaryFolder folder;
  ScratchFile file(folder.path());
  file.appendZeros(10);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(ScratchFile, OfNothingHasNoBytes) {
  const test::TemporaryFolder folder;
  EXPECT_TRUE(ScratchFile(folder.path()).map().empty());
}

TEST(ScratchFile, WhereNothingCanBeWrittenIsTold) {
  EXPECT_THROW(ScratchFile("/no/such/folder"), WorkError);
}

}  // namespace
}  // namespace ocelli
