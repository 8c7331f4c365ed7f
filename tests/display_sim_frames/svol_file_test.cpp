#include "display_sim/frames/svol_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include "display_sim/frames/svol_format.h"
#include "display_sim/frames/svol_summary.h"
#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "tests/base/temporary_folder.h"
#include "tests/display_sim_observing/recorded_frames.h"
#include "tests/display_sim_slicing/test_files.h"
#include "tests/display_sim_slicing/test_meshes.h"

namespace ocelli {
namespace {

using test::bytesOf;
using test::coloredTorus;
using test::recordedProfile;
using test::recordedVolume;
using test::smallProfile;
using test::TemporaryFolder;
using ::testing::HasSubstr;

TEST(SvolFile, readsBackWhatWasWritten) {
  const TemporaryFolder folder;
  for (const DisplayProfile& profile :
       {loadProfile("test"), loadProfile("vortex"), smallProfile(5, 17, 9),
        smallProfile(4, 16, 9, SecondHalfTurn::kOwn), recordedProfile(5, 33, 8, 3), recordedProfile(5, 23, 7, 8)}) {
    for (const Volume& volume : {coloredTorus(profile), recordedVolume(profile, 0), Volume(profile)}) {
      writeSvol(folder / "a.svol", volume, R"({"scene":"torus"})");
      EXPECT_EQ(readSvol(folder / "a.svol"), volume);
      SvolReader reader(folder / "a.svol");
      verifySvol(reader);
      EXPECT_EQ(reader.profile(), profile);
      EXPECT_EQ(reader.metadata(), R"({"scene":"torus"})");
      EXPECT_EQ(reader.ending(), SvolEnding::kFinished);
      EXPECT_EQ(reader.fileBytes(), bytesOf(folder / "a.svol").size());
      ASSERT_EQ(reader.frames().size(), 1u);
      EXPECT_EQ(reader.frames().front().timeMicroseconds, 0u);
    }
  }
}

TEST(SvolFile, darkSlicesCostEightBytes) {
  const TemporaryFolder folder;
  const auto size = [&](int slices) {
    writeSvol(folder / "a.svol", Volume(smallProfile(slices, 768, 768)));
    return bytesOf(folder / "a.svol").size();
  };
  EXPECT_EQ(size(90) - size(80), 10 * svol::kSliceEntryBytes);
}

TEST(SvolFile, hasTheSameBytesWithAnyNumberOfThreads) {
  const TemporaryFolder folder;
  const Volume volume = coloredTorus(loadProfile("test"));
  writeSvol(folder / "a.svol", volume);
  for (const int threads : {1, 2, 8}) {
    setThreadCount(threads);
    writeSvol(folder / "b.svol", volume);
    EXPECT_EQ(bytesOf(folder / "a.svol"), bytesOf(folder / "b.svol"));
  }
  setThreadCount(0);
}

// Reads the fields as docs/svol.md places them, without our reader.
TEST(SvolFile, standsAsTheSpecificationSays) {
  const TemporaryFolder folder;
  const DisplayProfile profile = recordedProfile(3, 17, 9, 2);
  writeSvol(folder / "a.svol", recordedVolume(profile, 0), "{\"a\":1}");
  const std::vector<uint8_t> file = bytesOf(folder / "a.svol");
  const auto u32 = [&](size_t at) { return svol::load32(file.data() + at); };
  const auto u64 = [&](size_t at) { return u32(at) | static_cast<uint64_t>(u32(at + 4)) << 32; };
  const auto crc = [&](size_t begin, size_t end) {
    return static_cast<uint32_t>(crc32(0, file.data() + begin, static_cast<uInt>(end - begin)));
  };
  const auto text = [&](size_t at, size_t size) {
    return std::string(file.begin() + static_cast<std::ptrdiff_t>(at),
                       file.begin() + static_cast<std::ptrdiff_t>(at + size));
  };
  EXPECT_EQ(text(0, 8), "\x89SVOL\r\n\x1a");
  EXPECT_EQ(u32(8), 1u);
  const size_t jsonBytes = u32(12);
  EXPECT_EQ(u32(16), 7u);
  EXPECT_EQ(u32(20), 3u);
  EXPECT_EQ(u32(24), 17u);
  EXPECT_EQ(u32(28), 9u);
  EXPECT_EQ(u32(32), 2u);
  EXPECT_EQ(text(36, jsonBytes), jsonText(profile));
  EXPECT_EQ(text(36 + jsonBytes, 7), "{\"a\":1}");
  const size_t headerEnd = 43 + jsonBytes + 4;
  EXPECT_EQ(u32(headerEnd - 4), crc(0, headerEnd - 4));

  const size_t frame = headerEnd;
  EXPECT_EQ(text(frame, 4), "FRAM");
  EXPECT_EQ(u32(frame + 4), 0u);
  EXPECT_EQ(u64(frame + 8), 0u);
  EXPECT_EQ(u32(frame + 16), 0u);
  const size_t payloads = frame + 24 + 3 * 8 + 4;
  EXPECT_EQ(u32(payloads - 4), crc(frame, payloads - 4));
  EXPECT_EQ(u64(frame + 24), 0u) << "slice 0 is dark";
  size_t at = payloads;
  for (size_t i = 1; i < 3; ++i) {
    const uint32_t sizeAndKind = u32(frame + 24 + 8 * i);
    EXPECT_EQ(sizeAndKind % 4, 1u) << "whole";
    EXPECT_EQ(u32(at), 0xFD2FB528u) << "the magic number of a zstd frame (RFC 8878)";
    EXPECT_EQ(u32(frame + 24 + 8 * i + 4), crc(at, at + sizeAndKind / 4));
    at += sizeAndKind / 4;
  }
  EXPECT_EQ(u32(frame + 20), at - payloads);

  const size_t index = at;
  EXPECT_EQ(text(index, 4), "INDX");
  EXPECT_EQ(u32(index + 4), 1u);
  EXPECT_EQ(u64(index + 8), frame);
  EXPECT_EQ(u64(index + 16), 0u);
  EXPECT_EQ(u32(index + 24), 0u);
  EXPECT_EQ(u32(index + 28), crc(index, index + 28));
  EXPECT_EQ(text(index + 32, 4), "DONE");
  EXPECT_EQ(u64(index + 36), index);
  EXPECT_EQ(u32(index + 44), crc(index + 32, index + 44));
  EXPECT_EQ(index + 48, file.size());
}

TEST(SvolFile, unwritableOutputIsAWorkErrorAndLeavesNothing) {
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
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(SvolFile, metadataThatIsNoObjectIsAnInputErrorAndLeavesNothing) {
  const TemporaryFolder folder;
  const Volume volume(smallProfile(3, 17, 9));
  for (const char* metadata : {"", "[]", "{\"a\":", "\"text\""}) {
    EXPECT_THROW(writeSvol(folder / "a.svol", volume, metadata), InputError) << metadata;
  }
  std::string long_ = "{\"a\":\"";
  long_.append(svol::kMaxMetadataBytes, 'x');
  EXPECT_THROW(writeSvol(folder / "a.svol", volume, long_ + "\"}"), InputError);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

void expectProblem(const std::filesystem::path& path, const std::string& problem, size_t frame = 0) {
  try {
    readSvol(path, frame);
    FAIL() << path;
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(problem));
    EXPECT_THAT(error.what(), HasSubstr(path.string()));
  }
}

TEST(SvolFile, missingEmptyAndForeignFilesAreInputErrors) {
  const TemporaryFolder folder;
  expectProblem(folder / "missing.svol", "cannot open");
  expectProblem(folder.path(), "cannot open");
  expectProblem(folder.write("empty.svol", ""), "ends too soon");
  expectProblem(folder.write("text.svol", "This is a text of more than thirty-six bytes."), "no .svol file");
}

TEST(SvolFile, errorsNameTheFrameTheSliceAndTheByte) {
  const TemporaryFolder folder;
  const Volume volume = coloredTorus(smallProfile(3, 17, 9));
  writeSvol(folder / "a.svol", volume);
  expectProblem(folder / "a.svol", "there is no frame 1: the file has frame 0 alone", 1);
  std::vector<uint8_t> file = bytesOf(folder / "a.svol");
  const size_t index = file.size() - svol::indexBytes(1) - svol::kEndBytes;
  file[index - 1] ^= 1;
  const std::filesystem::path damaged = folder.write("b.svol", std::string(file.begin(), file.end()));
  expectProblem(damaged, "frame 0, slice 2: the checksum is wrong (in the record at byte ");
}

}  // namespace
}  // namespace ocelli
