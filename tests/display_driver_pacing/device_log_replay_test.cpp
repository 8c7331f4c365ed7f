// A device with a log, and the log on another device.
#include <gtest/gtest.h>

#include <map>
#include <mutex>
#include <string>
#include <thread>

#include "display_driver/device/file_device.h"
#include "display_driver/device/null_device.h"
#include "display_driver/pacing/device_log_player.h"
#include "display_driver/pacing/recording_device.h"
#include "display_sim/frames/svol_player.h"
#include "oc_core/base/error.h"
#include "tests/base/temporary_folder.h"
#include "tests/display_driver_pacing/device_log_cases.h"
#include "tests/display_driver_pacing/virtual_display.h"

namespace ocelli {
namespace {

using namespace std::chrono_literals;

/// A refresh takes 5 ms.
DisplayProfile fastProfile() {
  DisplayProfile profile = smallProfile(6);
  profile.rotationsPerMinute = 6000;
  return profile;
}

std::vector<Volume> someVolumes(const DisplayProfile& profile) {
  std::vector<Volume> volumes;
  for (uint64_t i = 0; i < 8; ++i) {
    volumes.push_back(i % 3 == 2 ? volumes.back() : madeVolume(profile, i, i % 2 == 0 ? 0.02 : 0.4));
    if (i % 3 == 2) {
      volumes.back().light(static_cast<int>(i % 6), 5, 5, 7);
    }
  }
  return volumes;
}

/// Keeps what it gets, and when.
class KeepingDevice final : public Device {
 public:
  KeepingDevice(PaceClock& clock, const DisplayProfile& profile) : clock_(clock), profile_(profile) {}
  const DeviceInfo& info() const override { return info_; }
  const DisplayProfile& profile() const override { return profile_; }
  void present(FrameNumber frame, const Presentation& presentation) override {
    presented.push_back({frame, presentation});
    fences_.at(frame)->moveTo({.stage = FrameStage::kShown});
  }
  Telemetry telemetry() override { return {}; }
  void close() override {}

  std::vector<Volume> volumes;
  std::vector<HostTime> times;
  std::vector<std::pair<FrameNumber, Presentation>> presented;

 protected:
  std::shared_ptr<const FrameFence> submitFrame(std::shared_ptr<const Volume> volume,
                                                std::optional<std::span<const int>>) override {
    volumes.push_back(*volume);
    times.push_back(clock_.now());
    const auto number = static_cast<FrameNumber>(volumes.size());
    return fences_[number] = std::make_shared<FrameFence>(number);
  }

 private:
  PaceClock& clock_;
  DisplayProfile profile_;
  DeviceInfo info_;
  std::map<FrameNumber, std::shared_ptr<FrameFence>> fences_;
};

TEST(DeviceLogReplayTest, allThatPassesIsWrittenDown) {
  const test::TemporaryFolder folder;
  std::vector<Volume> volumes = someVolumes(fastProfile());
  volumes.erase(volumes.begin() + 4,
                volumes.end());  // as many as may wait to be written, so that no machine is too slow
  {
    const auto device = recordDeviceLog(openNullDevice(fastProfile()), folder / "a.session");
    EXPECT_EQ(device->info().kind, "null");
    for (const Volume& volume : volumes) {
      const auto fence = device->submit(volume);
      device->present(fence->number(), {.tearWhenLate = true});
      EXPECT_EQ(fence->wait(FrameStage::kShown, 30s).stage, FrameStage::kShown);
      EXPECT_TRUE(device->telemetry().connected);
    }
    device->close();
  }
  DeviceLogReader reader(folder / "a.session");
  EXPECT_EQ(reader.device().kind, "null");
  const test::DeviceLogContent content = test::readAll(reader);
  EXPECT_EQ(content.ending, RecordingEnding::kFinished);
  EXPECT_EQ(content.volumes, volumes);
  size_t presented = 0;
  size_t shown = 0;
  size_t told = 0;
  for (const DeviceLogRecord& record : content.records) {
    if (const auto* presentation = std::get_if<DeviceLogRecord::Presented>(&record.what)) {
      EXPECT_TRUE(presentation->presentation.tearWhenLate);
      ++presented;
    } else if (const auto* ended = std::get_if<DeviceLogRecord::Ended>(&record.what)) {
      shown += ended->state.stage == FrameStage::kShown ? 1 : 0;
      EXPECT_GE(ended->state.shown, ended->state.sent);
    } else if (std::holds_alternative<Telemetry>(record.what)) {
      ++told;
    }
  }
  EXPECT_EQ(presented, volumes.size());
  EXPECT_EQ(shown, volumes.size());
  EXPECT_GE(told, 1u);
}

TEST(DeviceLogReplayTest, anotherDeviceGetsTheSameBytesAtTheSameTimes) {
  const test::TemporaryFolder folder;
  test::writeDeviceLog(folder / "a.session");
  DeviceLogReader reader(folder / "a.session");
  test::VirtualClock clock;
  KeepingDevice device(clock, reader.profile());
  const HostTime begin = clock.now();
  const DeviceLogPlayed played = playDeviceLog(reader, device, clock);
  EXPECT_EQ(device.volumes, test::deviceLogVolumes());
  EXPECT_EQ(played.submitted, 4u);
  EXPECT_EQ(played.presented, 4u);
  EXPECT_EQ(played.shown, 4u);
  EXPECT_EQ(played.ending, RecordingEnding::kFinished);
  for (size_t i = 0; i < device.times.size(); ++i) {
    EXPECT_EQ(device.times[i] - begin, std::chrono::milliseconds(i + 1));
  }
  // It does not tell its rotation: frames are shown with the next refresh.
  EXPECT_FALSE(device.presented[0].second.at);
  EXPECT_TRUE(device.presented[2].second.tearWhenLate);
}

TEST(DeviceLogReplayTest, phasesAreCarriedOverToTheDevicesOwnCount) {
  const test::TemporaryFolder folder;
  const DisplayProfile profile = loadProfile("test");  // 24 refreshes a second
  {
    const HostTime opened(1h);
    DeviceLogWriter writer(folder / "a.session", {.kind = "usb", .name = {}, .serial = {}, .link = {}}, profile);
    Telemetry telemetry;
    // The recorded screen was at refresh 5000 after half a second, so a second after it at 5024.
    telemetry.rotation = RotationReading{opened + 500ms, 5000, 0, 1.0 / 24};
    writer.told(telemetry, opened, 500ms);
    writer.submitted(1, madeVolume(profile, 1), std::nullopt, 1400ms);
    writer.presented(1, {.at = RotationPhase{5024, 3}}, 1400ms);
    writer.finish(1600ms);
  }
  DeviceLogReader reader(folder / "a.session");
  test::VirtualClock clock;
  test::VirtualDisplay display(clock, {});  // at refresh 0 now
  const DeviceLogPlayed played = playDeviceLog(reader, display, clock);
  EXPECT_EQ(played.shown, 1u);
  // After 1.5 s it is at 36; shown there, at the third slice.
  const RotationPhase at = display.lastShownAt;
  EXPECT_EQ(at, (RotationPhase{36, 3}));
}

TEST(DeviceLogReplayTest, asFastAsItGoesEveryFrameIsShown) {
  const test::TemporaryFolder folder;
  const std::vector<Volume> volumes = someVolumes(fastProfile());
  {
    DeviceLogWriter writer(folder / "a.session", {.kind = "sim", .name = {}, .serial = {}, .link = {}}, fastProfile());
    for (uint32_t i = 0; i < volumes.size(); ++i) {
      writer.submitted(i + 1, volumes[i], std::nullopt, 1min * i);
      writer.presented(i + 1, {}, 1min * i);
    }
    writer.finish(1h);
  }
  DeviceLogReader reader(folder / "a.session");
  const auto device = openFileDevice(folder / "shown.svol", fastProfile());
  const DeviceLogPlayed played = playDeviceLog(reader, *device, realClock(), {.fast = true});
  device->close();
  EXPECT_EQ(played.shown, volumes.size());
  SvolReader shown(folder / "shown.svol");
  ASSERT_EQ(shown.frames().size(), volumes.size());
  SvolPlayer player(shown);
  for (size_t i = 0; i < volumes.size(); ++i) {
    player.seek(i);
    EXPECT_EQ(player.volume(), volumes[i]) << i;
  }
}

TEST(DeviceLogReplayTest, threadsMaySubmitFasterThanTheDiskAndWhatIsWrittenIsRight) {
  const test::TemporaryFolder folder;
  constexpr int kFrames = 30;
  std::map<FrameNumber, uint64_t> seeds;
  std::string told;
  {
    const auto device = recordDeviceLog(openNullDevice(fastProfile()), folder / "a.session",
                                        [&](const std::string& what) { told += what; });
    std::mutex mutex;
    std::vector<std::thread> threads;
    for (uint64_t seed = 0; seed < 3; ++seed) {
      threads.emplace_back([&, seed] {
        const Volume volume = madeVolume(fastProfile(), seed);
        for (int i = 0; i < kFrames; ++i) {
          const FrameNumber frame = device->submit(volume)->number();
          device->present(frame, {});
          device->telemetry();
          const std::lock_guard lock(mutex);
          seeds[frame] = seed;
        }
      });
    }
    for (std::thread& thread : threads) {
      thread.join();
    }
    device->close();
  }
  DeviceLogReader reader(folder / "a.session");
  size_t written = 0;
  size_t ended = 0;
  while (const auto record = reader.next()) {
    if (const auto* submitted = std::get_if<DeviceLogRecord::Submitted>(&record->what)) {
      EXPECT_EQ(*submitted->volume, madeVolume(fastProfile(), seeds.at(submitted->frame))) << submitted->frame;
      ++written;
    }
    ended += std::holds_alternative<DeviceLogRecord::Ended>(record->what) ? 1 : 0;
  }
  EXPECT_EQ(reader.ending(), RecordingEnding::kFinished);
  EXPECT_GE(written, 1u);
  // Also what became of those that were left out.
  EXPECT_EQ(ended, 3u * kFrames);
  EXPECT_EQ(told.empty() ? 0 : std::stoul(told), 3u * kFrames - written);
}

TEST(DeviceLogReplayTest, aDiskThatIsFullIsSaid) {
  EXPECT_THROW(recordDeviceLog(openNullDevice(fastProfile()), "/dev/full"), WorkError);
}

}  // namespace
}  // namespace ocelli
