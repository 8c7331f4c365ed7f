#include "oc_core/image/level_png.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/image/png_file.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using test::TemporaryFolder;

Image<uint16_t> ramp() {
  Image<uint16_t> levels(256, 256);
  for (size_t i = 0; i < levels.size(); ++i) {
    levels[i] = static_cast<uint16_t>(i);
  }
  return levels;
}

TEST(LevelPng, everyLevelComesBack) {
  const TemporaryFolder folder;
  writeLevelPng(folder / "a.png", ramp());
  EXPECT_EQ(readLevelPng(folder / "a.png"), ramp());
}

// A chunk gAMA before the pixels would have libpng change 16-bit levels as it makes light of them. Its checksum is of
// no meaning to a reader that leaves it out.
TEST(LevelPng, whatAFileSaysOfGammaChangesNothing) {
  const TemporaryFolder folder;
  writeLevelPng(folder / "a.png", ramp());
  std::string bytes = test::fileBytes(folder / "a.png");
  bytes.insert(33, std::string("\0\0\0\4gAMA\0\0\xb1\x8f\x0b\xfc\x61\x05", 16));
  EXPECT_EQ(readLevelPng(folder.write("b.png", bytes)), ramp());
}

TEST(LevelPng, otherFilesAreRefused) {
  const TemporaryFolder folder;
  writePng(folder / "rgb.png", Image<Rgb8>(4, 4, Rgb8(1)));
  EXPECT_THROW(readLevelPng(folder / "rgb.png"), InputError);
  EXPECT_THROW(readLevelPng(folder / "missing.png"), InputError);
  EXPECT_THROW(readLevelPng(folder.write("text.png", std::string(100, 'x'))), InputError);
  EXPECT_THROW(writeLevelPng(folder / "none/a.png", ramp()), WorkError);
}

TEST(LevelPng, damagedFilesAreRefused) {
  const TemporaryFolder folder;
  writeLevelPng(folder / "a.png", ramp());
  const std::string bytes = test::fileBytes(folder / "a.png");
  for (size_t length = 0; length + 12 < bytes.size(); length += 1 + bytes.size() / 50) {
    EXPECT_THROW(readLevelPng(folder.write("b.png", bytes.substr(0, length))), InputError) << length;
  }
}

}  // namespace
}  // namespace ocelli
