#include "display_driver/emulator/test_bed_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>

#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

TEST(TestBedFolder, onlyThoseOfDeadEmulatorsAreSwept) {
  const test::TemporaryFolder folder;
  const auto bed = [&](const char* name) {
    std::filesystem::create_directories(folder / name);
    return folder / name;
  };
  const TestBedMark living(bed("umockdev.living"));
  // As after a kill: the mark is there, and nobody holds it.
  bed("umockdev.dead");
  folder.write("umockdev.dead/ocelli-emulator.lock", "");
  folder.write("umockdev.dead/file", "left");
  bed("umockdev.of_others");
  bed("another");
  folder.write("another/ocelli-emulator.lock", "");
  EXPECT_EQ(sweepTestBeds(folder.path()), 1u);
  EXPECT_FALSE(std::filesystem::exists(folder / "umockdev.dead"));
  EXPECT_TRUE(std::filesystem::exists(folder / "umockdev.living"));
  EXPECT_TRUE(std::filesystem::exists(folder / "umockdev.of_others"));
  EXPECT_TRUE(std::filesystem::exists(folder / "another"));
}

TEST(TestBedFolder, theMarkGoesWithTheEmulator) {
  const test::TemporaryFolder folder;
  std::optional<TestBedMark> mark(folder.path());
  EXPECT_FALSE(std::filesystem::is_empty(folder.path()));
  mark.reset();
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace ocelli
