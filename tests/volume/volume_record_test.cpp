#include "oc_core/volume/volume_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

VolumeRecord sampleRecord() {
  VolumeRecord record;
  record.grid.size = {2, 3, 4};
  record.grid.worldFromIndex = glm::dmat4(2);
  record.grid.worldFromIndex[3] = glm::dvec4(5, 6, 7, 1);
  record.grid.unit = "mm";
  record.grid.isAnatomical = true;
  record.type = VoxelType::kInt16;
  record.scale = 2;
  record.offset = -1024;
  record.file = "a.nrrd";
  record.begins = {100, 148};
  record.times = {0, 0.5};
  record.facts = {"CT", "HU", "NRRD"};
  record.warnings = {"beware"};
  return record;
}

std::vector<std::byte> bytesOfRecord(const VolumeRecord& record) {
  std::vector<std::byte> bytes;
  writeVolumeRecord(record,
                    [&](std::span<const std::byte> some) { bytes.insert(bytes.end(), some.begin(), some.end()); });
  return bytes;
}

TEST(VolumeRecord, ComesBackAsItWas) {
  const VolumeRecord record = volumeFromRecord(bytesOfRecord(sampleRecord()), "reader");
  const VolumeRecord expected = sampleRecord();
  EXPECT_EQ(record.grid.size, expected.grid.size);
  EXPECT_EQ(record.grid.worldFromIndex, expected.grid.worldFromIndex);
  EXPECT_EQ(record.grid.unit, "mm");
  EXPECT_TRUE(record.grid.isAnatomical);
  EXPECT_EQ(record.type, VoxelType::kInt16);
  EXPECT_EQ(record.scale, 2);
  EXPECT_EQ(record.offset, -1024);
  EXPECT_EQ(record.file, "a.nrrd");
  EXPECT_EQ(record.begins, expected.begins);
  EXPECT_EQ(record.times, expected.times);
  EXPECT_EQ(record.facts.valueUnit, "HU");
  EXPECT_EQ(record.warnings, expected.warnings);
  EXPECT_EQ(record.volumeBytes(), 48U);
}

TEST(VolumeRecord, ThrowsTheErrorThatTheReaderHad) {
  std::vector<std::byte> bytes;
  const ByteSink sink = [&](std::span<const std::byte> some) { bytes.insert(bytes.end(), some.begin(), some.end()); };
  const std::string message = InputError("two series", "folder", "choose one", "series 1\nseries 2").what();
  writeVolumeFailure(message, true, sink);
  EXPECT_THAT([&] { volumeFromRecord(bytes, "reader"); }, ThrowsMessage<InputError>(message));
  bytes.clear();
  writeVolumeFailure(WorkError("disk full", "/tmp", "free some space").what(), false, sink);
  EXPECT_THAT([&] { volumeFromRecord(bytes, "reader"); },
              ThrowsMessage<WorkError>("/tmp: disk full\n  try: free some space"));
}

TEST(VolumeRecord, RefusesWhatIsNone) {
  const std::vector<std::byte> sound = bytesOfRecord(sampleRecord());
  for (size_t size = 0; size < sound.size(); ++size) {
    EXPECT_THAT(
        [&] { volumeFromRecord(std::span(sound).first(size), "reader"); },
        ThrowsMessage<WorkError>(HasSubstr("reader: the program that reads volume files gave back what is no volume")))
        << size;
  }
  const auto refuses = [](const auto& change) {
    VolumeRecord record = sampleRecord();
    change(record);
    EXPECT_THROW(volumeFromRecord(bytesOfRecord(record), "reader"), WorkError);
  };
  refuses([](VolumeRecord& record) { record.grid.size.y = 0; });
  refuses([](VolumeRecord& record) { record.scale = 0; });
  refuses([](VolumeRecord& record) { record.grid.size.y = VolumeRecord::kMaxEdge + 1; });
  refuses([](VolumeRecord& record) { record.grid.worldFromIndex[0] = record.grid.worldFromIndex[1]; });
  refuses([](VolumeRecord& record) { record.grid.worldFromIndex[0].w = 1; });
  refuses([](VolumeRecord& record) { record.scale = std::numeric_limits<double>::quiet_NaN(); });
  refuses([](VolumeRecord& record) { record.begins = {}; });
  refuses([](VolumeRecord& record) { record.begins[0] = 101; });
  refuses([](VolumeRecord& record) { record.times = {1}; });
  refuses([](VolumeRecord& record) { record.times = {1, 1}; });
  std::vector<std::byte> more = sound;
  more.push_back(std::byte{0});
  EXPECT_THROW(volumeFromRecord(more, "reader"), WorkError);
}

}  // namespace
}  // namespace ocelli
