#include "display_driver/emulator/test_bed_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>

#include "tests/base/temporary_folder.h"
#include "tests/display_driver_usb/usb_bench.h"

namespace ocelli {
namespace {

TEST(TestBedFolder, onlyThoseOfDeadEmulatorsAreSwept) {
  const test::TemporaryFolder folder;
  for (const char* name : {"ocelli-usb.killed", "ocelli-usb.killed_at_once", "umockdev.of_others", "another"}) {
    std::filesystem::create_directories(folder / name);
  }
  folder.write("ocelli-usb.killed/file", "left");
  folder.write("ocelli-usb.file", "is no folder");
  const TestBedFolder living;
  std::filesystem::create_directory_symlink(living.path(), folder / "ocelli-usb.link");
  EXPECT_EQ(sweepTestBeds(folder.path()), 2u);
  EXPECT_FALSE(std::filesystem::exists(folder / "ocelli-usb.killed"));
  EXPECT_FALSE(std::filesystem::exists(folder / "ocelli-usb.killed_at_once"));
  for (const char* name : {"ocelli-usb.file", "ocelli-usb.link", "umockdev.of_others", "another"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  }
  sweepTestBeds(living.path().parent_path());
  EXPECT_TRUE(std::filesystem::exists(living.path()));
}

TEST(TestBedFolder, theLastOneRemovesIt) {
  std::optional<TestBedFolder> first(std::in_place);
  const std::filesystem::path path = first->path();
  for (int i = 0; i < 3; ++i) {
    std::optional<TestBedFolder> second(std::in_place);
    EXPECT_EQ(second->path(), path);
    first.reset();
    EXPECT_TRUE(std::filesystem::is_directory(path));
    second.reset();
    EXPECT_FALSE(std::filesystem::exists(path));
    first.emplace();
  }
}

using TestBedFolderTest = UsbTest;

TEST_F(TestBedFolderTest, devicesLiveInIt) {
  for (int i = 0; i < 2; ++i) {
    std::filesystem::path bed;
    {
      const UsbEmulator emulator({display()});
      for (const auto& [name, value] : emulator.environment()) {
        bed = name == "UMOCKDEV_DIR" ? std::filesystem::path(value) : bed;
      }
      EXPECT_TRUE(std::filesystem::is_directory(bed));
      EXPECT_EQ(bed.parent_path(), TestBedFolder().path());
    }
    EXPECT_FALSE(std::filesystem::exists(bed.parent_path()));
  }
}

}  // namespace
}  // namespace ocelli
