#include "display_sim/svol_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include "display_sim/svol_format.h"
#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "tests/base/temporary_folder.h"
#include "tests/display_sim/test_files.h"
#include "tests/display_sim/test_meshes.h"
#include "tests/display_sim/test_profiles.h"

namespace ocelli {
namespace {

using test::bytesOf;
using test::coloredTorus;
using test::smallProfile;
using test::TemporaryFolder;
using ::testing::HasSubstr;

TEST(SvolFile, readsBackWhatWasWritten) {
  const TemporaryFolder folder;
  for (const DisplayProfile& profile : {loadProfile("test"), loadProfile("vortex"), smallProfile(5, 17, 9),
                                        smallProfile(4, 16, 9, SecondHalfTurn::kOwn)}) {
    const Volume volume = coloredTorus(profile);
    writeSvol(folder / "torus.svol", volume);
    EXPECT_EQ(readSvol(folder / "torus.svol"), volume);
    const SvolSummary summary = verifySvol(folder / "torus.svol");
    EXPECT_EQ(summary.profile, profile);
    EXPECT_EQ(summary.litVoxels, volume.litVoxels());
    EXPECT_EQ(summary.fileBytes, bytesOf(folder / "torus.svol").size());
  }
}

TEST(SvolFile, streamedSlicesGiveTheSameBytesWithAnyNumberOfThreads) {
  const TemporaryFolder folder;
  const Volume volume = coloredTorus(loadProfile("test"));
  SvolWriter writer(folder / "streamed.svol", volume.profile());
  for (int i = 0; i < volume.slices(); ++i) {
    writer.add(volume.slice(i));
  }
  writer.finish();
  for (const int threads : {1, 2, 8}) {
    setThreadCount(threads);
    writeSvol(folder / "whole.svol", volume);
    EXPECT_EQ(bytesOf(folder / "whole.svol"), bytesOf(folder / "streamed.svol"));
  }
  setThreadCount(0);
}

// Reads the fields as docs/svol.md places them, without our reader.
TEST(SvolFile, standsAsTheSpecificationSays) {
  const TemporaryFolder folder;
  const Volume volume = coloredTorus(smallProfile(3, 17, 9));
  writeSvol(folder / "a.svol", volume);
  const std::vector<uint8_t> file = bytesOf(folder / "a.svol");
  const auto u32 = [&](size_t at) { return file[at] | file[at + 1] << 8 | file[at + 2] << 16 | file[at + 3] << 24; };
  const auto crc = [&](size_t begin, size_t end) {
    return static_cast<int>(crc32(0, file.data() + begin, static_cast<uInt>(end - begin)));
  };
  EXPECT_EQ(std::string(file.begin(), file.begin() + 8), "\x89SVOL\r\n\x1a");
  EXPECT_EQ(u32(8), 1);
  const auto jsonBytes = static_cast<size_t>(u32(12));
  EXPECT_EQ(u32(16), 3);
  EXPECT_EQ(u32(20), 17);
  EXPECT_EQ(u32(24), 9);
  EXPECT_EQ(u32(28), 3);
  EXPECT_EQ(std::string(file.begin() + 32, file.begin() + 32 + static_cast<int>(jsonBytes)),
            jsonText(volume.profile()));
  EXPECT_EQ(u32(32 + jsonBytes), crc(0, 32 + jsonBytes));
  size_t at = 36 + jsonBytes;
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(u32(at), i);
    const auto size = static_cast<size_t>(u32(at + 4));
    EXPECT_EQ(static_cast<unsigned>(u32(at + 8)), 0xFD2FB528u) << "the magic number of a zstd frame (RFC 8878)";
    EXPECT_EQ(u32(at + 8 + size), crc(at, at + 8 + size));
    at += 12 + size;
  }
  EXPECT_EQ(at, file.size());
}

TEST(SvolFile, appearsOnlyWhenFinished) {
  const TemporaryFolder folder;
  const Volume volume = coloredTorus(smallProfile(3, 17, 9));
  {
    SvolWriter writer(folder / "a.svol", volume.profile());
    writer.add(volume.slice(0));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << "an unfinished file is left";
}

TEST(SvolFile, unwritableOutputIsAWorkError) {
  const Volume volume = coloredTorus(smallProfile(3, 17, 9));
  const TemporaryFolder folder;
  EXPECT_THROW(writeSvol(folder / "missing folder/a.svol", volume), WorkError);
  EXPECT_THROW(writeSvol(folder.path(), volume), WorkError) << "a folder is no file";
  if (std::filesystem::exists("/dev/full")) {
    try {
      writeSvol("/dev/full", volume);
      FAIL();
    } catch (const WorkError& error) {
      EXPECT_THAT(error.what(), HasSubstr("No space left"));
    }
  }
}

TEST(SvolFile, missingEmptyAndForeignFilesAreInputErrors) {
  const TemporaryFolder folder;
  const auto expectProblem = [](const std::filesystem::path& path, const std::string& problem) {
    try {
      readSvol(path);
      FAIL() << path;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(problem));
      EXPECT_THAT(error.what(), HasSubstr(path.string()));
    }
  };
  expectProblem(folder / "missing.svol", "cannot open");
  expectProblem(folder.path(), "cannot open");
  std::ofstream(folder / "empty.svol").close();
  expectProblem(folder / "empty.svol", "ends too soon");
  std::ofstream(folder / "text.svol") << "This is a text of more than thirty-two bytes.";
  expectProblem(folder / "text.svol", "no .svol file");
}

TEST(SvolFile, errorsNameTheSlice) {
  const TemporaryFolder folder;
  const Volume volume = coloredTorus(smallProfile(3, 17, 9));
  writeSvol(folder / "a.svol", volume);
  std::vector<uint8_t> file = bytesOf(folder / "a.svol");
  file.back() ^= 1;
  std::ofstream(folder / "a.svol", std::ios::binary)
      .write(reinterpret_cast<const char*>(file.data()), static_cast<std::streamsize>(file.size()));
  try {
    verifySvol(folder / "a.svol");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("slice 2: the checksum is wrong"));
  }
}

}  // namespace
}  // namespace ocelli
