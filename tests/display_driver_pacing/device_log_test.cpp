// Device logs: what was written is read, whatever was cut off or changed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "tests/base/temporary_folder.h"
#include "tests/display_driver_pacing/device_log_cases.h"
#include "tests/display_driver_pacing/device_log_repair.h"

namespace ocelli {
namespace {

using testing::ElementsAre;

class DeviceLogTest : public testing::Test {
 protected:
  void SetUp() override {
    test::writeDeviceLog(folder / "a.session");
    bytes = test::fileBytes(folder / "a.session");
    DeviceLogReader reader(folder / "a.session");
    whole = test::readAll(reader);
  }

  test::TemporaryFolder folder;
  std::string bytes;
  test::DeviceLogContent whole;
};

TEST_F(DeviceLogTest, whatWasWrittenIsRead) {
  DeviceLogReader reader(folder / "a.session");
  EXPECT_EQ(reader.device().kind, "sim");
  EXPECT_EQ(reader.device().name, "a \"name\"");
  EXPECT_EQ(reader.device().serial, "7");
  EXPECT_EQ(reader.device().link, "memory");
  EXPECT_EQ(reader.profile(), smallProfile(5));
  EXPECT_EQ(whole.ending, RecordingEnding::kFinished);
  EXPECT_EQ(whole.volumes, test::deviceLogVolumes());
  EXPECT_THAT(
      test::describe(whole),
      ElementsAre("600 told 0", "1000 submitted 1", "1010 presented 1 at 110", "1050 ended 1 3", "2000 submitted 2",
                  "2010 presented 2 next", "2050 ended 2 4", "3000 submitted 3", "3010 presented 3 at 112",
                  "3050 ended 3 3", "4000 submitted 4", "4010 presented 4 next", "4050 ended 4 3"));
  const auto& changed = [&](size_t record) {
    return std::get<DeviceLogRecord::Submitted>(whole.records[record].what).changed;
  };
  EXPECT_THAT(changed(4), ElementsAre(2));
  EXPECT_THAT(changed(10), ElementsAre());
  const auto& third = std::get<DeviceLogRecord::Presented>(whole.records[8].what).presentation;
  EXPECT_EQ(third.at, (RotationPhase{112, 2}));
  EXPECT_TRUE(third.tearWhenLate);
  EXPECT_FALSE(third.coarseWhenLate);
  const auto& shown = std::get<DeviceLogRecord::Ended>(whole.records[3].what).state;
  EXPECT_EQ(shown.sent, HostTime(std::chrono::microseconds(1020)));
  EXPECT_EQ(shown.arrived, HostTime(std::chrono::microseconds(1030)));
  EXPECT_EQ(shown.shown, HostTime(std::chrono::microseconds(1040)));
  EXPECT_EQ(shown.shownRefresh, 110u);
  EXPECT_EQ(std::get<DeviceLogRecord::Ended>(whole.records[6].what).state.problem, "a newer\none");
  const auto& told = std::get<Telemetry>(whole.records[0].what);
  EXPECT_EQ(told.rotation->time, HostTime(std::chrono::microseconds(500)));
  EXPECT_EQ(told.rotation->share, 0.25);
  EXPECT_EQ(told.temperatureCelsius, 40.5);
}

/// The records and volumes of a part of the log are the first ones of the whole.
void expectBegin(const test::DeviceLogContent& part, const test::DeviceLogContent& whole, size_t at) {
  const std::vector<std::string> expected = test::describe(whole);
  const std::vector<std::string> found = test::describe(part);
  ASSERT_LE(found.size(), expected.size()) << at;
  EXPECT_TRUE(std::equal(found.begin(), found.end(), expected.begin())) << at;
  ASSERT_LE(part.volumes.size(), whole.volumes.size());
  EXPECT_TRUE(std::equal(part.volumes.begin(), part.volumes.end(), whole.volumes.begin())) << at;
}

TEST_F(DeviceLogTest, whereverItIsCutTheRecordsBeforeAreRead) {
  size_t before = 0;
  for (size_t length = 0; length < bytes.size(); ++length) {
    std::istringstream in(bytes.substr(0, length));
    try {
      DeviceLogReader reader(in, "cut");
      const test::DeviceLogContent part = test::readAll(reader);
      EXPECT_EQ(part.ending, RecordingEnding::kUnfinished) << length;
      expectBegin(part, whole, length);
      EXPECT_GE(part.records.size(), before) << length;
      before = part.records.size();
    } catch (const InputError&) {
      EXPECT_EQ(before, 0u) << length;  // within the header or the opening
    }
  }
  EXPECT_EQ(before, whole.records.size());
}

TEST_F(DeviceLogTest, anyFlippedBitIsFound) {
  for (size_t bit = 0; bit < 8 * bytes.size(); bit += 37) {
    std::string damaged = bytes;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
    std::istringstream in(damaged);
    try {
      DeviceLogReader reader(in, "flipped");
      const test::DeviceLogContent part = test::readAll(reader);
      EXPECT_NE(part.ending, RecordingEnding::kFinished) << bit / 8;
      expectBegin(part, whole, bit / 8);
      EXPECT_EQ(part.ending == RecordingEnding::kDamaged, reader.damage().has_value());
    } catch (const InputError&) {
      // The header or the opening.
    }
  }
}

/// Behind checksums that fit, too, only volumes of the display come out, or damage.
TEST_F(DeviceLogTest, bytesThatAreWrongBehindRightChecksumsDoNoHarm) {
  size_t damaged = 0;
  for (size_t byte = device_log::kHeaderBytes; byte < bytes.size(); byte += 5) {
    std::vector<uint8_t> changed(bytes.begin(), bytes.end());
    changed[byte] ^= 0x41;
    test::repairDeviceLogChecksums(changed);
    std::istringstream in(std::string(changed.begin(), changed.end()));
    try {
      DeviceLogReader reader(in, "changed", size_t{1} << 20);
      const test::DeviceLogContent content = test::readAll(reader);
      damaged += content.ending == RecordingEnding::kDamaged ? 1 : 0;
    } catch (const InputError&) {
      // The opening.
    }
  }
  EXPECT_GT(damaged, 50u);
}

TEST_F(DeviceLogTest, errorsNameFileAndPlace) {
  std::string damaged = bytes;
  damaged[bytes.size() - 40] ^= 1;
  const auto path = folder.write("damaged.session", damaged);
  DeviceLogReader reader(path);
  test::readAll(reader);
  ASSERT_TRUE(reader.damage());
  EXPECT_THAT(reader.damage()->what(),
              testing::AllOf(testing::HasSubstr("damaged.session"), testing::HasSubstr("byte ")));
}

TEST_F(DeviceLogTest, otherFilesAreRefused) {
  EXPECT_THROW(DeviceLogReader(folder / "none.session"), InputError);
  EXPECT_THROW(DeviceLogReader(folder.write("empty.session", "")), InputError);
  EXPECT_THROW(DeviceLogReader(folder.write("text.session", "this is no session, but long enough to be one")),
               InputError);
  std::istringstream in(bytes);
  EXPECT_THROW(DeviceLogReader(in, "large", 100), InputError);
}

}  // namespace
}  // namespace ocelli
