#include "oc_core/volume/import/voxel_output.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>

#include "oc_core/base/error.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using test::fileBytes;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

template <class Number>
std::string bytesOfNumbers(const std::vector<Number>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

VolumeRecord recordOf(const glm::ivec3& size) {
  VolumeRecord record;
  record.grid.size = size;
  return record;
}

TEST(VoxelWriter, TakesPiecesOfAnySize) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.write("scratch", "");
  ScratchOutput scratch(path, folder.path(), nullptr);
  VolumeRecord record = recordOf({2, 1, 1});
  VoxelWriter writer(record, 2, StoredType::kInt16, true, scratch);
  const std::string stored = "badcfehg";
  for (const std::string& piece : {stored.substr(0, 1), stored.substr(1, 4), stored.substr(5)}) {
    writer.append(std::as_bytes(std::span(piece)), "a");
  }
  writer.finish("a");
  EXPECT_EQ(fileBytes(path), "abcdefgh");
  EXPECT_THAT(record.begins, ElementsAre(0, 4));
  EXPECT_EQ(record.type, VoxelType::kInt16);
}

TEST(VoxelWriter, MakesFloat64OfWhatIsExact) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.write("scratch", "");
  ScratchOutput scratch(path, folder.path(), nullptr);
  VolumeRecord record = recordOf({2, 1, 1});
  VoxelWriter writer(record, 1, StoredType::kInt64, false, scratch);
  const std::string stored = bytesOfNumbers<int64_t>({-3, int64_t{1} << 53U});
  writer.append(std::as_bytes(std::span(stored)), "a");
  EXPECT_EQ(fileBytes(path), bytesOfNumbers<double>({-3, 9007199254740992.0}));

  ScratchOutput other("", "", nullptr);
  VoxelWriter failing(record, 1, StoredType::kUint64, false, other);
  const std::string large = bytesOfNumbers<uint64_t>({(uint64_t{1} << 53U) + 1});
  EXPECT_THAT([&] { failing.append(std::as_bytes(std::span(large)), "a.nrrd"); },
              ThrowsMessage<InputError>(HasSubstr("a.nrrd: a voxel of 64 bits is 9007199254740993")));
}

TEST(VoxelWriter, SaysHowManyAreMissing) {
  ScratchOutput scratch("", "", nullptr);
  VolumeRecord record = recordOf({2, 2, 2});
  const VoxelWriter writer(record, 1, StoredType::kUint8, false, scratch);
  EXPECT_THAT([&] { writer.finish("a.mha"); },
              ThrowsMessage<InputError>(HasSubstr("a.mha: the file has 0 bytes of voxels, 8 fewer")));
}

TEST(PlaceVoxels, RefusesWhatCompressedBytesCannotHold) {
  const std::string bytes = "abc";
  const MemorySource source(std::as_bytes(std::span(bytes)), "a.nii.gz");
  ScratchOutput scratch("", "", nullptr);
  VolumeRecord record = recordOf({1000, 1000, 1000});
  EXPECT_THAT(
      [&] {
        placeVoxels(record, 1, {StoredType::kUint8, false, 0, true}, source, "a", scratch);
      },
      ThrowsMessage<InputError>(HasSubstr("far more than 3 compressed bytes can hold")));
}

TEST(PlaceVoxels, CopiesHolesAsHoles) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.write("sparse", "x");
  constexpr off_t kBytes = off_t{1} << 30U;
  ASSERT_EQ(truncate(path.c_str(), kBytes + 1), 0);
  const FileSource source(path, nullptr);
  if (source.storedBytes() > 1 << 20) {
    GTEST_SKIP() << "no sparse files here";
  }
  const std::filesystem::path scratchPath = folder.write("scratch", "");
  ScratchOutput scratch(scratchPath, folder.path(), nullptr);
  VolumeRecord record = recordOf({1024, 1024, 512});
  placeVoxels(record, 1, {StoredType::kInt16, false, 1}, source, path.string(), scratch);
  EXPECT_EQ(record.file, "");
  const FileSource made(scratchPath, nullptr);
  EXPECT_EQ(made.size(), static_cast<uint64_t>(kBytes));
  EXPECT_LT(made.storedBytes(), uint64_t{1} << 21U);
}

TEST(ScratchOutput, SaysWhereTheDiskIsFull) {
  const TemporaryFolder folder;
  ScratchOutput scratch(folder.write("scratch", ""), folder.path(), nullptr);
  EXPECT_THAT([&] { scratch.expect(uint64_t{1} << 60U); },
              ThrowsMessage<WorkError>(testing::AllOf(HasSubstr(folder.path().string()), HasSubstr("TMPDIR"))));
}

}  // namespace
}  // namespace ocelli
